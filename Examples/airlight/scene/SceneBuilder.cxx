// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/SceneBuilder.h"

#include "formats/UserError.h"
#include "formats/VTKMessages.h"
#include "scene/Display.h"

#include <vtkAirlight.h>
#include <vtkAirlightLight.h>
#include <vtkCamera.h>
#include <vtkMath.h>

#include <algorithm>
#include <iostream>

namespace airlight
{

namespace
{
constexpr int Samples = 4; // of a multisampled window

void SetExtent(vtkLight* light, const LightSource& source)
{
  vtkAirlightLight::SetRadius(light, source.Radius);
  vtkAirlightLight::SetSize(light, source.Size[0], source.Size[1]);
  vtkAirlightLight::SetAngularDiameter(light, source.AngularDiameter);
  vtkAirlightLight::SetVisible(light, source.Visible);
  if (source.IsRectangle())
  {
    const Vector3& up = source.PhotometryUp;
    vtkAirlightLight::SetPhotometryUp(light, up[0], up[1], up[2]);
  }
}

vtkSmartPointer<vtkLight> MakeLight(const LightSource& source)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  Vector3 position = source.Position;
  if (source.Type == LightSource::Kind::Directional)
  {
    vtkAirlight::SetIrradiance(light, source.Power.data());
    position = { 0.0, 0.0, 0.0 }; // only the direction counts
  }
  else
  {
    vtkAirlight::SetRadiantIntensity(light, source.Power.data());
  }
  if (source.Type == LightSource::Kind::Spot)
  {
    light->SetConeAngle(source.ConeHalfAngle);
    light->SetExponent(source.Exponent);
  }
  Vector3 target;
  vtkMath::Add(position.data(), source.Direction.data(), target.data());
  light->SetLightTypeToSceneLight();
  light->SetPosition(position.data());
  light->SetFocalPoint(target.data());
  if (!source.Scatters)
  {
    vtkAirlightLight::SetScatters(light, false);
  }
  SetExtent(light, source);
  return light;
}

void AddPhotometry(const Scene& scene, const RenderedScene& built)
{
  for (std::size_t i = 0; i < scene.Lights.size(); ++i)
  {
    const LightSource& source = scene.Lights[i];
    if (source.PhotometryFile.empty())
    {
      continue;
    }
    const VTKMessages messages;
    if (!vtkAirlightLight::SetPhotometry(built.Lights[i], source.PhotometryFile.c_str()))
    {
      throw UserError(messages.GetFirstError());
    }
    const Vector3& up = source.PhotometryUp;
    vtkAirlightLight::SetPhotometryUp(built.Lights[i], up[0], up[1], up[2]);
  }
}

void SetDisplay(vtkAirlightPass* pass, const Scene& scene, const RenderSettings& settings)
{
  const bool automatic = settings.Display.AutomaticExposure;
  pass->SetSubpixelFrames(settings.SubpixelFrames);
  pass->SetMultisampling(settings.Multisampling);
  pass->SetExposure(settings.Display.Exposure * (automatic ? scene.Brightness : 1.0));
  pass->SetAutomaticExposure(automatic);
  pass->SetToneMapping(settings.Display.ToneMapping);
  pass->SetOutputColorSpace(settings.Display.OutputColorSpace);
  pass->SetDithering(settings.Display.Dithering);
}

// The picture's camera, with a depth range that holds every surface. There may be none.
void SetCamera(vtkRenderer* renderer, const Scene& scene)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(scene.Camera.Position.data());
  camera->SetFocalPoint(scene.Camera.FocalPoint.data());
  camera->SetViewUp(scene.Camera.ViewUp.data());
  camera->SetViewAngle(scene.Camera.ViewAngle);
  double bounds[6];
  if (scene.GetBounds(bounds))
  {
    renderer->ResetCameraClippingRange(bounds);
  }
  else
  {
    const double distance = camera->GetDistance();
    camera->SetClippingRange(0.01 * distance, 10.0 * distance);
  }
}

// All but the camera, whose depth range the window's depth buffer decides on.
RenderedScene MakeRenderer(const Scene& scene)
{
  RenderedScene built;
  built.Brightness = scene.Brightness;
  built.Renderer = vtkSmartPointer<vtkRenderer>::New();
  built.Renderer->SetBackground(0.0, 0.0, 0.0);
  built.Renderer->TwoSidedLightingOn();
  built.Renderer->AutomaticLightCreationOff();
  for (const LightSource& source : scene.Lights)
  {
    built.Lights.push_back(MakeLight(source));
    built.Renderer->AddLight(built.Lights.back());
  }
  for (const Surface& surface : scene.Surfaces)
  {
    built.Renderer->AddActor(surface.Actor);
  }
  return built;
}
}

//------------------------------------------------------------------------------
void RenderedScene::Render()
{
  const VTKMessages messages;
  this->Window->Render();
  ReportMessages(messages, "rendering failed");
}

//------------------------------------------------------------------------------
RenderedScene BuildScene(const Scene& scene, const RenderSettings& settings)
{
  CheckDisplay();
  RenderedScene built = MakeRenderer(scene);
  auto pass = vtkSmartPointer<vtkAirlightPass>::New();
  SetDisplay(pass, scene, settings);
  built.Renderer->SetPass(pass);
  if (settings.UseMedium)
  {
    built.Pass = pass;
    pass->SetMedium(scene.Medium);
    pass->SetShadowTechnique(settings.ShadowTechnique);
    pass->SetNumberOfSteps(settings.Steps);
    pass->SetRecordBuffers(settings.RecordBuffers);
    pass->SetScatteredSurfaceLight(scene.ScatteredSurfaceLight);
    AddPhotometry(scene, built);
  }
  else
  {
    pass->SetShadowTechniqueToNone();
  }
  built.Window = vtkSmartPointer<vtkRenderWindow>::New();
  built.Window->SetMultiSamples(settings.Multisampling ? Samples : 0);
  built.Window->SetOffScreenRendering(settings.OffScreen);
  built.Window->SetSize(scene.Width, scene.Height);
  built.Window->SetWindowName("Airlight");
  built.Window->AddRenderer(built.Renderer);
  SetCamera(built.Renderer, scene);
  return built;
}

//------------------------------------------------------------------------------
RenderedScene BuildSceneWithoutWindow(const Scene& scene)
{
  RenderedScene built = MakeRenderer(scene);
  AddPhotometry(scene, built);
  SetCamera(built.Renderer, scene);
  return built;
}

//------------------------------------------------------------------------------
void WarnOfPoints(const Scene& scene, const RenderSettings& settings, int frames)
{
  if (frames == 1 && settings.UseMedium &&
    std::any_of(scene.Lights.begin(), scene.Lights.end(),
      [](const LightSource& light) { return light.HasExtent(); }))
  {
    std::cerr << "warning: one frame takes lamps for points: give --antialiasing 16 or more for "
                 "their extent"
              << std::endl;
  }
}

}
