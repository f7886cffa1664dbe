// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Scenes for the path tracer of vtkAirlightReference, and how far its pictures are from a value in
 * their own standard errors.
 */

#ifndef AirlightTestPaths_h
#define AirlightTestPaths_h

#include "AirlightTestCheck.h"
#include "AirlightTestTools.h"

#include "vtkActor.h"
#include "vtkAirlight.h"
#include "vtkAirlightReference.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"
#include "vtkPointData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace airlight_test
{
class PathScene
{
public:
  explicit PathScene(int side = 8)
  {
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->SetBackground(0.0, 0.0, 0.0);
    this->Reference->SetRenderer(this->Renderer);
    this->Reference->SetMedium(this->Medium);
    this->Reference->SetSize(side, side);
    this->Reference->SetScatteringOrders(0);
  }

  // So narrow that all pixels see the same ray.
  void Look(const glm::dvec3& eye, const glm::dvec3& direction, double angle = 1e-5)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    const glm::dvec3 aim = eye + direction;
    camera->SetPosition(eye.x, eye.y, eye.z);
    camera->SetFocalPoint(aim.x, aim.y, aim.z);
    camera->SetViewUp(0.3, 1.0, 0.2);
    camera->SetViewAngle(angle);
    camera->SetClippingRange(1e-3, 1e3);
  }

  vtkLight* AddLamp(const glm::dvec3& position, double intensity = 1.0)
  {
    vtkNew<vtkLight> light;
    light->PositionalOn();
    light->SetConeAngle(180.0);
    light->SetAttenuationValues(0.0, 0.0, 1.0);
    light->SetPosition(position.x, position.y, position.z);
    const double rgb[3] = { intensity, intensity, intensity };
    vtkAirlight::SetRadiantIntensity(light, rgb);
    this->Renderer->AddLight(light);
    return light;
  }

  // Of this diffuse colour and radiance of its own.
  vtkActor* AddSurface(vtkPolyDataAlgorithm* source, const glm::dvec3& albedo, double shines = 0.0)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    vtkProperty* property = actor->GetProperty();
    property->SetDiffuseColor(albedo.x, albedo.y, albedo.z);
    property->SetInterpolationToFlat();
    property->SetAmbientColor(1.0, 1.0, 1.0);
    property->SetAmbient(shines);
    this->Renderer->AddActor(actor);
    return actor;
  }

  // c: albedo, sigmaT: extinction.
  static void SetMedium(
    vtkParticipatingMedium* medium, const glm::dvec3& c, const glm::dvec3& sigmaT)
  {
    const glm::dvec3 s = c * sigmaT;
    const glm::dvec3 a = sigmaT - s;
    medium->SetScattering(s.x, s.y, s.z);
    medium->SetAbsorption(a.x, a.y, a.z);
  }

  void Compute(int samples, int seed = 0)
  {
    this->Reference->SetSamplesPerPixel(samples);
    this->Reference->SetSeed(seed);
    this->Reference->Modified();
    this->Reference->Update();
  }

  vtkDataArray* Get(const char* name)
  {
    return this->Reference->GetOutput()->GetPointData()->GetArray(name);
  }

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkParticipatingMedium> Medium;
  vtkNew<vtkAirlightReference> Reference;
};

// The mean of a channel over all pixels, and its standard error.
struct PathMean
{
  PathMean(PathScene& scene, int channel)
  {
    vtkDataArray* radiance = scene.Get("Radiance");
    vtkDataArray* error = scene.Get("StandardError");
    const auto count = static_cast<double>(radiance->GetNumberOfTuples());
    double squares = 0.0;
    for (vtkIdType i = 0; i < radiance->GetNumberOfTuples(); ++i)
    {
      this->Value += radiance->GetComponent(i, channel) / count;
      squares += std::pow(error->GetComponent(i, channel), 2);
    }
    this->Error = std::sqrt(squares) / count;
  }

  double Value = 0.0;
  double Error = 0.0;
};

// That the mean of all pixels is the expected value within 3.5 standard errors, its own and the
// expectation's, and that these are small.
inline void CheckMean(const std::string& what, PathScene& scene, int channel, double expected,
  double most, double ofExpected = 0.0)
{
  const PathMean mean(scene, channel);
  const double deviation = (mean.Value - expected) / std::hypot(mean.Error, ofExpected);
  const std::string text = Text(what, ", channel ", channel, ": ", mean.Value, " +- ", mean.Error,
    ", expected ", expected, ", ", deviation, " standard errors");
  std::cout << text << "\n";
  Check(std::abs(deviation) < 3.5, text);
  Check(mean.Error < most * expected, text + ": small standard error");
}
}

#endif
