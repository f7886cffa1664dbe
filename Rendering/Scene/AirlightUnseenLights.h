// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Lights that vtkAirlightLight::SetVisible() was called for, and that no picture shows.
 */

#ifndef AirlightUnseenLights_h
#define AirlightUnseenLights_h

#include "Scene/AirlightSceneLights.h"

#include <string>
#include <vector>

class vtkCamera;
class vtkParticipatingMedium;

namespace airlight
{
enum class UnseenReason
{
  None,
  NoExtent,
  FixedToCamera,
  ParallelProjection,
  UnboundedMedium,
  TooManySuns
};

// Light, reason and remedy.
struct UnseenLight
{
  UnseenReason Reason;
  std::string Text;
};

// Places from which a lamp is not seen, as outside a spotlight's cone, are no reason.
std::vector<UnseenLight> FindUnseenLights(const std::vector<SceneLight>& lights, vtkCamera* camera,
  const std::vector<vtkParticipatingMedium*>& media);
}

#endif
