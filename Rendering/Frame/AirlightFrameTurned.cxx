// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Airlight by AirlightTurn.glsl, in a step of its own or where the picture is put together.

#include "Frame/AirlightFrame.h"

#include "AirlightConstants.h"
#include "AirlightNoPackedBoundaries.h"
#include "AirlightResolveOutputs.h"
#include "AirlightShadowCounts.h"
#include "AirlightTurn.h"
#include "AirlightTurnPart.h"
#include "AirlightTurnWhole.h"
#include "AirlightTurnedFS.h"
#include "AirlightTurnedRay.h"
#include "Integration/AirlightIntegrate.h"

#include "vtkShaderProgram.h"

#include <algorithm>

namespace
{
// AirlightConstants.glsl has some of both from elsewhere.
const char* GlobalMedia = "uniform AirlightMedia givenMedia;\nAirlightMedia media;\n";
const char* GlobalLight = "uniform AirlightLight givenLight;\nAirlightLight light;\n";
}

namespace airlight
{
//------------------------------------------------------------------------------
// Whether a light has the closed form, and an integrand that is as smooth as its phase function's
// poles make it.
bool Frame::IsTurned(int index, Lists lists) const
{
  const f64::AirlightPhase& phase = this->Media.item[0].phase;
  return this->Lamps[index].Values.kind == AIRLIGHT_POINT_CLOSED && phase.rows == 0 &&
    phase.power.x <= 0.0 && !this->TransmitsShadows && lists != Lists::Map &&
    (lists == Lists::None || this->Boundaries.HasKBuffer());
}

//------------------------------------------------------------------------------
bool Frame::AreTurned(const std::vector<int>& lights) const
{
  return !lights.empty() && std::all_of(lights.begin(), lights.end(), [this](int k) {
    return this->IsTurned(k, Lists::None);
  });
}

//------------------------------------------------------------------------------
std::string Frame::GetTurnSource()
{
  return std::string(GlobalMedia) + AirlightTurn + AirlightTurnPart + AirlightTurnWhole +
    AirlightConstants;
}

//------------------------------------------------------------------------------
std::string Frame::GetTurnedSource(int index, Lists lists) const
{
  const bool planes = lists != Lists::None;
  return this->GetResolveHead(index, planes) + GlobalLight + GetTurnSource() +
    AirlightShadowCounts +
    (planes ? this->Boundaries.GetPackedSource(lists != Lists::Short)
            : AirlightNoPackedBoundaries) +
    AirlightTurnedRay + AirlightResolveOutputs + AirlightTurnedFS;
}

//------------------------------------------------------------------------------
// As AirlightConstants.glsl takes them.
void Frame::SetTurnedConstants(vtkShaderProgram* program, const std::vector<int>& lights)
{
  const f64::AirlightMedium& medium = this->Media.item[0];
  std::vector<glm::vec4> constants;
  for (int k : lights)
  {
    const f64::AirlightLight& light = this->Lamps[k].Values;
    const CameraUniforms::LightPixel pixel = this->Rays->GetLightPixel(light.position);
    constants.insert(constants.end(),
      { glm::vec4(light.position, light.radius),
        glm::vec4(light.intensity * medium.sigmaS, medium.phase.pole[0].y),
        glm::vec4(medium.sigmaT, pixel.IsNear ? 1.0 : 0.0), glm::vec4(pixel.Whole, pixel.Rest),
        glm::vec4(pixel.PerX, 0.0f), glm::vec4(pixel.PerY, 0.0f) });
  }
  program->SetUniform4fv("airlightConstants", static_cast<int>(constants.size()), &constants[0].x);
}

}
