// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What vtkAirlightReference was given.
 */

#ifndef vtkAirlightReferenceInternals_h
#define vtkAirlightReferenceInternals_h

#include "AirlightMediaList.h"
#include "vtkAirlightReference.h"

#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <vector>

class vtkAirlightReference::Internals
{
public:
  // Forgets lights that are gone.
  std::vector<vtkWeakPointer<vtkLight>>& GetQuiet()
  {
    this->Quiet.erase(std::remove_if(this->Quiet.begin(), this->Quiet.end(),
                        [](const vtkWeakPointer<vtkLight>& light) { return !light; }),
      this->Quiet.end());
    return this->Quiet;
  }

  airlight::MediaList Media;
  vtkNew<vtkParticipatingMedium> Vacuum;
  vtkSmartPointer<vtkRenderer> Renderer;

private:
  std::vector<vtkWeakPointer<vtkLight>> Quiet; // those that the medium does not scatter
};

#endif
