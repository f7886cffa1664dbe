// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/SceneMediumReader.h"

#include "formats/ModelReader.h"
#include "scene/MediumFile.h"
#include "scene/PhaseName.h"
#include "scene/Scene.h"
#include "scene/SceneFile.h"

#include <vtkMath.h>
#include <vtkPhaseFunction.h>

#include <string>
#include <vector>

namespace airlight
{

namespace
{
void ReadPhase(
  const LocatedJson& json, const std::string& sceneFile, vtkParticipatingMedium* medium)
{
  std::vector<std::string> keys = GetAllPhaseParameters();
  keys.emplace_back("table");
  json.CheckKeys({ "type" }, keys);
  const std::string type = json["type"].GetString();
  if (type == "tabulated")
  {
    json.CheckKeys({ "type", "table" });
    const LocatedJson table = json["table"];
    const std::string file = FindSceneFile(table, sceneFile);
    UseSceneFile(table, [&file, medium] { ReadPhaseTable(file, medium); });
    return;
  }
  const vtkSmartPointer<vtkPhaseFunction> phase = MakePhaseFunction(type);
  if (!phase)
  {
    json["type"].Fail("must be one of " + ListPhaseNames() + ", tabulated, not \"" + type + "\"");
  }
  keys = GetPhaseParameters(phase);
  keys.insert(keys.begin(), "type");
  json.CheckKeys(keys);
  for (int i = 0; i < phase->GetNumberOfParameters(); ++i)
  {
    const std::string name = phase->GetParameterName(i);
    double range[2];
    phase->GetParameterRange(i, range);
    phase->SetParameter(name, json[name].GetNumber(range[0], range[1]));
  }
  medium->SetPhaseFunction(phase);
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

void ReadCylinder(const LocatedJson& json, vtkParticipatingMedium* medium)
{
  json.CheckKeys({ "type", "center", "radius", "height" }, { "axis" });
  medium->SetRegionToCylinder();
  medium->SetCenter(json["center"].GetVector(-LargestNumber, LargestNumber).data());
  medium->SetRadius(json["radius"].GetNumber(0.0, LargestNumber));
  medium->SetHeight(json["height"].GetNumber(SmallestHeight, LargestNumber));
  if (json.Has("axis"))
  {
    medium->SetAxis(ReadSceneDirection(json["axis"]).data());
  }
}

void ReadBounds(const LocatedJson& json, vtkParticipatingMedium* medium)
{
  json.CheckKeys({ "type" }, { "min", "max", "center", "radius", "height", "axis", "mesh" });
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
  else if (type == "cylinder")
  {
    ReadCylinder(json, medium);
  }
  else if (type == "surface")
  {
    json.CheckKeys({ "type", "mesh" });
  }
  else
  {
    json["type"].Fail(R"(must be "box", "sphere", "cylinder" or "surface", not ")" + type + "\"");
  }
}

void ReadDensity(const LocatedJson& json, vtkParticipatingMedium* medium)
{
  json.CheckKeys(
    { "type", "reference_height", "scale_height" }, { "up", "ground_height", "ground_albedo" });
  const std::string type = json["type"].GetString();
  if (type != "exponential_height")
  {
    json["type"].Fail("must be \"exponential_height\", not \"" + type + "\"");
  }
  medium->SetDensityToExponentialHeight();
  medium->SetReferenceHeight(json["reference_height"].GetNumber(-LargestNumber, LargestNumber));
  medium->SetScaleHeight(json["scale_height"].GetNumber(SmallestHeight, LargestNumber));
  if (json.Has("up"))
  {
    medium->SetUp(ReadSceneDirection(json["up"]).data());
  }
  if (json.Has("ground_height"))
  {
    medium->GroundOn();
    medium->SetGroundHeight(json["ground_height"].GetNumber(-LargestNumber, LargestNumber));
  }
  if (json.Has("ground_albedo"))
  {
    medium->SetGroundAlbedo(json["ground_albedo"].GetVector(0.0, 1.0).data());
  }
}

void ReadSky(const LocatedJson& json, vtkParticipatingMedium* medium)
{
  json.CheckKeys({ "radiance" }, { "ground_radiance", "up" });
  medium->SetSkyRadiance(json["radiance"].GetVector(0.0, LargestNumber).data());
  if (json.Has("ground_radiance"))
  {
    medium->SetGroundRadiance(json["ground_radiance"].GetVector(0.0, LargestNumber).data());
  }
  if (json.Has("up"))
  {
    if (medium->GetDensity() == vtkParticipatingMedium::EXPONENTIAL_HEIGHT)
    {
      json["up"].Fail("is that of medium.density, where the density falls with height");
    }
    medium->SetUp(ReadSceneDirection(json["up"]).data());
  }
}

// The mesh that bounds the medium, if one does.
bool HasBoundary(const LocatedJson& json)
{
  return json.Has("bounds") && json["bounds"].Has("mesh");
}
}

//------------------------------------------------------------------------------
Vector3 ReadSceneDirection(const LocatedJson& json)
{
  const Vector3 direction = json.GetVector(-LargestNumber, LargestNumber);
  if (vtkMath::Norm(direction.data()) == 0.0)
  {
    json.Fail("must not be zero");
  }
  return direction;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkParticipatingMedium> ReadMedium(
  const LocatedJson& json, const std::string& sceneFile)
{
  json.CheckKeys({ "sigma_s", "sigma_a", "phase" },
    { "bounds", "density", "ambient_radiance", "sky", "emission", "multiple_scattering" });
  auto medium = vtkSmartPointer<vtkParticipatingMedium>::New();
  medium->SetScattering(json["sigma_s"].GetVector(0.0, LargestNumber).data());
  medium->SetAbsorption(json["sigma_a"].GetVector(0.0, LargestNumber).data());
  ReadPhase(json["phase"], sceneFile, medium);
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
  if (json.Has("sky"))
  {
    ReadSky(json["sky"], medium);
  }
  if (json.Has("emission"))
  {
    medium->SetEmission(json["emission"].GetVector(0.0, LargestNumber).data());
  }
  medium->SetMultipleScattering(
    json.Has("multiple_scattering") && json["multiple_scattering"].GetBoolean());
  return medium;
}

//------------------------------------------------------------------------------
void CheckMediumBoundary(const LocatedJson& json, const std::string& sceneFile)
{
  if (HasBoundary(json))
  {
    const LocatedJson mesh = json["bounds"]["mesh"];
    const std::string file = FindSceneFile(mesh, sceneFile);
    UseSceneFile(mesh, [&file] { CheckModelFile(file); });
  }
}

//------------------------------------------------------------------------------
void ReadMediumBoundary(
  const LocatedJson& json, const std::string& sceneFile, vtkParticipatingMedium* medium)
{
  if (HasBoundary(json))
  {
    const LocatedJson mesh = json["bounds"]["mesh"];
    const std::string file = FindSceneFile(mesh, sceneFile);
    UseSceneFile(mesh, [&file, medium] { ReadMediumSurface(file, medium); });
  }
}

}
