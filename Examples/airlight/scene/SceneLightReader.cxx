// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/SceneLightReader.h"

#include "formats/PhotometryFile.h"
#include "scene/SceneFile.h"
#include "scene/SceneMediumReader.h"

#include <string>
#include <vector>

namespace airlight
{

namespace
{
// How a lamp shines into all directions, from a photometric file.
void ReadPhotometry(const LocatedJson& json, const std::string& sceneFile, LightSource& light)
{
  light.PhotometryFile = FindSceneFile(json["photometry"], sceneFile);
  UseSceneFile(json["photometry"], [&light] { CheckPhotometryFile(light.PhotometryFile); });
}

void ReadSize(const LocatedJson& json, LightSource& light)
{
  if (json.Has("radius"))
  {
    json["radius"].Fail("must not stand beside size: a lamp is a rectangle or round");
  }
  const std::vector<LocatedJson> items = json["size"].GetItems();
  if (items.size() != 2)
  {
    json["size"].Fail("must be a list of 2 numbers, width and height");
  }
  light.Size = { items[0].GetNumber(0.0, LargestNumber), items[1].GetNumber(0.0, LargestNumber) };
}

void ReadExtent(const LocatedJson& json, LightSource& light)
{
  if (json.Has("angular_diameter_deg"))
  {
    light.AngularDiameter = json["angular_diameter_deg"].GetNumber(0.0, LargestAngularDiameter);
  }
  if (json.Has("radius"))
  {
    light.Radius = json["radius"].GetNumber(0.0, LargestNumber);
  }
  if (json.Has("size"))
  {
    ReadSize(json, light);
  }
  light.Visible = json.Has("visible") && json["visible"].GetBoolean();
  if (light.Visible && !light.HasExtent())
  {
    json["visible"].Fail(light.Type == LightSource::Kind::Directional
        ? "shows nothing of a sun without an angular_diameter_deg above 0"
        : "shows nothing of a point: give the lamp a radius or a size above 0");
  }
}

// Photometric files and rectangles have an axis and a direction across it.
bool HasAxis(const LocatedJson& json) { return json.Has("photometry") || json.Has("size"); }

void CheckLightKeys(const LocatedJson& json, LightSource::Kind type)
{
  std::vector<std::string> optional = { "photometry", "radius", "size", "visible" };
  if (HasAxis(json))
  {
    optional.emplace_back("photometry_up");
  }
  switch (type)
  {
    case LightSource::Kind::Point:
      if (HasAxis(json))
      {
        optional.emplace_back("direction");
      }
      json.CheckKeys({ "type", "position", "intensity" }, optional);
      break;
    case LightSource::Kind::Spot:
      json.CheckKeys(
        { "type", "position", "direction", "cone_half_angle_deg", "exponent", "intensity" },
        optional);
      break;
    default:
      json.CheckKeys({ "type", "direction", "irradiance" }, { "angular_diameter_deg", "visible" });
  }
}

LightSource::Kind ReadLightType(const LocatedJson& json)
{
  const std::string type = json["type"].GetString();
  if (type == "point")
  {
    return LightSource::Kind::Point;
  }
  if (type == "spot")
  {
    return LightSource::Kind::Spot;
  }
  if (type != "directional")
  {
    json["type"].Fail("must be \"point\", \"spot\" or \"directional\", not \"" + type + "\"");
  }
  return LightSource::Kind::Directional;
}
}

//------------------------------------------------------------------------------
LightSource ReadSceneLight(const LocatedJson& json, const std::string& sceneFile)
{
  json.CheckKeys({ "type" },
    { "position", "direction", "intensity", "irradiance", "cone_half_angle_deg", "exponent",
      "photometry", "photometry_up", "radius", "size", "angular_diameter_deg", "visible" });
  LightSource light;
  light.Type = ReadLightType(json);
  CheckLightKeys(json, light.Type);
  if (light.Type == LightSource::Kind::Spot)
  {
    light.ConeHalfAngle =
      json["cone_half_angle_deg"].GetNumber(SmallestConeAngle, LargestConeAngle);
    light.Exponent = json["exponent"].GetNumber(0.0, LargestExponent);
  }
  const bool directional = light.Type == LightSource::Kind::Directional;
  if (!directional)
  {
    light.Position = json["position"].GetVector(-LargestNumber, LargestNumber);
  }
  if (json.Has("direction"))
  {
    light.Direction = ReadSceneDirection(json["direction"]);
  }
  light.Power = json[directional ? "irradiance" : "intensity"].GetVector(0.0, LargestNumber);
  if (json.Has("photometry"))
  {
    ReadPhotometry(json, sceneFile, light);
  }
  if (json.Has("photometry_up"))
  {
    light.PhotometryUp = ReadSceneDirection(json["photometry_up"]);
  }
  ReadExtent(json, light);
  return light;
}

}
