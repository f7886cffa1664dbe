// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/ModelScene.h"

#include "formats/Files.h"
#include "formats/ModelReader.h"
#include "formats/UserError.h"
#include "scene/SceneReader.h"

#include <vtkMath.h>

#include <cmath>

namespace airlight
{

namespace
{
constexpr double RelativeVisibility = 10.0;      // of the diagonal
constexpr double LightStrength = 2.0;            // radiance per albedo in clear air: fog takes most
constexpr Vector3 LightOffset{ -0.5, 0.7, 0.7 }; // from the middle, in diagonals
}

//------------------------------------------------------------------------------
Scene MakeModelScene(const std::string& fileName)
{
  CheckModelFile(fileName);
  Scene scene;
  scene.FileName = fileName;
  scene.Surfaces = ReadModel(fileName);
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
  scene.Camera.FocalPoint = center;
  scene.Camera.Position = center;
  scene.Camera.Position[2] +=
    0.5 * diagonal / std::sin(0.5 * vtkMath::RadiansFromDegrees(scene.Camera.ViewAngle));

  LightSource light;
  for (std::size_t i = 0; i < 3; ++i)
  {
    light.Position[i] = center[i] + LightOffset[i] * diagonal;
  }
  // A surface that faces a lamp of intensity I at distance r sends albedo/pi * I/r^2.
  const double distance = vtkMath::Norm(LightOffset.data()) * diagonal;
  light.Power.fill(LightStrength * vtkMath::Pi() * distance * distance);
  scene.Lights.push_back(light);

  scene.Medium = vtkSmartPointer<vtkParticipatingMedium>::New();
  scene.Medium->SetVisibility(RelativeVisibility * diagonal);
  return scene;
}

//------------------------------------------------------------------------------
Scene ReadSceneOrModel(const std::string& fileName)
{
  return GetExtension(fileName) == "json" ? ReadScene(fileName) : MakeModelScene(fileName);
}

}
