// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The lights of a random scene.

#include "FrameScene.h"

#include "RandomParts.h"

#include "vtkAirlight.h"

namespace airlight_test
{
//------------------------------------------------------------------------------
void FrameScene::SetLightColour(vtkLight* light, int kind, Random& random)
{
  const double green = random.Index(8) ? random.LogUniform(0.3, 30.0) : 0.0;
  const double dark = random.Index(12) ? 1.0 : 0.0; // a light without power
  const glm::dvec3 colour(dark * random.LogUniform(0.3, 30.0), dark * green, dark * 5.0);
  const glm::dvec3 power = this->Unit * this->Unit * colour;
  if (kind == FRAME_SUN || kind == FRAME_HEADLIGHT || kind == FRAME_CAMERA_SUN)
  {
    vtkAirlight::SetIrradiance(light, &colour.x);
  }
  else
  {
    vtkAirlight::SetRadiantIntensity(light, &power.x);
  }
  if (kind == FRAME_SPOT || kind == FRAME_SOFT_SPOT)
  {
    light->SetConeAngle(random.Index(8) ? random.Uniform(3.0, 85.0) : 89.9);
  }
  light->SetExponent(kind == FRAME_SOFT_SPOT ? random.Uniform(0.5, 8.0) : 0.0);
  if (kind == FRAME_ATTENUATED)
  {
    const double u = 1.0 / this->Unit;
    const double square = random.Index(3) ? random.Uniform(0.1, 2.0) : 0.0;
    const double linear = random.Uniform(0.05, 1.0);
    light->SetAttenuationValues(random.Index(2) ? 0.3 : 0.0, linear * u, square * u * u);
    light->SetIntensity(1.0);
    light->SetColor(1.0, green > 0.0 ? 0.5 : 0.0, 0.2);
  }
}

//------------------------------------------------------------------------------
void FrameScene::PlaceLight(vtkLight* light, int kind, Random& random)
{
  glm::dvec3 position = RandomPoint(random, random.Index(4) ? 3.0 : 30.0);
  glm::dvec3 aim = RandomPoint(random, 1.0);
  const int place = random.Index(10);
  if (place == 0) // at the eye
  {
    this->Renderer->GetActiveCamera()->GetPosition(&position.x);
    position /= this->Unit;
  }
  else if (place == 1) // on whole numbers, straight above
  {
    position = glm::dvec3(0.0, 2.0, 0.0);
    aim = glm::dvec3(0.0);
  }
  const bool camera = light->LightTypeIsCameraLight();
  if (camera)
  {
    position = RandomPoint(random, 1.0) + glm::dvec3(0.0, 0.0, 1.0);
  }
  const double scale = camera ? 1.0 : this->Unit;
  light->SetPosition(scale * position.x, scale * position.y, scale * position.z);
  light->SetFocalPoint(scale * aim.x, scale * aim.y, scale * aim.z);
  this->Note(GetFrameLightName(kind), " at ", Text3(&position.x), " to ", Text3(&aim.x));
}

//------------------------------------------------------------------------------
void FrameScene::AddLights(Random& random)
{
  for (int kind : this->Group.Lights)
  {
    vtkNew<vtkLight> light;
    this->SetLightColour(light, kind, random);
    switch (kind)
    {
      case FRAME_HEADLIGHT:
      case FRAME_HEADLAMP:
        light->SetLightTypeToHeadlight();
        break;
      case FRAME_CAMERA:
      case FRAME_CAMERA_SUN:
        light->SetLightTypeToCameraLight();
        break;
      default:
        light->SetLightTypeToSceneLight();
    }
    this->Pass->SetLightScatters(light, true); // those that are fixed to the camera, too
    this->PlaceLight(light, kind, random);
    if (kind == FRAME_PHOTOMETRIC)
    {
      static const char* const files[] = { "downlight", "lowbeam", "streetlight", "tube" };
      const std::string file = this->Photometry + "/" + files[random.Index(4)] + ".ies";
      this->Pass->SetLightPhotometry(light, file.c_str());
    }
    this->Renderer->AddLight(light);
    this->Lights.emplace_back(light);
  }
}

//------------------------------------------------------------------------------
void FrameScene::ChangeLight(Random& random)
{
  if (this->Lights.empty())
  {
    return;
  }
  const size_t index = static_cast<size_t>(random.Index(static_cast<int>(this->Lights.size())));
  const int kind = this->Group.Lights[index];
  vtkLight* light = this->Lights[index];
  const int change = random.Index(8);
  this->Note("light ", index, " change ", change);
  switch (change)
  {
    case 0:
      light->SetSwitch(!light->GetSwitch());
      break;
    case 1:
      light->SetIntensity(light->GetIntensity() > 0.0 ? 0.0 : 1.0);
      break;
    case 2:
      this->Pass->SetLightScatters(light, !this->Pass->GetLightScatters(light));
      break;
    case 3:
      this->SetLightColour(light, kind, random);
      break;
    case 4:
      if (kind == FRAME_PHOTOMETRIC)
      {
        const std::string file = this->Photometry + "/tube.ies";
        this->Pass->SetLightPhotometry(light, random.Index(2) ? file.c_str() : nullptr);
        this->Pass->SetLightPhotometryUp(light, 1.0, 0.2, 0.1);
      }
      break;
    default:
      this->PlaceLight(light, kind, random);
  }
}
}
