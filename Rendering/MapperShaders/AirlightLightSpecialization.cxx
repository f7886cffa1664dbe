// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MapperShaders/AirlightLightSpecialization.h"

#include "vtkLight.h"

#include <regex>

namespace airlight
{
//------------------------------------------------------------------------------
bool operator==(const LightSpecialization& a, const LightSpecialization& b)
{
  return a.Scatters == b.Scatters && a.Sun == b.Sun && a.Goniometric == b.Goniometric &&
    a.Positional == b.Positional && a.Spot == b.Spot && a.InverseSquare == b.InverseSquare;
}

//------------------------------------------------------------------------------
std::vector<LightSpecialization> SpecializeLights(const std::vector<SceneLight>& sceneLights)
{
  std::vector<LightSpecialization> lights;
  if (sceneLights.size() > MaximumSpecializedLights)
  {
    return lights;
  }
  for (const SceneLight& sceneLight : sceneLights)
  {
    const double* fading = sceneLight.Light->GetAttenuationValues();
    // VTK compares in single precision.
    lights.push_back({ sceneLight.Scatters(), f64::airlightIsDirectional(sceneLight.Values),
      sceneLight.Values.goniometric != 0, sceneLight.Light->GetPositional() != 0,
      static_cast<float>(sceneLight.Light->GetConeAngle()) < 90.0f,
      fading[0] == 0.0 && fading[1] == 0.0 && fading[2] == 1.0 });
  }
  return lights;
}

namespace
{
// The light that a surface receives from a scene light, for AirlightSurface.glsl.
std::string GetReceivedLight(const LightSpecialization& sceneLight, const std::string& index)
{
  if (!sceneLight.Scatters)
  {
    return "vec3(1.0)";
  }
  const std::string transmittance = sceneLight.Sun
    ? "airlightLightTransmittance(" + index + ", true, point)"
    : sceneLight.Positional && !sceneLight.Goniometric
    ? "AIRLIGHT_TRANSMITTANCE_FROM(" + index + ", lightPositionVC" + index + ", point)"
    : "airlightLightTransmittance(" + index + ", false, point)";
  return "airlightApplyShadows(" + index + ", " + transmittance + ")";
}
}

//------------------------------------------------------------------------------
// A loop of a length that the compiler does not know, and arrays in it, cost several times as much.
std::string DefineEachLight(const std::vector<LightSpecialization>& lights, int shadowingLight)
{
  std::string lines;
  for (size_t k = 0; k < lights.size() && lights.size() <= MaximumUnrolledLights; ++k)
  {
    const std::string index = std::to_string(k);
    lines += " airlightReceivedLight[" + index +
      "] = " + (static_cast<int>(k) == shadowingLight ? "airlightShadowingLightFactor * " : "") +
      GetReceivedLight(lights[k], index) + ";";
  }
  return lines.empty() ? "" : "#define AIRLIGHT_EACH_LIGHT(point)" + lines + "\n";
}

namespace
{
// The value for the uniform of this name; the name itself if the value is not constant.
std::string GetConstant(
  const std::string& name, const std::string& what, const LightSpecialization& sceneLight)
{
  if (what == "Positional")
  {
    return sceneLight.Positional ? "1" : "0";
  }
  if (what == "ConeAngle")
  {
    return sceneLight.Spot ? name : "90.0";
  }
  return sceneLight.InverseSquare ? "vec3(0.0, 0.0, 1.0)" : name;
}
}

//------------------------------------------------------------------------------
std::string SpecializeLightTypes(
  const std::string& body, const std::vector<LightSpecialization>& lights)
{
  static const std::regex uniform("\\blight(Positional|ConeAngle|Attenuation)([0-9]+)\\b");
  std::string changed;
  auto rest = body.begin();
  for (std::sregex_iterator it(body.begin(), body.end(), uniform), end; it != end; ++it)
  {
    const std::smatch& match = *it;
    const size_t k = std::stoul(match[2]);
    changed.append(rest, match[0].first);
    changed += k < lights.size() ? GetConstant(match.str(), match[1], lights[k]) : match.str();
    rest = match[0].second;
  }
  return changed.append(rest, body.end());
}
}
