// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
// The light of suns that was scattered more than once: Eddington's approximation against the
// equations that it solves, and the closed integral of rays against sums over many steps.

#include "AirlightTestExpect.h"
#include "AirlightTestSingle.h"
#include "Medium/AirlightConvert.h"
#include "MultipleScattering/AirlightLayeredSolution.h"

#include "vtkAirlight.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <random>

using namespace airlight;
using namespace airlight_test;

namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

// The radiance i0 + i1 mu of one set of terms.
struct Layers
{
  double Albedo;
  double Cosine;
  double Sun;
  double End;
  double Ground = 0.0;
  LayerTerms Terms = SolveLayers(Albedo, Cosine, Sun, End, Ground);

  double Sum(double depth, double fall, double climb, double beam) const
  {
    const double rate = std::sqrt(3.0 * (1.0 - Albedo) * (1.0 - Albedo * Cosine));
    return fall * Terms.Fall * std::exp(-rate * depth) +
      (End < Infinity ? climb * Terms.Climb * std::exp(-rate * (End - depth)) : 0.0) -
      beam * std::exp(-depth / Sun);
  }
  double Even(double depth) const { return Sum(depth, 1.0, 1.0, Terms.Beam); }
  double Down(double depth) const
  {
    const double flux = std::sqrt(3.0 * (1.0 - Albedo) / (1.0 - Albedo * Cosine));
    return Sum(depth, flux, -flux, Terms.BeamFlux);
  }
};

// The flux changes by what is absorbed and what the beam feeds; the mean by the flux; nothing
// enters.
void CheckGround()
{
  for (const double albedo : { 0.5, 0.95, MaximumLayerAlbedo })
  {
    for (const double ground : { 0.0, 0.3, 1.0 })
    {
      const Layers layers{ albedo, 0.3, 0.7, 1.4, ground };
      const double arrives =
        layers.Even(1.4) + 0.7104 * layers.Down(1.4) + 0.7 / vtkMath::Pi() * std::exp(-1.4 / 0.7);
      const double leaves = layers.Even(1.4) - 0.7104 * layers.Down(1.4);
      Expect(std::abs(leaves - ground * arrives) < 1e-9, "the ground reflects", albedo, ground,
        leaves, arrives);
    }
  }
}

void CheckEquations()
{
  for (const double albedo : { 0.0, 0.3, 0.9, 0.99, MaximumLayerAlbedo })
  {
    for (const double cosine : { -0.5, 0.0, 0.46 })
    {
      for (const double sun : { 0.05, 0.41, 1.0 })
      {
        for (const double end : { 0.1, 2.0, 15.0, Infinity })
        {
          const Layers layers{ albedo, cosine, sun, end };
          const double depth = 0.4 * std::min(end, 3.0);
          const double step = 1e-4 * std::min(depth, sun);
          const auto slope = [&](auto of) {
            return (of(depth + step) - of(depth - step)) / (2.0 * step);
          };
          const double beam = 3.0 * albedo / (4.0 * vtkMath::Pi()) * std::exp(-depth / sun);
          const double flux = slope([&](double x) { return layers.Down(x); }) +
            3.0 * (1.0 - albedo) * layers.Even(depth) - beam;
          const double mean = slope([&](double x) { return layers.Even(x); }) +
            (1.0 - albedo * cosine) * layers.Down(depth) - cosine * sun * beam;
          Expect(std::abs(flux) < 1e-6 && std::abs(mean) < 1e-6, "the equations hold", albedo,
            cosine, sun, end, flux, mean);
          Expect(std::abs(layers.Even(0.0) + 0.7104 * layers.Down(0.0)) < 1e-9,
            "no light enters at the lit side", albedo, cosine, sun, end);
          Expect(end == Infinity || std::abs(layers.Even(end) - 0.7104 * layers.Down(end)) < 1e-9,
            "nor at the other", albedo, cosine, sun, end);
          Expect(layers.Even(depth) >= 0.0, "no negative light", albedo, cosine, sun, end);
        }
      }
    }
  }
}

struct Scene
{
  vtkNew<vtkParticipatingMedium> Medium;
  vtkNew<vtkLight> Light;
  f64::AirlightMedia Media;
  double G;

  // The direction to the sun; a box of bounds -2 to 3, or fog of scale height 1.5.
  Scene(bool box, double g, const glm::dvec3& towards)
    : G(g)
  {
    this->Medium->SetScattering(0.3, 0.6, 0.2);
    this->Medium->SetAbsorption(0.1, 0.0, 0.3);
    this->Medium->SetPhaseFunctionToHenyeyGreenstein();
    this->Medium->SetAnisotropy(g);
    this->Medium->MultipleScatteringOn();
    if (box)
    {
      this->Medium->SetRegionToBox();
      this->Medium->SetBounds(-2.0, 3.0, -2.0, 3.0, -2.0, 3.0);
    }
    else
    {
      this->Medium->SetDensityToExponentialHeight();
      this->Medium->SetUp(0.0, 0.0, 1.0);
      this->Medium->SetScaleHeight(1.5);
    }
    const double irradiance[3] = { 2.0, 3.0, 4.0 };
    vtkAirlight::SetIrradiance(this->Light, irradiance);
    this->Light->SetPosition(towards.x, towards.y, towards.z);
    this->Light->SetFocalPoint(0.0, 0.0, 0.0);
    this->Media = ConvertMedia({ this->Medium }, glm::dvec3(0.0));
    this->Add();
  }

  // Ground 2 below the origin.
  void SetGround(bool on)
  {
    this->Medium->SetGround(on);
    this->Medium->SetGroundHeight(-2.0);
    this->Media = ConvertMedia({ this->Medium }, glm::dvec3(0.0));
    this->Add();
  }

  void Add()
  {
    f64::AirlightLight light;
    Check(ConvertLight(this->Media, this->Light, glm::dvec3(0.0), light) == LightSupport::Scatters,
      "the sun scatters");
    Check(AddMultipleLamp(this->Media, light) && this->Media.multiple.suns == 1,
      "the sun is scattered more than once");
  }

  glm::dvec4 Row(int row) const { return this->Media.multiple.sun[row]; }

  bool IsBox() const { return this->Media.item[0].region.kind == AIRLIGHT_REGION_BOX; }

  // By that where it is 1.
  double Density(const glm::dvec3& point) const
  {
    return this->IsBox() ? 1.0 : std::exp(-point.z / 1.5);
  }

  // The way, of density 1, below the lit side.
  double Depth(const glm::dvec3& point) const
  {
    const glm::dvec4 layers = this->Row(AIRLIGHT_SUN_LAYERS);
    return this->IsBox() ? layers.w - glm::dot(glm::dvec3(layers), point)
                         : 1.5 * std::exp(-point.z / 1.5);
  }

  // Of light that was scattered forward twice.
  double Lobe(const glm::dvec3& direction) const
  {
    const double lobe = this->G > 0.0 ? this->G * this->G : 0.0;
    const double cosTheta = glm::dot(glm::dvec3(this->Row(AIRLIGHT_SUN_DIRECTION)), direction);
    return (1.0 - lobe * lobe) / (4.0 * vtkMath::Pi()) /
      std::pow(1.0 + lobe * lobe - 2.0 * lobe * cosTheta, 1.5);
  }

  // Of one channel: the source function by the terms, in the light that the eye gets from `point`.
  double Source(const glm::dvec3& point, const glm::dvec3& direction, int channel) const
  {
    const f64::AirlightMedium& medium = this->Media.item[0];
    const f64::AirlightMultiple& multiple = this->Media.multiple;
    const double sigma = medium.sigmaT[channel];
    const double scale = multiple.layerScale[channel];
    const double depth = scale * sigma * this->Depth(point);
    const double sun = this->Row(AIRLIGHT_SUN_DIRECTION).w;
    const Layers layers{ multiple.layerAlbedo[channel], multiple.layerCosine, sun,
      this->IsBox() ? 5.0 * sigma * scale : Infinity };
    // Of the light's way down.
    const double mu = glm::dot(glm::dvec3(this->Row(AIRLIGHT_SUN_LAYERS)), direction);
    const double diffuse =
      scale * layers.Albedo * (layers.Even(depth) + layers.Cosine * mu * layers.Down(depth));
    const double forward =
      this->Lobe(direction) * medium.sigmaS[channel] / sigma * std::exp(-depth / sun);
    return this->Density(point) * sigma * (diffuse + forward);
  }

  // Without the single scattering that is in the source's forward light.
  glm::dvec3 Sum(const glm::dvec3& origin, const glm::dvec3& direction, double end) const
  {
    const f64::AirlightMedium& medium = this->Media.item[0];
    glm::dvec3 sum(0.0);
    constexpr int steps = 200000;
    const double dt = end / steps;
    const double sun = this->Row(AIRLIGHT_SUN_DIRECTION).w;
    for (int channel = 0; channel < 3; ++channel)
    {
      const double sigma = medium.sigmaT[channel];
      const double scale = this->Media.multiple.layerScale[channel];
      double before = 0.0;
      for (int i = 0; i < steps; ++i)
      {
        const glm::dvec3 point = origin + (i + 0.5) * dt * direction;
        const double density = this->Density(point);
        before += 0.5 * density * sigma * dt;
        sum[channel] += dt *
          (this->Source(point, direction, channel) * std::exp(-scale * before) -
            density * medium.sigmaS[channel] * this->Lobe(direction) *
              std::exp(-sigma * this->Depth(point) / sun - before));
        before += 0.5 * density * sigma * dt;
      }
    }
    return sum * glm::dvec3(this->Row(AIRLIGHT_SUN_IRRADIANCE)) *
      glm::dvec3(this->Row(AIRLIGHT_SUN_SHARE));
  }
};

void CheckRays()
{
  std::mt19937 random(811);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  double worst = 0.0;
  double worstSingle = 0.0;
  for (int i = 0; i < 24; ++i)
  {
    const double gs[] = { 0.0, 0.6, 0.85, -0.4 };
    const glm::dvec3 towards =
      glm::normalize(glm::dvec3(uniform(random), uniform(random), i % 2 + 0.5 * uniform(random)));
    const bool box = i % 2 == 0;
    const Scene scene(box, gs[i / 2 % 4], towards);
    const glm::dvec3 origin(0.5 * uniform(random), 0.5 * uniform(random), uniform(random));
    const double level = i % 5 == 0 ? 0.0 : 1.0;
    const glm::dvec3 direction =
      glm::normalize(glm::dvec3(uniform(random), uniform(random), level * uniform(random)));
    const double end = box ? 1.0 : 4.0;
    const glm::dvec3 found =
      f64::airlightMultipleAlong(scene.Media.multiple, scene.Media, 0, origin, direction, end)
        .several;
    const glm::dvec3 expected = scene.Sum(origin, direction, end);
    const f32::AirlightMedia single = ToSingle(scene.Media);
    const glm::vec3 inSingle = f32::airlightMultipleAlong(
      single.multiple, single, 0, glm::vec3(origin), glm::vec3(direction), static_cast<float>(end))
                                 .several;
    for (int channel = 0; channel < 3; ++channel)
    {
      worst = std::max(worst, std::abs(found[channel] / expected[channel] - 1.0));
      worstSingle = std::max(worstSingle, std::abs(inSingle[channel] / found[channel] - 1.0));
    }
  }
  std::cout << "rays: " << worst << ", in single precision " << worstSingle << "\n";
  Expect(worst < 1e-6, "rays are their steps' sums", worst);
  Expect(worstSingle < 2e-4, "rays in single precision", worstSingle);
}

// Extreme views, suns and media give finite light.
void CheckLimits()
{
  for (const bool box : { false, true })
  {
    for (const double height : { 1.0, 1e-3, 1e-9, 0.0, -0.2 })
    {
      const glm::dvec3 towards = glm::normalize(glm::dvec3(1.0, 0.5, height));
      if (!box && height <= 0.0)
      {
        continue; // the sun has set
      }
      Scene scene(box, 0.85, towards);
      scene.SetGround(height > 0.5);
      for (const double up : { 1.0, 1e-12, 0.0, -1e-12, -1.0 })
      {
        for (const double level : { -80.0, -2.0, 0.0, 50.0 })
        {
          const glm::dvec3 rgb = f64::airlightMultipleAlong(scene.Media.multiple, scene.Media, 0,
            glm::dvec3(0.1, 0.2, level), glm::normalize(glm::dvec3(1.0, 0.0, up)), AIRLIGHT_FAR)
                                   .several;
          const f32::AirlightMedia single = ToSingle(scene.Media);
          const glm::vec3 inSingle = f32::airlightMultipleAlong(single.multiple, single, 0,
            glm::vec3(0.1f, 0.2f, static_cast<float>(level)),
            glm::normalize(glm::vec3(1.0f, 0.0f, static_cast<float>(up))), 1e18f)
                                       .several;
          for (int channel = 0; channel < 3; ++channel)
          {
            Expect(rgb[channel] >= 0.0 && rgb[channel] < 10.0 && inSingle[channel] >= 0.0f &&
                inSingle[channel] < 10.0f,
              "light is finite", box, height, up, level, rgb[channel], inSingle[channel]);
          }
        }
      }
    }
  }
  Scene scene(false, 0.0, glm::dvec3(0.0, 0.0, 1.0));
  f64::AirlightLight light;
  ConvertLight(scene.Media, scene.Light, glm::dvec3(0.0), light);
  for (int i = 1; i < AIRLIGHT_MAX_MULTIPLE_SUNS; ++i)
  {
    Expect(AddMultipleLamp(scene.Media, light), "several suns", i);
  }
  Expect(!AddMultipleLamp(scene.Media, light), "one sun too many is refused");
  light.position = glm::dvec3(0.0, 0.0, -1.0);
  scene.Media.multiple.suns = scene.Media.multiple.count = 0;
  Expect(AddMultipleLamp(scene.Media, light) && scene.Media.multiple.count == 0,
    "a sun that has set gives nothing");
  scene.Medium->SetDensityToUniform();
  scene.Media = ConvertMedia({ scene.Medium }, glm::dvec3(0.0));
  Expect(!AddMultipleLamp(scene.Media, light), "suns in unbounded uniform media are refused");
}

// On a level surface deep in fog light comes evenly from both sides.
void CheckIrradiance()
{
  const Scene scene(false, 0.0, glm::dvec3(0.0, 0.6, 0.8));
  const auto find = [&](double height, const glm::dvec3& normal) {
    return f64::airlightMultipleIrradiance(
      scene.Media.multiple, scene.Media, glm::dvec3(0.0, 0.0, height), normal)
      .x;
  };
  const glm::dvec3 up(0.0, 0.0, 1.0);
  const double above = find(-1.0, up);
  const double below = find(-1.0, -up);
  // The net flux is what is absorbed below: of the beam's, by the flux's equation.
  const Layers layers{ 0.75, 0.0, 0.8, Infinity };
  const double depth = 0.4 * 1.5 * std::exp(1.0 / 1.5);
  const double net = 4.0 * vtkMath::Pi() / 3.0 * layers.Down(depth) * 2.0;
  Expect(std::abs((above - below) / net - 1.0) < 1e-9, "the net flux", above, below, net);
  Expect(find(-30.0, up) < 1e-6 && find(20.0, up) < 0.05 * above, "none far below and above",
    find(-30.0, up), find(20.0, up));
}
}

int TestLayeredScattering(int, char*[])
{
  CheckEquations();
  CheckGround();
  CheckRays();
  CheckLimits();
  CheckIrradiance();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
