// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MapperShaders/AirlightKnownLamps.h"

#include "vtkLight.h"

#include <regex>

namespace airlight
{
//------------------------------------------------------------------------------
bool operator==(const KnownLamp& a, const KnownLamp& b)
{
  return a.Scatters == b.Scatters && a.Sun == b.Sun && a.Goniometric == b.Goniometric &&
    a.Positional == b.Positional && a.Spot == b.Spot && a.InverseSquare == b.InverseSquare;
}

//------------------------------------------------------------------------------
std::vector<KnownLamp> FindKnownLamps(const std::vector<Lamp>& lamps)
{
  std::vector<KnownLamp> known;
  if (lamps.size() > MaximumKnownLamps)
  {
    return known;
  }
  for (const Lamp& lamp : lamps)
  {
    const double* fading = lamp.Light->GetAttenuationValues();
    // VTK compares in single precision.
    known.push_back(
      { lamp.Scatters(), f64::airlightIsDirectional(lamp.Values), lamp.Values.goniometric != 0,
        lamp.Light->GetPositional() != 0, static_cast<float>(lamp.Light->GetConeAngle()) < 90.0f,
        fading[0] == 0.0 && fading[1] == 0.0 && fading[2] == 1.0 });
  }
  return known;
}

namespace
{
// The light that arrives from a lamp, for AirlightSurface.glsl.
std::string Share(const KnownLamp& lamp, const std::string& index)
{
  if (!lamp.Scatters)
  {
    return "vec3(1.0)";
  }
  const std::string passed = lamp.Sun ? "airlightPassed(" + index + ", true, point)"
    : lamp.Positional && !lamp.Goniometric
    ? "AIRLIGHT_PASSED_FROM(" + index + ", lightPositionVC" + index + ", point)"
    : "airlightPassed(" + index + ", false, point)";
  return "airlightShare(" + index + ", " + passed + ")";
}
}

//------------------------------------------------------------------------------
// A loop of a length that the compiler does not know, and arrays in it, cost several times as much.
std::string DefineLamps(const std::vector<KnownLamp>& known, int apart)
{
  std::string lines;
  for (size_t k = 0; k < known.size() && known.size() <= MaximumOwnLines; ++k)
  {
    const std::string index = std::to_string(k);
    lines += " airlightArrived[" + index +
      "] = " + (static_cast<int>(k) == apart ? "airlightApart * " : "") + Share(known[k], index) +
      ";";
  }
  return lines.empty() ? "" : "#define AIRLIGHT_EACH_LAMP(point)" + lines + "\n";
}

namespace
{
// Of a uniform's name; that itself where it is to be asked.
std::string Tell(const std::string& name, const std::string& what, const KnownLamp& lamp)
{
  if (what == "Positional")
  {
    return lamp.Positional ? "1" : "0";
  }
  if (what == "ConeAngle")
  {
    return lamp.Spot ? name : "90.0";
  }
  return lamp.InverseSquare ? "vec3(0.0, 0.0, 1.0)" : name;
}
}

//------------------------------------------------------------------------------
std::string TellTypes(const std::string& body, const std::vector<KnownLamp>& known)
{
  static const std::regex type("\\blight(Positional|ConeAngle|Attenuation)([0-9]+)\\b");
  std::string told;
  auto rest = body.begin();
  for (std::sregex_iterator it(body.begin(), body.end(), type), end; it != end; ++it)
  {
    const std::smatch& match = *it;
    const size_t k = std::stoul(match[2]);
    told.append(rest, match[0].first);
    told += k < known.size() ? Tell(match.str(), match[1], known[k]) : match.str();
    rest = match[0].second;
  }
  return told.append(rest, body.end());
}
}
