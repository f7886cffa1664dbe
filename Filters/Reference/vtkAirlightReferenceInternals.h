// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What vtkAirlightReference was given.
 */

#ifndef vtkAirlightReferenceInternals_h
#define vtkAirlightReferenceInternals_h

#include "Medium/AirlightMediaList.h"
#include "Photometry/AirlightLightSwitches.h"
#include "vtkAirlightReference.h"

#include "vtkNew.h"
#include "vtkParticipatingMedium.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

class vtkAirlightReference::Internals
{
public:
  airlight::MediaList Media;
  vtkNew<vtkParticipatingMedium> Vacuum;
  airlight::LightSwitches Switches;
  bool WarnedCameraLights = false;
  vtkSmartPointer<vtkRenderer> Renderer;
};

#endif
