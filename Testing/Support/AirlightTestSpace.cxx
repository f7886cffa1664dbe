// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestSpace.h"

namespace airlight_test
{
//------------------------------------------------------------------------------
void SetRandomMedium(vtkParticipatingMedium* medium, Random& random, int i)
{
  medium->SetScattering(
    random.LogUniform(1e-2, 3.0), random.LogUniform(1e-2, 3.0), random.LogUniform(1e-2, 3.0));
  medium->SetAbsorption(random.LogUniform(1e-2, 3.0), 0.0, random.LogUniform(1e-2, 3.0));
  if (i % 20 == 0)
  {
    medium->SetPhaseFunctionToHenyeyGreenstein();
    medium->SetAnisotropy(i % 40 == 0 ? 0.0 : random.Uniform(-0.9, 0.9));
  }
}

//------------------------------------------------------------------------------
double InsideLength(vtkParticipatingMedium* medium, const glm::dvec3& a, const glm::dvec3& b)
{
  const double length = glm::length(b - a);
  if (medium->GetRegion() == vtkParticipatingMedium::UNBOUNDED)
  {
    return length;
  }
  const double* bounds = medium->GetBounds();
  std::vector<double> cuts = { 0.0, 1.0 };
  for (int i = 0; i < 6; ++i)
  {
    const double cut = (bounds[i] - a[i / 2]) / (b[i / 2] - a[i / 2]);
    if (cut > 0.0 && cut < 1.0)
    {
      cuts.push_back(cut);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  double share = 0.0;
  for (size_t i = 1; i < cuts.size(); ++i)
  {
    const glm::dvec3 p = a + 0.5 * (cuts[i - 1] + cuts[i]) * (b - a);
    const bool inside = p.x > bounds[0] && p.x < bounds[1] && p.y > bounds[2] && p.y < bounds[3] &&
      p.z > bounds[4] && p.z < bounds[5];
    share += inside ? cuts[i] - cuts[i - 1] : 0.0;
  }
  return share * length;
}

//------------------------------------------------------------------------------
glm::dvec2 InsideRange(vtkParticipatingMedium* medium, const PointCase& c)
{
  const double end = std::min(c.T1, 1e4); // far beyond all boxes and all extinction here
  if (medium->GetRegion() == vtkParticipatingMedium::UNBOUNDED)
  {
    return { c.T0, end };
  }
  const auto at = [&](double t) { return c.Origin + t * c.Direction; };
  const double all = InsideLength(medium, at(c.T0), at(end));
  // Inside is one piece: bisect for where it begins.
  double before = c.T0;
  double after = end;
  for (int i = 0; i < 200 && all > 0.0; ++i)
  {
    const double middle = 0.5 * (before + after);
    (InsideLength(medium, at(c.T0), at(middle)) > 0.0 ? after : before) = middle;
  }
  return { after, after + all };
}

//------------------------------------------------------------------------------
// Airlight per unit intensity in one channel: the integral over the ray's part in the medium of
// sigmaS p(cosTheta)/(a + b r + c r^2) exp(-sigmaT (lengths inside the medium)).
static double PointLightInSpace(vtkParticipatingMedium* medium, const PointCase& c, int channel)
{
  const double sigmaT = medium->GetExtinction()[channel];
  const HenyeyGreensteinPhase phase{ medium->GetAnisotropy() };
  const glm::dvec2 range = InsideRange(medium, c);
  const double tL = glm::dot(c.Light - c.Origin, c.Direction);
  const double h = glm::length(c.Light - c.Origin - tL * c.Direction);
  const auto integrand = [&](double x) {
    const glm::dvec3 point = c.Origin + (tL + x) * c.Direction;
    const double r = std::sqrt(h * h + x * x);
    const double depth =
      sigmaT * (InsideLength(medium, c.Origin, point) + InsideLength(medium, point, c.Light));
    const double fall = c.Attenuation.x + c.Attenuation.y * r + c.Attenuation.z * r * r;
    return phase(1.0 + x / r, 1.0 - x / r) * std::exp(-depth) / fall;
  };
  const double end = std::min(range.y, range.x + 100.0 / sigmaT); // e^-100 is left beyond
  // Dense fog lets light in only near its surface: more panels towards both ends.
  std::vector<long double> ends = PeakPanels(range.x - tL, end - tL, h);
  for (double part = 0.1; part > 1e-9; part *= 0.1)
  {
    ends.push_back(range.x - tL + part * (end - range.x));
    ends.push_back(end - tL - part * (end - range.x));
  }
  std::sort(ends.begin(), ends.end());
  return medium->GetScattering()[channel] * Integrate(integrand, ends, 1e-12);
}

//------------------------------------------------------------------------------
void ComparePoint(vtkParticipatingMedium* medium, const PointCase& c, const double rgb[3],
  const double intensity[3], double limit, Comparison& comparison)
{
  const double* bounds = medium->GetBounds();
  for (int i = 0; i < 3; ++i)
  {
    const double expected = intensity[i] * PointLightInSpace(medium, c, i);
    comparison.Add(
      std::abs(rgb[i] - expected) / expected, medium->GetPhaseErrorBound() + limit, [&] {
        return Text("channel ", i, ": expected ", expected, ", got ", rgb[i], "; sigmaT ",
          medium->GetExtinction()[i], ", g ", medium->GetAnisotropy(), ", box ", Text3(bounds), " ",
          Text3(bounds + 3), ", ", c.Describe());
      });
  }
}
}
