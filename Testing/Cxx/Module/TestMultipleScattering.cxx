// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
// Multiple scattering: the exact solution of the unbounded medium against identities, a Monte Carlo
// simulation and the theory of diffusion; its fit and the quadrature of rays against the solution.

#include "AirlightTestErrors.h"
#include "AirlightTestExpect.h"
#include "AirlightTestSingle.h"
#include "Medium/AirlightConvert.h"
#include "MultipleScattering/AirlightLegendreMoments.h"
#include "MultipleScattering/AirlightUnboundedSolution.h"

#include "vtkAirlight.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <random>

using namespace airlight;
using namespace airlight_test;

namespace
{
double HenyeyGreenstein(double g, double mu)
{
  return (1.0 - g * g) / (4.0 * vtkMath::Pi() * std::pow(1.0 + g * g - 2.0 * g * mu, 1.5));
}

UnboundedSolution Solve(double albedo, double g)
{
  return UnboundedSolution(
    albedo, GetLegendreMoments([g](double mu) { return HenyeyGreenstein(g, mu); }));
}

void CheckMoments()
{
  for (const double g : { 0.0, -0.6, 0.5, 0.85, 0.95 })
  {
    const std::vector<double> moments =
      GetLegendreMoments([g](double mu) { return HenyeyGreenstein(g, mu); });
    double worst = 0.0;
    for (size_t l = 0; l < moments.size(); ++l)
    {
      worst = std::max(worst, std::abs(moments[l] - std::pow(g, static_cast<double>(l))));
    }
    Expect(moments.size() > 4 && worst < 1e-12, "Legendre moments are powers of g", g, worst);
  }
  Expect(GetLegendreMoments([](double mu) { return HenyeyGreenstein(0.99, mu); }).empty(),
    "moments that do not end are refused");
}

// Decay far away, of three albedos and anisotropies, from the roots of the transport equation's
// dispersion relation; for isotropic scattering kappa = c artanh(kappa).
void CheckDecay()
{
  const double albedos[] = { 0.5, 0.9, 0.99 };
  const double known[3][3] = { { 0.95750, 0.52543, 0.17251 }, { 0.82799, 0.38562, 0.12243 },
    { 0.66119, 0.23713, 0.068 } };
  const double anisotropies[] = { 0.0, 0.5, 0.85 };
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      const double kappa = Solve(albedos[j], anisotropies[i]).GetSlowestDecay();
      Expect(std::abs(kappa - known[i][j]) < 1e-5, "the slowest decay", kappa, known[i][j]);
    }
    const double kappa = Solve(albedos[i], 0.0).GetSlowestDecay();
    Expect(std::abs(kappa - albedos[i] * std::atanh(kappa)) < 1e-9, "c artanh kappa", kappa);
  }
  Expect(Solve(1.0, 0.5).GetSlowestDecay() == 0.0, "light that is not absorbed");
}

// Without absorption all power passes each sphere: 4 pi r^2 times the flux, and exp(-r) that was
// not scattered. Diffusion has 3 (1 - g)/(4 pi r) far away.
void CheckConservation()
{
  for (const double g : { 0.0, 0.5, 0.85, 0.95 })
  {
    const UnboundedSolution solution = Solve(1.0, g);
    for (const double r : { 0.05, 0.1, 0.3, 1.0, 3.0, 10.0, 20.0 })
    {
      const double power =
        4.0 * vtkMath::Pi() * r * r * solution.GetRadialMoments(r)[1] + std::exp(-r);
      Expect(std::abs(power - 1.0) < 2e-6, "power through a sphere", g, r, power - 1.0);
    }
    const double far = 50.0 / (1.0 - g);
    const double fluence = solution.GetRadialMoments(far)[0];
    const double diffusion = 3.0 * (1.0 - g) / (4.0 * vtkMath::Pi() * far);
    Expect(std::abs(fluence / diffusion - 1.0) < 1e-3, "diffusion", g, fluence / diffusion);
  }
}

// Fluence, flux and second moment in shells that reach 5 % to both sides, by a simulation of 1e6
// paths that shares nothing with the solution: what it found, and its standard error.
void CheckSimulation()
{
  struct Row
  {
    double Albedo, G, R, Found[3], Error[3];
  };
  const Row rows[] = {
    { 0.5, 0.0, 1.0, { 0.0294566, 0.0140998, 0.00907424 }, { 9e-5, 5.6e-5, 6.5e-5 } },
    { 0.5, 0.0, 3.0, { 0.00128015, 0.000652804, 0.000425315 }, { 3.1e-6, 2.8e-6, 2.3e-6 } },
    { 0.9, 0.0, 3.0, { 0.0137063, 0.00389478, 0.00178353 }, { 1.9e-5, 7.4e-6, 7.7e-6 } },
    { 0.99, 0.0, 3.0, { 0.0465291, 0.00748631, 0.00268801 }, { 5.1e-5, 2.5e-5, 1.7e-5 } },
    { 0.9, 0.5, 3.0, { 0.0111604, 0.00498632, 0.00264704 }, { 1.4e-5, 1.1e-5, 6.2e-6 } },
    { 0.9, 0.85, 1.0, { 0.0492734, 0.0422283, 0.0371315 }, { 2.2e-4, 1.9e-4, 1.6e-4 } },
    { 0.9, 0.85, 3.0, { 0.00755342, 0.00581862, 0.00462379 }, { 1.5e-5, 1.2e-5, 9.6e-6 } },
    { 0.9, 0.85, 6.0, { 0.00153264, 0.00102723, 0.000695113 }, { 1.6e-6, 1.1e-6, 1.2e-6 } },
  };
  for (const Row& row : rows)
  {
    const UnboundedSolution solution = Solve(row.Albedo, row.G);
    double sum[3] = { 0.0, 0.0, 0.0 };
    double volume = 0.0;
    for (int i = 0; i < 16; ++i)
    {
      const double r = row.R * (0.95 + 0.1 * (i + 0.5) / 16.0);
      const std::vector<double> moments = solution.GetRadialMoments(r);
      for (int l = 0; l < 3; ++l)
      {
        sum[l] += r * r * moments[l];
      }
      volume += r * r;
    }
    for (int l = 0; l < 3; ++l)
    {
      const double deviation = (sum[l] / volume - row.Found[l]) / row.Error[l];
      Expect(std::abs(deviation) < 4.0, "moments of a simulation", row.R, l, deviation);
    }
  }
}

// A ray's multiply scattered light of a lamp of power 1 at `lamp`, seen from the origin along x, in
// optical lengths: on panels in t, of which the shortest are beside the lamp's foot.
double IntegrateRay(const UnboundedSolution& solution, const glm::dvec3& lamp, double end)
{
  const double h = std::hypot(lamp.y, lamp.z);
  std::vector<double> ends = { 0.0, end };
  for (double step = 0.5 * h; step < end + std::abs(lamp.x); step *= 2.0)
  {
    for (const double t : { lamp.x - step, lamp.x, lamp.x + step })
    {
      if (t > 0.0 && t < end)
      {
        ends.push_back(t);
      }
    }
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  const double nodes[] = { 0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
    0.9602898564975363 };
  const double weights[] = { 0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
    0.1012285362903763 };
  double sum = 0.0;
  for (size_t panel = 1; panel < ends.size(); ++panel)
  {
    const double middle = 0.5 * (ends[panel] + ends[panel - 1]);
    const double half = 0.5 * (ends[panel] - ends[panel - 1]);
    for (int k = 0; k < 8; ++k)
    {
      const double t = middle + (k % 2 == 0 ? half : -half) * nodes[k / 2];
      const double r = std::hypot(h, t - lamp.x);
      sum += half * weights[k / 2] * std::exp(-t) *
        solution.GetSource(solution.GetRadialMoments(std::max(r, 0.05)), (lamp.x - t) / r) *
        (r < 0.05 ? 0.05 / r : 1.0);
    }
  }
  return sum;
}

// Random rays in a medium with a mean free path of `scale`.
void CheckRays(double albedo, double g, int count, double allowed)
{
  const double scale = 2.5;
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetScattering(albedo / scale, albedo / scale, albedo / scale);
  medium->SetAbsorption((1.0 - albedo) / scale, (1.0 - albedo) / scale, (1.0 - albedo) / scale);
  medium->SetPhaseFunctionToHenyeyGreenstein();
  medium->SetAnisotropy(g);
  medium->SetMultipleScattering(true);
  const UnboundedSolution solution = Solve(albedo, g);
  std::mt19937 random(20261126);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const double intensity[3] = { 3.0, 1.0, 0.5 };
  int outside = 0;
  int singleOff = 0;
  double worst = 0.0;
  for (int i = 0; i < count; ++i)
  {
    const double distance = 0.1 * std::pow(100.0, uniform(random));
    const double angle = vtkMath::Pi() * (i % 2 == 0 ? uniform(random) : 0.2 * uniform(random));
    const double turn = 2.0 * vtkMath::Pi() * uniform(random);
    const glm::dvec3 lamp = distance *
      glm::dvec3(
        std::cos(angle), std::sin(angle) * std::cos(turn), std::sin(angle) * std::sin(turn));
    const bool ends = i % 3 == 0;
    const double end = ends ? distance * (0.1 + 2.9 * uniform(random)) : 30.0;
    const double exact =
      IntegrateRay(solution, lamp, end) * 4.0 * vtkMath::Pi() * intensity[0] / (scale * scale);
    const glm::dvec3 position = scale * lamp;
    const double origin[3] = { 0.0, 0.0, 0.0 };
    const double direction[3] = { 1.0, 0.0, 0.0 };
    const double t1 = ends ? scale * end : std::numeric_limits<double>::infinity();
    double found[3];
    double once[3];
    Expect(vtkAirlight::MultipleScattering(
             medium, &position.x, intensity, origin, direction, t1, found) &&
        vtkAirlight::Inscatter(medium, &position.x, intensity, origin, direction, 0.0, t1, once),
      "the ray is integrated");
    const double error = std::abs(found[0] - exact) / (exact + once[0]);
    worst = std::max(worst, error);
    outside += error > medium->GetMultipleScatteringErrorBound() + 0.005 ? 1 : 0;
    Expect(std::abs(found[1] / found[0] - 1.0 / 3.0) < 1e-12, "channels of a grey medium");

    // The shaders' precision.
    f64::AirlightMedia media = ConvertMedia({ medium }, glm::dvec3(0.0));
    f64::AirlightLight light = {};
    light.position = position;
    light.intensity = glm::dvec3(intensity[0], intensity[1], intensity[2]);
    light.attenuation = glm::dvec3(0.0, 0.0, 1.0);
    light.cosCone = -1.0;
    light.radius = 1e-6;
    Expect(AddMultipleLamp(media, light), "the lamp is taken");
    const f32::AirlightMedia single = ToSingle(media);
    const glm::vec3 inSingle = f32::airlightMultipleAlong(single.multiple, single, 0,
      glm::vec3(0.0f), glm::vec3(1.0f, 0.0f, 0.0f), static_cast<float>(std::min(t1, 1e18)))
                                 .several;
    singleOff += std::abs(inSingle.x / found[0] - 1.0) > 1e-4 ? 1 : 0;
  }
  std::cout << "albedo " << albedo << ", g " << g << ": largest error " << worst << ", fit "
            << medium->GetMultipleScatteringErrorBound() << "\n";
  Expect(worst < allowed, "rays in the unbounded medium", albedo, g, worst);
  Expect(outside == 0, "rays whose error is beyond the bound", albedo, g, outside);
  Expect(
    singleOff <= count / 50, "rays that single precision is off by more than 1e-4", g, singleOff);
}

// Channels that fade differently, each beside a grey medium of its own.
void CheckColours()
{
  const double sigma[3] = { 0.02, 0.4, 2.0 };
  const double albedo[3] = { 0.95, 0.6, 0.9 };
  const double lamp[3] = { 3.0, 20.0, 1.0 };
  const double intensity[3] = { 1.0, 1.0, 1.0 };
  const double origin[3] = { 0.0, 0.0, 0.0 };
  const double direction[3] = { 1.0, 0.2, 0.0 };
  const double far = std::numeric_limits<double>::infinity();
  vtkNew<vtkParticipatingMedium> medium;
  const auto fill = [&](int r, int g, int b) {
    medium->SetScattering(albedo[r] * sigma[r], albedo[g] * sigma[g], albedo[b] * sigma[b]);
    medium->SetAbsorption(
      (1.0 - albedo[r]) * sigma[r], (1.0 - albedo[g]) * sigma[g], (1.0 - albedo[b]) * sigma[b]);
  };
  medium->MultipleScatteringOn();
  double colours[3];
  fill(0, 1, 2);
  vtkAirlight::MultipleScattering(medium, lamp, intensity, origin, direction, far, colours);
  for (int k = 0; k < 3; ++k)
  {
    double grey[3];
    fill(k, k, k);
    vtkAirlight::MultipleScattering(medium, lamp, intensity, origin, direction, far, grey);
    Expect(grey[0] > 0.0 && std::abs(colours[k] / grey[0] - 1.0) < 1e-9,
      "a channel of a coloured medium", k, colours[k], grey[0]);
  }
}

// By the solution's moments, on both sides of a surface.
void CheckIrradiance()
{
  const double albedo = 0.8;
  const double g = 0.4;
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetScattering(0.5 * albedo, 0.5 * albedo, 0.5 * albedo);
  medium->SetAbsorption(0.5 * (1.0 - albedo), 0.5 * (1.0 - albedo), 0.5 * (1.0 - albedo));
  medium->SetPhaseFunctionToHenyeyGreenstein();
  medium->SetAnisotropy(g);
  medium->SetMultipleScattering(true);
  const UnboundedSolution solution = Solve(albedo, g);
  const double lamp[3] = { 1.0, 2.0, 3.0 };
  const double intensity[3] = { 2.0, 2.0, 2.0 };
  const double normal[3] = { 0.0, 0.0, 2.0 };
  for (const double r : { 0.2, 1.0, 4.0, 15.0 })
  {
    for (const double cosine : { -0.9, 0.1, 0.8 })
    {
      const double sine = std::sqrt(1.0 - cosine * cosine);
      const double point[3] = { 1.0 + r * sine, 2.0, 3.0 - r * cosine };
      double found[3];
      vtkAirlight::MultipleIrradiance(medium, lamp, intensity, point, normal, found);
      const std::vector<double> moments = solution.GetRadialMoments(0.5 * r);
      const double exact =
        std::max(0.25 * moments[0] + 0.5 * cosine * moments[1], 0.0) * 0.25 * 8.0 * vtkMath::Pi();
      Expect(std::abs(found[0] - exact) <= 2e-3 * (exact + 0.25 * moments[0]), "irradiance", r,
        cosine, found[0], exact);
    }
  }
}

// Fog whose scale height is far greater than all distances is uniform.
void CheckHighFog()
{
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetScattering(0.4, 0.3, 0.2);
  medium->SetAbsorption(0.05, 0.2, 0.05);
  medium->SetPhaseFunctionToHenyeyGreenstein();
  medium->SetAnisotropy(0.5);
  medium->MultipleScatteringOn();
  const double lamp[3] = { 1.0, -2.0, 0.5 };
  const double intensity[3] = { 1.0, 2.0, 3.0 };
  const double normal[3] = { 0.0, 0.6, 0.8 };
  std::mt19937 random(20261127);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int i = 0; i < 40; ++i)
  {
    const double origin[3] = { 8.0 * uniform(random), 8.0 * uniform(random),
      8.0 * uniform(random) };
    const double direction[3] = { uniform(random), uniform(random), uniform(random) };
    const double t1 = i % 2 == 0 ? 12.0 : std::numeric_limits<double>::infinity();
    double found[2][3];
    double arriving[2][3];
    for (const int fog : { 0, 1 })
    {
      medium->SetDensityToUniform();
      if (fog == 1)
      {
        medium->SetDensityToExponentialHeight();
        medium->SetScaleHeight(1e7);
      }
      Expect(vtkAirlight::MultipleScattering(
               medium, lamp, intensity, origin, direction, t1, found[fog]) &&
          vtkAirlight::MultipleIrradiance(medium, lamp, intensity, origin, normal, arriving[fog]),
        "a lamp in fog");
    }
    for (int k = 0; k < 3; ++k)
    {
      Expect(std::abs(found[1][k] / found[0][k] - 1.0) < 0.01, "a ray in high fog", i, k,
        found[1][k], found[0][k]);
      Expect(std::abs(arriving[1][k] - arriving[0][k]) <= 1e-5 * arriving[0][k],
        "a surface in high fog", i, k, arriving[1][k], arriving[0][k]);
    }
  }
}

// Lamps deep in fog and high above it, and eyes there.
void CheckDeepFog()
{
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetScattering(0.4, 0.0, 4.0);
  medium->SetAbsorption(0.0, 0.2, 0.0);
  medium->MultipleScatteringOn();
  medium->SetDensityToExponentialHeight();
  medium->SetScaleHeight(0.5);
  const double intensity[3] = { 1.0, 1.0, 1.0 };
  for (const double lampHeight : { -300.0, -5.0, 0.0, 5.0, 300.0 })
  {
    for (const double eyeHeight : { -300.0, 0.0, 5.0, 300.0 })
    {
      for (const double rise : { -1.0, 0.0, 1e-9, 1.0 })
      {
        const double lamp[3] = { 0.0, lampHeight, 0.0 };
        const double eye[3] = { 0.3, eyeHeight, 0.0 };
        const double direction[3] = { 1.0, rise, 0.2 };
        double rgb[2][3];
        Expect(vtkAirlight::MultipleScattering(medium, lamp, intensity, eye, direction,
                 std::numeric_limits<double>::infinity(), rgb[0]) &&
            vtkAirlight::MultipleIrradiance(medium, lamp, intensity, eye, direction, rgb[1]),
          "a lamp in deep fog");
        for (const auto& colour : rgb)
        {
          Expect(std::isfinite(colour[0]) && std::isfinite(colour[2]) && colour[0] >= 0.0 &&
              colour[2] >= 0.0 && colour[1] == 0.0,
            "finite", lampHeight, eyeHeight, rise, colour[0], colour[2]);
        }
      }
    }
  }
}

void CheckLimits()
{
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetScattering(0.3, 0.0, 0.2);
  medium->SetAbsorption(0.0, 0.4, 0.1);
  const double lamp[3] = { 1.0, 0.0, 0.0 };
  const double intensity[3] = { 1.0, 1.0, 1.0 };
  const double origin[3] = { 0.0, 0.0, 0.0 };
  const double direction[3] = { 1.0, 1.0, 0.0 };
  double rgb[3] = { 1.0, 1.0, 1.0 };
  Expect(vtkAirlight::MultipleScattering(medium, lamp, intensity, origin, direction, 5.0, rgb) &&
      rgb[0] == 0.0 && medium->GetMultipleScatteringErrorBound() == 0.0,
    "off by default");
  medium->MultipleScatteringOn();
  medium->SetAmbientRadiance(1.0, 1.0, 1.0);
  Expect(vtkAirlight::MultipleScattering(medium, lamp, intensity, origin, direction, 5.0, rgb) &&
      rgb[0] > 0.0 && rgb[1] == 0.0 && rgb[2] > 0.0,
    "a channel that only absorbs is dark");
  double ambient[3];
  vtkAirlight::Ambient(medium, origin, direction, 5.0, ambient);
  Expect(ambient[0] == 0.0, "it takes the ambient radiance's place");
  // The box takes light away, and a lamp outside it sends it less.
  double boxed[3];
  medium->SetRegionToBox();
  medium->SetBounds(-2.0, 2.0, -2.0, 2.0, -2.0, 2.0);
  vtkAirlight::MultipleScattering(medium, lamp, intensity, origin, direction, 1.0, boxed);
  medium->SetRegionToUnbounded();
  vtkAirlight::MultipleScattering(medium, lamp, intensity, origin, direction, 1.0, rgb);
  Expect(
    boxed[0] > 0.1 * rgb[0] && boxed[0] < 0.95 * rgb[0], "a box loses light", boxed[0], rgb[0]);
  medium->SetRegionToBox();
  const double outside[3] = { 5.0, 0.0, 0.0 };
  Expect(vtkAirlight::MultipleScattering(medium, outside, intensity, origin, direction, 1.0, rgb) &&
      rgb[0] > 0.0 && rgb[0] < boxed[0],
    "a lamp outside gives less light");
  // What it does not know, it says once for each change.
  ErrorListener errors(medium);
  medium->SetDensityToExponentialHeight();
  vtkAirlight::MultipleScattering(medium, lamp, intensity, origin, direction, 1.0, rgb);
  vtkAirlight::MultipleScattering(medium, lamp, intensity, origin, direction, 1.0, rgb);
  Expect(rgb[0] == 0.0 && errors.Take() == 1 &&
      errors.GetText().find("needs one medium alone: of uniform density") != std::string::npos,
    "a density that varies");
  medium->SetDensityToUniform();
  vtkNew<vtkParticipatingMedium> other;
  Expect(ConvertMedia({ medium, other }, glm::dvec3(0.0)).multiple.on == 0 && errors.Take() == 1,
    "two media");
  medium->SetPhaseFunctionToHenyeyGreenstein();
  medium->SetAnisotropy(0.99);
  vtkAirlight::MultipleScattering(medium, lamp, intensity, origin, direction, 1.0, rgb);
  Expect(rgb[0] == 0.0 && errors.Take() == 1 &&
      errors.GetText().find("too narrow a peak") != std::string::npos,
    "a narrow peak");
  medium->SetAnisotropy(0.8);
  Expect(
    !vtkAirlight::MultipleScattering(medium, outside, intensity, origin, direction, 1.0, rgb) &&
      rgb[0] == 0.0 && errors.Take() == 1 &&
      errors.GetText().find("the lamp at (5, 0, 0) has no light") != std::string::npos,
    "a lamp outside, in a medium that scatters forward");
  medium->SetAnisotropy(-0.9);
  Expect(medium->GetMultipleScatteringErrorBound() > 0.1 && errors.Take() == 1 &&
      errors.GetText().find("Multiple scattering is off by up to") != std::string::npos,
    "a bad fit is said", medium->GetMultipleScatteringErrorBound(), errors.GetText());
  medium->SetAnisotropy(0.3);
  // Lamps on the ray, a ray without length, extreme coefficients.
  medium->SetRegionToUnbounded();
  for (const double scale : { 1e-30, 1.0, 1e30 })
  {
    medium->SetScattering(scale, scale, scale);
    const double along[3] = { 1.0, 0.0, 0.0 };
    for (const double t1 : { 0.0, 1.0, std::numeric_limits<double>::infinity() })
    {
      Expect(vtkAirlight::MultipleScattering(medium, lamp, intensity, origin, along, t1, rgb) &&
          std::isfinite(rgb[0]) && rgb[0] >= 0.0,
        "finite", scale, t1, rgb[0]);
    }
  }
}
}

//------------------------------------------------------------------------------
int TestMultipleScattering(int, char*[])
{
  CheckMoments();
  CheckDecay();
  CheckConservation();
  CheckSimulation();
  for (const double albedo : { 0.5, 0.9, 0.99, 1.0 })
  {
    CheckRays(albedo, 0.0, 60, 0.01);
    CheckRays(albedo, 0.5, 60, 0.01);
    CheckRays(albedo, 0.85, 30, 0.01);
    CheckRays(albedo, 0.95, 8, 0.05);
  }
  CheckColours();
  CheckIrradiance();
  CheckHighFog();
  CheckDeepFog();
  CheckLimits();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
