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
// Lengths are in diagonals of the box around the model, directions with y up and the view along -z.
constexpr Vector3 EyeDirection{ 0.42, 0.28, 1.0 };
constexpr double RelativeVisibility = 20.0;
constexpr double Anisotropy = 0.5; // as droplets scatter, but wide enough for lamps beside the view
constexpr Vector3 AmbientRadiance{ 0.012, 0.018, 0.03 }; // the fog's colour in shadow

// The lamp is behind the model, so that its shafts come forward around it.
constexpr Vector3 LampOffset{ -0.5, 0.78, -0.3 };
constexpr Vector3 LampColour{ 1.0, 0.86, 0.68 };
constexpr double LampRadiance = 3.5; // of a white surface in the middle that faces it, in clear air

// From beside the camera, on surfaces only: the side that is seen is readable.
constexpr Vector3 FillDirection{ -1.0, -0.45, -0.75 };
constexpr Vector3 FillColour{ 0.75, 0.87, 1.0 };
constexpr double FillRadiance = 0.8;

Vector3 Scale(double factor, const Vector3& vector)
{
  return { factor * vector[0], factor * vector[1], factor * vector[2] };
}

// A surface that faces a lamp of intensity I at distance r sends albedo/pi * I/r^2.
LightSource MakeLamp(const Vector3& center, double diagonal)
{
  LightSource lamp;
  const Vector3 offset = Scale(diagonal, LampOffset);
  vtkMath::Add(center.data(), offset.data(), lamp.Position.data());
  const double distance = vtkMath::Norm(offset.data());
  lamp.Power = Scale(LampRadiance * vtkMath::Pi() * distance * distance, LampColour);
  return lamp;
}

LightSource MakeFill()
{
  LightSource fill;
  fill.Type = LightSource::Kind::Directional;
  fill.Direction = FillDirection;
  fill.Power = Scale(FillRadiance * vtkMath::Pi(), FillColour);
  fill.Scatters = false;
  return fill;
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
  SeeAll(scene.Camera, center, diagonal);
  scene.Lights = { MakeLamp(center, diagonal), MakeFill() };
  scene.Medium = vtkSmartPointer<vtkParticipatingMedium>::New();
  scene.Medium->SetVisibility(RelativeVisibility * diagonal);
  scene.Medium->SetPhaseFunctionToHenyeyGreenstein();
  scene.Medium->SetAnisotropy(Anisotropy);
  scene.Medium->SetAmbientRadiance(AmbientRadiance.data());
  return scene;
}

//------------------------------------------------------------------------------
Scene ReadSceneOrModel(const std::string& fileName)
{
  return GetExtension(fileName) == "json" ? ReadScene(fileName) : MakeModelScene(fileName);
}

}
