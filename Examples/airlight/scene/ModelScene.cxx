// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/ModelScene.h"

#include "formats/Files.h"
#include "formats/ModelReader.h"
#include "formats/UserError.h"
#include "scene/ModelLights.h"
#include "scene/Mood.h"
#include "scene/SceneReader.h"

#include <vtkMath.h>

#include <cmath>
#include <iostream>

namespace airlight
{

namespace
{
// In diagonals of the box around the model, with y up and the view along -z.
constexpr Vector3 EyeDirection{ 0.42, 0.28, 1.0 };

Vector3 Scale(double factor, const Vector3& vector)
{
  return { factor * vector[0], factor * vector[1], factor * vector[2] };
}

void SeeAll(CameraSettings& camera, const Vector3& center, double diagonal)
{
  const double distance =
    0.5 * diagonal / std::sin(0.5 * vtkMath::RadiansFromDegrees(camera.ViewAngle));
  const Vector3 offset = Scale(distance / vtkMath::Norm(EyeDirection.data()), EyeDirection);
  camera.FocalPoint = center;
  vtkMath::Add(center.data(), offset.data(), camera.Position.data());
}
}

//------------------------------------------------------------------------------
Scene MakeModelScene(const std::string& fileName, const ModelChoices& choices)
{
  const std::string withoutMaterials = CheckModelFile(fileName);
  if (!withoutMaterials.empty())
  {
    std::cerr << "warning: the materials are left out: " << withoutMaterials << "\n";
  }
  Scene scene;
  scene.FileName = fileName;
  const Model model = ReadModel(fileName, choices.KeepFacets, withoutMaterials.empty());
  scene.Surfaces = model.Surfaces;
  double box[6];
  if (!scene.GetBounds(box))
  {
    throw UserError(fileName + ": has no polygons");
  }
  const Vector3 size{ box[1] - box[0], box[3] - box[2], box[5] - box[4] };
  const double diagonal = vtkMath::Norm(size.data());
  if (!(diagonal > 0.0) || !std::isfinite(diagonal))
  {
    throw UserError(fileName + ": the model has no extent");
  }
  const Vector3 center{ 0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]), 0.5 * (box[4] + box[5]) };
  SeeAll(scene.Camera, center, diagonal);
  scene.Camera = model.Camera.value_or(scene.Camera);
  const Mood& mood = GetMood(choices.Mood);
  const std::string& place = choices.LightFrom.empty() ? "behind" : choices.LightFrom;
  ModelLights lights = MakeModelLights(place, mood, center, diagonal);
  if (model.Camera)
  {
    TurnLights(lights.Lights, center, scene.Camera);
  }
  if (choices.LightFrom.empty())
  {
    scene.Lights = ScaleLights(model.Lights, mood, center, diagonal);
  }
  if (scene.Lights.empty())
  {
    scene.Lights = lights.Lights;
  }
  scene.Medium = vtkSmartPointer<vtkParticipatingMedium>::New();
  SetMood(scene.Medium, mood, diagonal, lights.Ambient);
  scene.Brightness = mood.Brightness * lights.Brightness;
  return scene;
}

//------------------------------------------------------------------------------
Scene ReadSceneOrModel(const std::string& fileName, const ModelChoices& choices)
{
  return GetExtension(fileName) == "json" ? ReadScene(fileName) : MakeModelScene(fileName, choices);
}

}
