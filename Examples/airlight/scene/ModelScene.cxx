// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/ModelScene.h"

#include "formats/Files.h"
#include "formats/ModelReader.h"
#include "formats/UserError.h"
#include "scene/ModelLights.h"
#include "scene/ModelView.h"
#include "scene/Mood.h"
#include "scene/SceneReader.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace airlight
{

namespace
{
// How far the lamp is, for a camera at this distance: as many diagonals of the box around the model
// as if the picture held a ball of one diagonal. Nearer to a model that fills its picture better,
// but out of the ball around its box.
double GetReach(const CameraSettings& camera, const Vector3& center, double diagonal)
{
  constexpr double nearest = 0.6;
  const double distance =
    std::sqrt(vtkMath::Distance2BetweenPoints(camera.Position.data(), center.data()));
  const double reach =
    2.0 * distance * std::sin(0.5 * vtkMath::RadiansFromDegrees(camera.ViewAngle));
  return std::clamp(reach, nearest * diagonal, diagonal);
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
  double box[6] = { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };
  const bool any = scene.GetBounds(box); // not of a line in one point
  const Vector3 size{ box[1] - box[0], box[3] - box[2], box[5] - box[4] };
  const double diagonal = any ? vtkMath::Norm(size.data()) : 0.0;
  if (!(diagonal > 0.0) || !std::isfinite(diagonal))
  {
    throw UserError(fileName + ": the model has no extent");
  }
  const Vector3 center{ 0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]), 0.5 * (box[4] + box[5]) };
  ModelAxes axes = GetModelAxes(choices.Up, fileName);
  double reach = diagonal;
  if (model.Camera)
  {
    scene.Camera = *model.Camera;
    axes = GetCameraAxes(scene.Camera);
  }
  else
  {
    SeeModel(scene.Camera, scene.Surfaces, center, axes, choices.Aspect);
    reach = GetReach(scene.Camera, center, diagonal);
  }
  const Mood& mood = GetMood(choices.Mood);
  const std::string& place = choices.LightFrom.empty() ? "behind" : choices.LightFrom;
  ModelLights lights = MakeModelLights(place, mood, center, reach);
  TurnLights(lights.Lights, center, axes);
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
