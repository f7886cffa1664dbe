// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "formats/PhotometryFile.h"

#include "formats/Files.h"
#include "formats/UserError.h"
#include "formats/VTKMessages.h"

#include <vtkAirlightPass.h>
#include <vtkLight.h>
#include <vtkNew.h>

namespace airlight
{

//------------------------------------------------------------------------------
void CheckPhotometryFile(const std::string& fileName)
{
  CheckInputFile(fileName);
  const VTKMessages messages;
  vtkNew<vtkLight> light;
  vtkNew<vtkAirlightPass> pass;
  if (!pass->SetLightPhotometry(light, fileName.c_str()))
  {
    const std::string text = messages.GetFirstError();
    const std::size_t begin = text.find(fileName); // behind what the pass does about it
    throw UserError(begin == std::string::npos ? fileName + ": " + text : text.substr(begin));
  }
}

}
