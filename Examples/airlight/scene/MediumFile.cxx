// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/MediumFile.h"

#include "formats/Files.h"
#include "formats/ModelReader.h"
#include "formats/UserError.h"
#include "formats/VTKMessages.h"

#include <vtkDelimitedTextReader.h>
#include <vtkNew.h>
#include <vtkParticipatingMedium.h>
#include <vtkTable.h>
#include <vtkVariant.h>

#include <algorithm>

namespace airlight
{

namespace
{
bool IsNumber(const vtkVariant& value)
{
  bool valid = false;
  value.ToDouble(&valid);
  return valid;
}

// Headings name both columns: a first line with one number in it is data gone wrong.
bool HasHeading(vtkTable* table)
{
  return table->GetNumberOfRows() > 0 && table->GetNumberOfColumns() >= 2 &&
    !IsNumber(table->GetValue(0, 0)) && !IsNumber(table->GetValue(0, 1));
}

// Throw what the medium said, without its own name for the thing and what it does about it.
void FailOn(const VTKMessages& messages, const std::string& fileName, const std::string& before,
  const std::string& after)
{
  std::string text = messages.GetFirstError();
  if (text.empty())
  {
    return;
  }
  const std::size_t begin = text.find(before);
  text.erase(0, begin == std::string::npos ? 0 : begin + before.size());
  text.erase(std::min(text.find(after), text.size()));
  throw UserError(fileName + ": " + text);
}
}

//------------------------------------------------------------------------------
void ReadPhaseTable(const std::string& fileName, vtkParticipatingMedium* medium)
{
  CheckInputFile(fileName);
  const VTKMessages messages;
  vtkNew<vtkDelimitedTextReader> reader;
  reader->SetFileName(fileName.c_str());
  reader->SetFieldDelimiterCharacters(",");
  reader->SetHaveHeaders(false);
  reader->Update();
  vtkTable* table = reader->GetOutput();
  FailOn(messages, fileName, "", "\n");
  const bool heading = HasHeading(table);
  if (heading)
  {
    table->RemoveRow(0);
  }
  medium->SetPhaseFunctionToTabulated();
  medium->SetPhaseTable(table);
  FailOn(messages, fileName, "PhaseTable ", ". The old table stays");
}

//------------------------------------------------------------------------------
void ReadMediumSurface(const std::string& fileName, vtkParticipatingMedium* medium)
{
  const auto mesh = ReadMesh(fileName);
  const VTKMessages messages;
  medium->SetRegionToSurface();
  medium->SetSurface(mesh);
  FailOn(messages, fileName, "The surface ", ". The old surface stays");
}

}
