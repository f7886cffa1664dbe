// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Media, lights, passes and actors by random calls, good ones and bad ones.
 */

#ifndef AirlightFuzzScene_h
#define AirlightFuzzScene_h

#include "AirlightFuzzData.h"

#include "vtkSmartPointer.h"

class vtkActor;
class vtkAirlightPass;
class vtkLight;
class vtkParticipatingMedium;

namespace airlight_fuzz
{
// One call of one of the setters.
void ChangeMedium(Input& input, vtkParticipatingMedium* medium);
void ChangeLight(Input& input, vtkLight* light);
void ChangePass(
  Input& input, vtkAirlightPass* pass, vtkParticipatingMedium* medium, vtkLight* light);

// A mesh that is placed, coloured and shown in one way or another.
vtkSmartPointer<vtkActor> MakeActor(Input& input);
}

#endif
