// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestGoniometry.h"

#include <fstream>

namespace airlight_test
{
//------------------------------------------------------------------------------
LampTable ReadTable(const std::string& file)
{
  std::ifstream stream(file);
  std::string line;
  while (std::getline(stream, line) && line.compare(0, 4, "TILT") != 0)
  {
  }
  std::vector<double> head(13);
  const auto read = [&stream](std::vector<double>& numbers) {
    for (double& number : numbers)
    {
      stream >> number;
    }
  };
  read(head);
  LampTable table;
  table.Type = static_cast<int>(head[5]);
  table.Vertical.resize(static_cast<size_t>(head[3]));
  table.Horizontal.resize(static_cast<size_t>(head[4]));
  table.Candela.resize(table.Vertical.size() * table.Horizontal.size());
  read(table.Vertical);
  read(table.Horizontal);
  read(table.Candela);
  return table;
}

//------------------------------------------------------------------------------
double GoniometricAirlight(const TestFog& fog, const TestGoniometricLamp& lamp,
  const glm::dvec3& origin, const glm::dvec3& direction, double begin, double end, int channel)
{
  const glm::dvec2 range = fog.Clip(origin, direction, 0.0, end);
  const double sigmaT = fog.SigmaT[channel];
  const double t0 = std::max(range.x, begin);
  const double t1 = std::min(range.y, t0 + 60.0 / sigmaT);
  if (!(t1 > t0))
  {
    return 0.0;
  }
  const double tL = glm::dot(lamp.Position - origin, direction);
  const double h = std::max(glm::length(origin + tL * direction - lamp.Position), lamp.Radius);
  std::vector<long double> ends = PeakPanels(t0 - tL, t1 - tL, h);
  for (const double cut : lamp.FindCuts(origin, direction))
  {
    if (cut > t0 && cut < t1)
    {
      ends.push_back(cut - tL);
    }
  }
  std::sort(ends.begin(), ends.end());
  const HenyeyGreensteinPhase phase{ fog.G };
  const auto integrand = [&](double x) {
    const glm::dvec3 point = origin + (tL + x) * direction;
    const double r = std::sqrt(h * h + x * x);
    return phase(1.0 + x / r, 1.0 - x / r) * lamp.Share(point) / (r * r) *
      std::exp(-sigmaT * (tL + x - range.x + fog.Length(lamp.Position, point)));
  };
  return fog.SigmaS[channel] * lamp.Intensity[channel] * Integrate(integrand, ends, 1e-8);
}

//------------------------------------------------------------------------------
double GoniometricSurface(const TestFog& fog, const TestGoniometricLamp& lamp,
  const glm::dvec3& origin, const glm::dvec3& direction, double t, const glm::dvec3& normal,
  int channel)
{
  const glm::dvec3 point = origin + t * direction;
  const glm::dvec3 toLamp = lamp.Position - point;
  const glm::dvec3 towardsEye = glm::dot(normal, direction) > 0.0 ? -normal : normal;
  const double r = glm::length(toLamp);
  const double depth =
    fog.SigmaT[channel] * (fog.Length(origin, point) + fog.Length(lamp.Position, point));
  return lamp.Intensity[channel] / Pi * lamp.Share(point) *
    std::max(0.0, glm::dot(towardsEye, toLamp) / r) / (r * r) * std::exp(-depth);
}
}
