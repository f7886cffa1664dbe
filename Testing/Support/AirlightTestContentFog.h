// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A scene in fog, and what its medium does to a ray by vtkAirlight in double precision.
 */

#ifndef AirlightTestContentFog_h
#define AirlightTestContentFog_h

#include "AirlightTestContent.h"
#include "AirlightTestTools.h"

namespace airlight_test
{
constexpr double Far = 1e18;                       // where a ray that hits nothing ends
inline const glm::dvec3 LampPlace(1.0, 3.5, -2.0); // above the picture and behind what is lit

//------------------------------------------------------------------------------
class Fog : public Scene
{
public:
  static constexpr int PictureWidth = 120;
  static constexpr int PictureHeight = 90;

  Fog()
    : Scene(PictureWidth, PictureHeight)
  {
    this->Window->SetAlphaBitPlanes(1);
  }

  // Surfaces are lit by a sun, which reaches them unattenuated, from the camera's side; the fog by
  // a lamp that is behind the surfaces that are lit. So what a surface sends is the same in fog.
  void Begin()
  {
    Open(*this);
    this->Pass->RecordBuffersOn();
    this->Pass->SetShadowTechniqueToNone();
    this->Renderer->SetPass(this->Pass);
    vtkNew<vtkLight> sun;
    sun->SetLightTypeToSceneLight();
    sun->SetPosition(0.2, 0.3, 1.0);
    sun->SetFocalPoint(0.0, 0.0, 0.0);
    sun->SetIntensity(0.8);
    this->AddLight(sun);
    this->Pass->SetLightScatters(sun, false);
    this->Lamp = AddLamp(*this, LampPlace);
  }

  Buffers Render(bool foggy)
  {
    this->Medium->SetScattering(foggy ? 0.08 : 0.0, foggy ? 0.1 : 0.0, foggy ? 0.13 : 0.0);
    this->Medium->SetAbsorption(foggy ? 0.02 : 0.0, foggy ? 0.01 : 0.0, foggy ? 0.03 : 0.0);
    return this->Scene::Render();
  }

  // The unit ray of a pixel, from the camera as Open() placed it.
  static glm::dvec3 GetDirection(int i, int j)
  {
    const double slope = std::tan(glm::radians(15.0));
    return glm::normalize(glm::dvec3(slope * (2.0 * i + 1.0 - PictureWidth) / PictureHeight,
      slope * (2.0 * j + 1.0 - PictureHeight) / PictureHeight, -1.0));
  }

  struct Part
  {
    glm::dvec3 Airlight;
    glm::dvec3 Transmittance;
  };
  // The medium between the eye and a distance.
  Part GetPart(const glm::dvec3& direction, double t)
  {
    Part part;
    const glm::dvec3 end = Eye + t * direction;
    vtkAirlight::Inscatter(
      this->Medium, this->Lamp, &Eye.x, &direction.x, 0.0, t, &part.Airlight.x);
    vtkAirlight::Transmittance(this->Medium, &Eye.x, &end.x, &part.Transmittance.x);
    return part;
  }

  vtkSmartPointer<vtkLight> Lamp;
  static constexpr glm::dvec3 Eye{ 0.0, 0.0, 8.0 };
};

// What sends the same whatever light arrives.
inline void MakeEmissive(vtkActor* actor)
{
  actor->GetProperty()->SetAmbient(1.0);
  actor->GetProperty()->SetDiffuse(0.0);
}
}

#endif
