// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneReader.h"

#include "LambertActor.h"
#include "LocatedJson.h"
#include "ModelReader.h"
#include "UserError.h"

#include <vtkMath.h>

#include <filesystem>
#include <system_error>

namespace airlight
{

namespace
{
constexpr int MaximumImageSize = 16384;
constexpr double MaximumAnisotropy = 0.99;

Vector3 ReadDirection(const LocatedJson& json)
{
  const Vector3 direction = json.GetVector(-LargestNumber, LargestNumber);
  if (vtkMath::Norm(direction.data()) == 0.0)
  {
    json.Fail("must not be zero");
  }
  return direction;
}

CameraSettings ReadCamera(const LocatedJson& json)
{
  json.CheckKeys({ "position", "focal_point", "view_up", "view_angle_deg" });
  CameraSettings camera;
  camera.Position = json["position"].GetVector(-LargestNumber, LargestNumber);
  camera.FocalPoint = json["focal_point"].GetVector(-LargestNumber, LargestNumber);
  camera.ViewUp = ReadDirection(json["view_up"]);
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

void ReadPhase(const LocatedJson& json, vtkParticipatingMedium* medium)
{
  json.CheckKeys({ "type" }, { "g" });
  const std::string type = json["type"].GetString();
  if (type != "isotropic" && type != "henyey_greenstein")
  {
    json["type"].Fail("must be \"isotropic\" or \"henyey_greenstein\", not \"" + type + "\"");
  }
  if (type == "henyey_greenstein")
  {
    json.CheckKeys({ "type", "g" });
    const double g = json["g"].GetNumber(-MaximumAnisotropy, MaximumAnisotropy);
    if (g != 0.0) // where both are the same, the isotropic one is exact
    {
      medium->SetPhaseFunctionToHenyeyGreenstein();
      medium->SetAnisotropy(g);
    }
  }
  else
  {
    json.CheckKeys({ "type" });
  }
}

void ReadBox(const LocatedJson& json, vtkParticipatingMedium* medium)
{
  json.CheckKeys({ "type", "min", "max" });
  const Vector3 low = json["min"].GetVector(-LargestNumber, LargestNumber);
  const Vector3 high = json["max"].GetVector(-LargestNumber, LargestNumber);
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (low[i] > high[i])
    {
      json["min"].Fail("must be at most medium.bounds.max in each coordinate");
    }
  }
  medium->SetRegionToBox();
  medium->SetBounds(low[0], high[0], low[1], high[1], low[2], high[2]);
}

void ReadBounds(const LocatedJson& json, vtkParticipatingMedium* medium)
{
  json.CheckKeys({ "type" }, { "min", "max", "center", "radius" });
  const std::string type = json["type"].GetString();
  if (type == "box")
  {
    ReadBox(json, medium);
  }
  else if (type == "sphere")
  {
    json.CheckKeys({ "type", "center", "radius" });
    medium->SetRegionToSphere();
    medium->SetCenter(json["center"].GetVector(-LargestNumber, LargestNumber).data());
    medium->SetRadius(json["radius"].GetNumber(0.0, LargestNumber));
  }
  else
  {
    json["type"].Fail("must be \"box\" or \"sphere\", not \"" + type + "\"");
  }
}

void ReadDensity(const LocatedJson& json, vtkParticipatingMedium* medium)
{
  json.CheckKeys({ "type", "reference_height", "scale_height" }, { "up" });
  const std::string type = json["type"].GetString();
  if (type != "exponential_height")
  {
    json["type"].Fail("must be \"exponential_height\", not \"" + type + "\"");
  }
  medium->SetDensityToExponentialHeight();
  medium->SetReferenceHeight(json["reference_height"].GetNumber(-LargestNumber, LargestNumber));
  medium->SetScaleHeight(json["scale_height"].GetNumber(SmallestScaleHeight, LargestNumber));
  if (json.Has("up"))
  {
    medium->SetUp(ReadDirection(json["up"]).data());
  }
}

vtkSmartPointer<vtkParticipatingMedium> ReadMedium(const LocatedJson& json)
{
  json.CheckKeys({ "sigma_s", "sigma_a", "phase" }, { "bounds", "density", "ambient_radiance" });
  auto medium = vtkSmartPointer<vtkParticipatingMedium>::New();
  medium->SetScattering(json["sigma_s"].GetVector(0.0, LargestNumber).data());
  medium->SetAbsorption(json["sigma_a"].GetVector(0.0, LargestNumber).data());
  ReadPhase(json["phase"], medium);
  if (json.Has("bounds"))
  {
    ReadBounds(json["bounds"], medium);
  }
  if (json.Has("density"))
  {
    ReadDensity(json["density"], medium);
  }
  if (json.Has("ambient_radiance"))
  {
    medium->SetAmbientRadiance(json["ambient_radiance"].GetVector(0.0, LargestNumber).data());
  }
  return medium;
}

LightSource ReadLight(const LocatedJson& json)
{
  json.CheckKeys({ "type" },
    { "position", "direction", "intensity", "irradiance", "cone_half_angle_deg", "exponent" });
  LightSource light;
  const std::string type = json["type"].GetString();
  if (type == "point")
  {
    json.CheckKeys({ "type", "position", "intensity" });
  }
  else if (type == "spot")
  {
    light.Type = LightSource::Kind::Spot;
    json.CheckKeys(
      { "type", "position", "direction", "cone_half_angle_deg", "exponent", "intensity" });
    light.ConeHalfAngle =
      json["cone_half_angle_deg"].GetNumber(SmallestConeAngle, LargestConeAngle);
    light.Exponent = json["exponent"].GetNumber(0.0, LargestExponent);
  }
  else if (type == "directional")
  {
    light.Type = LightSource::Kind::Directional;
    json.CheckKeys({ "type", "direction", "irradiance" });
  }
  else
  {
    json["type"].Fail("must be \"point\", \"spot\" or \"directional\", not \"" + type + "\"");
  }
  if (light.Type != LightSource::Kind::Directional)
  {
    light.Position = json["position"].GetVector(-LargestNumber, LargestNumber);
  }
  if (light.Type != LightSource::Kind::Point)
  {
    light.Direction = ReadDirection(json["direction"]);
  }
  const bool directional = light.Type == LightSource::Kind::Directional;
  light.Power = json[directional ? "irradiance" : "intensity"].GetVector(0.0, LargestNumber);
  return light;
}

// The reference keeps scenes/ and meshes/ side by side, others may keep a mesh beside its scene.
std::string FindMesh(const LocatedJson& json, const std::string& sceneFile)
{
  const std::string name = json.GetString();
  const std::filesystem::path folder = std::filesystem::absolute(sceneFile).parent_path();
  for (const auto& candidate : { folder / name, folder.parent_path() / name })
  {
    std::error_code error;
    if (std::filesystem::is_regular_file(candidate, error))
    {
      return candidate.string();
    }
  }
  json.Fail("names a file that does not exist: \"" + name + "\" (looked in " + folder.string() +
    " and in " + folder.parent_path().string() + ")");
}

std::vector<Surface> ReadSurfaces(const LocatedJson& json, const std::string& sceneFile)
{
  std::vector<Vector3> albedos;
  std::vector<std::string> files;
  std::vector<LocatedJson> meshes;
  for (const LocatedJson& item : json.GetItems())
  {
    item.CheckKeys({ "mesh", "albedo" });
    albedos.push_back(item["albedo"].GetVector(0.0, 1.0));
    meshes.push_back(item["mesh"]);
    files.push_back(FindMesh(meshes.back(), sceneFile));
  }
  // All files are checked before the first is read: see CheckModelFile().
  std::vector<Surface> surfaces;
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    try
    {
      CheckModelFile(files[i]);
    }
    catch (const UserError& error)
    {
      meshes[i].Fail(std::string("cannot be used: ") + error.what());
    }
  }
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    surfaces.push_back({ files[i], MakeLambertActor(ReadMesh(files[i]), albedos[i]) });
  }
  return surfaces;
}
}

//------------------------------------------------------------------------------
Scene ReadScene(const std::string& fileName)
{
  const LocatedJson json = LocatedJson::ReadFile(fileName);
  json.CheckKeys({ "image", "camera", "medium", "lights", "surfaces" }, { "name", "description" });
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
  scene.Medium = ReadMedium(json["medium"]);
  for (const LocatedJson& light : json["lights"].GetItems())
  {
    scene.Lights.push_back(ReadLight(light));
  }
  scene.Surfaces = ReadSurfaces(json["surfaces"], fileName);
  return scene;
}

}
