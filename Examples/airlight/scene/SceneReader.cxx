// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/SceneReader.h"

#include "formats/LocatedJson.h"
#include "formats/ModelReader.h"
#include "scene/LambertActor.h"
#include "scene/SceneFile.h"
#include "scene/SceneLightReader.h"
#include "scene/SceneMediumReader.h"

#include <vtkMath.h>

#include <string>
#include <vector>

namespace airlight
{

namespace
{
constexpr int MaximumImageSize = 16384;

CameraSettings ReadCamera(const LocatedJson& json)
{
  json.CheckKeys({ "position", "focal_point", "view_up", "view_angle_deg" });
  CameraSettings camera;
  camera.Position = json["position"].GetVector(-LargestNumber, LargestNumber);
  camera.FocalPoint = json["focal_point"].GetVector(-LargestNumber, LargestNumber);
  camera.ViewUp = ReadSceneDirection(json["view_up"]);
  camera.ViewAngle = json["view_angle_deg"].GetNumber(0.001, 179.0);
  Vector3 forward;
  Vector3 right;
  vtkMath::Subtract(camera.FocalPoint.data(), camera.Position.data(), forward.data());
  if (vtkMath::Norm(forward.data()) == 0.0)
  {
    json["focal_point"].Fail("must differ from camera.position");
  }
  vtkMath::Cross(forward.data(), camera.ViewUp.data(), right.data());
  if (vtkMath::Norm(right.data()) <=
    1e-9 * vtkMath::Norm(forward.data()) * vtkMath::Norm(camera.ViewUp.data()))
  {
    json["view_up"].Fail("must not be parallel to the direction of view");
  }
  return camera;
}

// The files of all surfaces, each looked at in a child process.
std::vector<std::string> CheckSurfaces(const LocatedJson& json, const std::string& sceneFile)
{
  std::vector<std::string> files;
  for (const LocatedJson& item : json.GetItems())
  {
    item.CheckKeys({ "mesh", "albedo" });
    item["albedo"].GetVector(0.0, 1.0);
    files.push_back(FindSceneFile(item["mesh"], sceneFile));
  }
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    UseSceneFile(json.GetItems()[i]["mesh"], [&files, i] { CheckModelFile(files[i]); });
  }
  return files;
}

std::vector<Surface> ReadSurfaces(const LocatedJson& json, const std::vector<std::string>& files)
{
  std::vector<Surface> surfaces;
  for (const LocatedJson& item : json.GetItems())
  {
    const std::string& file = files[surfaces.size()];
    const Vector3 albedo = item["albedo"].GetVector(0.0, 1.0);
    surfaces.push_back({ file, MakeLambertActor(ReadMesh(file), albedo, Shading::Flat) });
  }
  return surfaces;
}
}

//------------------------------------------------------------------------------
Scene ReadScene(const std::string& fileName)
{
  const LocatedJson json = LocatedJson::ReadFile(fileName);
  json.CheckKeys({ "image", "camera", "medium", "lights", "surfaces" },
    { "name", "description", "scattered_surface_light" });
  Scene scene;
  scene.FileName = fileName;
  for (const char* text : { "name", "description" })
  {
    if (json.Has(text))
    {
      json[text].GetString();
    }
  }
  json["image"].CheckKeys({ "width", "height" });
  scene.Width = json["image"]["width"].GetInteger(1, MaximumImageSize);
  scene.Height = json["image"]["height"].GetInteger(1, MaximumImageSize);
  scene.Camera = ReadCamera(json["camera"]);
  scene.Medium = ReadMedium(json["medium"], fileName);
  for (const LocatedJson& light : json["lights"].GetItems())
  {
    scene.Lights.push_back(ReadSceneLight(light, fileName));
  }
  scene.ScatteredSurfaceLight =
    json.Has("scattered_surface_light") && json["scattered_surface_light"].GetBoolean();
  // All files are checked before the first is read: see CheckModelFile().
  const std::vector<std::string> files = CheckSurfaces(json["surfaces"], fileName);
  CheckMediumBoundary(json["medium"], fileName);
  ReadMediumBoundary(json["medium"], fileName, scene.Medium);
  scene.Surfaces = ReadSurfaces(json["surfaces"], files);
  return scene;
}

}
