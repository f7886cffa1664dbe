// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Ambient light that two or three overlapping media scatter into a ray and what they emit, the
// shaders' text in double and in single precision, against adaptive quadrature of
//
//   sum_i (sigmaS_i a_i + e_i) rho_i(t) exp(-sum_i sigmaT_i D_i(t)),   D_i(t) = integral of rho_i over [0, t]
//
// with rho = exp(-height/scaleHeight) or 1. Extinctions of the channels differ by up to 1e5, scale
// heights and mean free paths by up to 1e8, and eyes are up to 60 scale heights above a fog.

#include "AirlightTestQuadrature.h"
#include "AirlightTestSingle.h"
#include "AirlightTestTools.h"

#include "Integration/AirlightMath.h"
#include "Medium/AirlightConvert.h"

#include "vtkNew.h"
#include "vtkParticipatingMedium.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

using namespace airlight_test;
using namespace airlight;

namespace
{
// One medium along the ray: all that the integral depends on.
struct Along
{
  glm::dvec3 SigmaS{ 0.0 };
  glm::dvec3 SigmaT{ 0.0 };
  glm::dvec3 Ambient{ 0.0 };
  glm::dvec3 Emission{ 0.0 };
  double Start = 1.0; // density at the ray's origin
  double Rise = 0.0;  // scale heights a unit of length; 0: uniform

  double GetDensity(double t) const { return this->Start * std::exp(-this->Rise * t); }
  double GetColumn(double t) const
  {
    const double x = this->Rise * t;
    return this->Start * (x == 0.0 ? t : -std::expm1(-x) / this->Rise);
  }
};

double GetDepth(const std::vector<Along>& media, int k, double t)
{
  double depth = 0.0;
  for (const Along& medium : media)
  {
    depth += medium.SigmaT[k] > 0.0 ? medium.SigmaT[k] * medium.GetColumn(t) : 0.0;
  }
  return depth;
}

// Where the panels of the expected integral end: at all scales, from each medium's own.
std::vector<long double> GetEnds(const std::vector<Along>& media, int k, double l)
{
  std::vector<double> scales;
  for (const Along& medium : media)
  {
    scales.push_back(1.0 / std::max(medium.SigmaT[k] * medium.Start, 1e-30));
    scales.push_back(1.0 / std::max(std::abs(medium.Rise), 1e-30));
  }
  const double least = *std::min_element(scales.begin(), scales.end());
  std::vector<long double> ends = { 0.0L, l };
  for (long double t = 1e-3L * least; t < l; t *= 2.0L)
  {
    ends.push_back(t);
  }
  // A fog below the eye is as deep as its last scale heights.
  for (const Along& medium : media)
  {
    for (int i = 1; medium.Rise < 0.0 && i <= 200; ++i)
    {
      const double t = i / -medium.Rise;
      if (t < l)
      {
        ends.push_back(t);
      }
    }
  }
  std::sort(ends.begin(), ends.end());
  return ends;
}

double GetExpected(const std::vector<Along>& media, int k, double l)
{
  const auto integrand = [&](double t) {
    const double depth = GetDepth(media, k, t);
    double source = 0.0;
    for (const Along& medium : media)
    {
      source += (medium.SigmaS[k] * medium.Ambient[k] + medium.Emission[k]) *
        std::min(medium.GetDensity(t), 1e30);
    }
    return depth < 700.0 ? source * std::exp(-depth) : 0.0;
  };
  return Integrate(integrand, GetEnds(media, k, l), 1e-12);
}

// Where the last channel has lost all its light, or the ray's end.
double GetDarkLength(const std::vector<Along>& media, double l)
{
  double end = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    double low = 0.0;
    double high = l;
    for (int i = 0; i < 200 && GetDepth(media, k, l) > 60.0; ++i)
    {
      const double middle = 0.5 * (low + high);
      (GetDepth(media, k, middle) > 60.0 ? high : low) = middle;
    }
    end = std::max(end, high);
  }
  return end;
}

//------------------------------------------------------------------------------
class Setting
{
public:
  Setting(Random& random, Random& shining)
    : Shining(shining)
  {
    this->Direction = RandomUnit(random);
    const int count = 2 + random.Index(2);
    for (int i = 0; i < count; ++i)
    {
      this->AddMedium(random, i > 0 || random.Index(3) == 0);
    }
    const double l = random.LogUniform(0.1, 1e7);
    this->Length = GetDarkLength(this->Media, l);
  }

  f64::AirlightMedia Convert() const
  {
    std::vector<vtkParticipatingMedium*> media(this->Given.begin(), this->Given.end());
    return ConvertMedia(media, glm::dvec3(0.0));
  }

  // How much single precision's last place at the ray's end changes a density.
  double GetRounding() const
  {
    double most = 0.0;
    for (const Along& medium : this->Media)
    {
      most = std::max(most, std::abs(medium.Rise) * this->Length);
    }
    return 0x1p-23 * most;
  }

  std::vector<Along> Media;
  glm::dvec3 Direction;
  double Length;

private:
  void AddMedium(Random& random, bool height)
  {
    Along along;
    const bool shines = this->Shining.Index(2) == 0;
    for (int k = 0; k < 3; ++k)
    {
      // A channel may be clear.
      along.SigmaT[k] = random.Index(5) == 0 ? 0.0 : random.LogUniform(1e-4, 10.0);
      along.SigmaS[k] = along.SigmaT[k] * random.Uniform(0.0, 1.0);
      along.Ambient[k] = random.Uniform(0.0, 1.0);
      // Unbounded media that are clear must not emit.
      along.Emission[k] = shines ? along.SigmaT[k] * this->Shining.Uniform(0.0, 1.0) : 0.0;
    }
    auto medium = vtkSmartPointer<vtkParticipatingMedium>::New();
    const glm::dvec3 sigmaA = along.SigmaT - along.SigmaS;
    medium->SetScattering(&along.SigmaS.x);
    medium->SetAbsorption(&sigmaA.x);
    medium->SetAmbientRadiance(&along.Ambient.x);
    medium->SetEmission(&along.Emission.x);
    if (height)
    {
      const double scale = random.LogUniform(1e-2, 1e4);
      const double above = random.Uniform(-5.0, 60.0);
      const glm::dvec3 up = RandomUnit(random);
      medium->SetDensityToExponentialHeight();
      medium->SetScaleHeight(scale);
      medium->SetReferenceHeight(-above * scale);
      medium->SetUp(&up.x);
      along.Start = std::exp(-above);
      along.Rise = glm::dot(up, this->Direction) / scale;
    }
    this->Given.push_back(medium);
    this->Media.push_back(along);
  }

  Random& Shining;
  std::vector<vtkSmartPointer<vtkParticipatingMedium>> Given;
};
}

//------------------------------------------------------------------------------
int TestAmbientLight(int, char*[])
{
  Random random(26);
  Random shining(27);
  Comparison doubles("double precision");
  Comparison singles("single precision");
  for (int i = 0; i < 3000; ++i)
  {
    const Setting setting(random, shining);
    const f64::AirlightMedia media = setting.Convert();
    const glm::dvec3 inDouble =
      f64::airlightAmbient(media, glm::dvec3(0.0), setting.Direction, setting.Length);
    const glm::vec3 inSingle = f32::airlightAmbient(ToSingle(media), glm::vec3(0.0f),
      glm::vec3(setting.Direction), static_cast<float>(setting.Length));
    for (int k = 0; k < 3; ++k)
    {
      const double expected = GetExpected(setting.Media, k, setting.Length);
      const auto describe = [&] {
        return Text("setting ", i, ", channel ", k, ", length ", setting.Length, ", expected ",
          expected, ", double ", inDouble[k], ", single ", inSingle[k]);
      };
      // What is far below what the eye sees is measured against that.
      const double size = std::max(expected, 1e-12);
      doubles.Add(std::abs(inDouble[k] - expected) / size, 1e-9, describe);
      singles.Add(std::abs(inSingle[k] - expected) / size, 2e-5 + setting.GetRounding(), describe);
    }
  }
  const bool ok = doubles.Report() & singles.Report();
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
