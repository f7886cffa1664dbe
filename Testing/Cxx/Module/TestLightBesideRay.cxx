// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Pixels' rays that pass a light closely, in the single precision of shaders: the light's moment
// about the ray, and what a spot scatters between the ends that its cone cuts off.

#include "AirlightTestQuadrature.h"
#include "AirlightTestTools.h"

#include "Integration/AirlightMath.h"

#include <cstdlib>

using namespace airlight;
using namespace airlight_test;

namespace
{
using Vector = glm::vec<3, long double>;

// A light that stands for the pixel q, and the ray of a pixel p nearby. Pixel p's ray goes along
// D + p.x X + p.y Y from the origin.
struct PixelAndLight
{
  glm::dvec3 X = glm::dvec3(1.25e-3, 0.0, 1e-5);
  glm::dvec3 Y = glm::dvec3(0.0, 1.25e-3, -2e-5);
  glm::dvec2 Q;
  glm::dvec2 Whole;
  glm::dvec2 P;
  glm::dvec3 Light;
  glm::dvec3 Along;
  Vector Ray;

  explicit PixelAndLight(Random& random)
  {
    const glm::dvec3 d(-0.6, -0.4, -1.0);
    this->Q.x = random.Uniform(0.0, 960.0);
    this->Q.y = random.Uniform(0.0, 640.0);
    this->Light = random.LogUniform(1e-3, 1e3) * (d + this->Q.x * this->X + this->Q.y * this->Y);
    this->Whole = glm::floor(this->Q);
    this->P.x = this->Whole.x + random.Index(9) - 3.5;
    this->P.y = this->Whole.y + random.Index(9) - 3.5;
    this->Along = d + this->P.x * this->X + this->P.y * this->Y;
    this->Ray = glm::normalize(Vector(this->Along));
  }

  Vector GetMoment() const { return glm::cross(Vector(this->Light), this->Ray); }

  glm::dvec3 GetDoubleMoment() const
  {
    return f64::airlightMoment(this->P, this->Whole, this->Q - this->Whole,
      glm::cross(this->Light, this->X), glm::cross(this->Light, this->Y), glm::length(this->Along));
  }

  glm::vec3 GetFloatMoment() const
  {
    return f32::airlightMoment(glm::vec2(this->P), glm::vec2(this->Whole),
      glm::vec2(this->Q - this->Whole), glm::vec3(glm::cross(this->Light, this->X)),
      glm::vec3(glm::cross(this->Light, this->Y)), static_cast<float>(glm::length(this->Along)));
  }

  std::string Describe() const
  {
    return Text("pixel ", this->P.x, ", ", this->P.y, ", light's ", this->Q.x, ", ", this->Q.y,
      ", light ", this->Light.x, ", ", this->Light.y, ", ", this->Light.z);
  }
};

//------------------------------------------------------------------------------
// Against the cross product with 64 bits of mantissa. In single precision the light's place within
// its pixel is rounded to 3e-8 of a pixel.
bool TestMoment()
{
  Comparison inDouble("a light's moment about a pixel's ray in double precision, relative");
  Comparison inFloat("the same in single precision");
  Random random(8);
  for (int i = 0; i < 2000; ++i)
  {
    const PixelAndLight place(random);
    const Vector expected = place.GetMoment();
    const auto size = glm::length(expected);
    const auto error = [&](const auto& moment) {
      return static_cast<double>(glm::length(Vector(moment) - expected) / size);
    };
    const auto describe = [&] { return place.Describe(); };
    inDouble.Add(error(place.GetDoubleMoment()), 1e-9, describe);
    inFloat.Add(
      error(place.GetFloatMoment()), 6e-7 + 1e-7 / glm::length(place.P - place.Q), describe);
  }
  return AllOk({ &inDouble, &inFloat });
}

//------------------------------------------------------------------------------
bool TestRadius()
{
  f64::AirlightMedia media{};
  media.count = 1;
  f64::AirlightLight light{};
  light.cosCone = -1.0;
  light.radius = 0.25;
  light.position = glm::dvec3(3.0, 1e-3, 0.0);
  const f64::AirlightRay ray =
    f64::airlightRay(media, light, glm::dvec3(0.0), glm::dvec3(1.0, 0.0, 0.0), 10.0);
  Comparison radius("a light's radius is the least distance");
  radius.Add(std::abs(ray.foot.h - 0.25), 0.0, [] { return "a ray at a distance of 1e-3"; });
  return AllOk({ &radius });
}

//------------------------------------------------------------------------------
// Fog everywhere, and a spot of radiant intensity 1.
struct Spot
{
  glm::dvec3 Axis;
  double CosCone;
  double SigmaT;
};

// The integral of 1/(4 pi) exp(-sigmaT (t + r))/r^2 over the ray's part inside the cone. In the
// angle phi at the light, t = tL + h tan phi, the axis' components a across and b along the ray are
// those of a direction at phi0 = atan2(b, a) of length R, and inside means R cos(phi - phi0) >=
// cos(cone).
double Expected(const PixelAndLight& place, const Spot& spot, double widened)
{
  const long double tL = glm::dot(Vector(place.Light), place.Ray);
  const Vector foot = tL * place.Ray - Vector(place.Light);
  const long double h = glm::length(foot);
  const long double a = glm::dot(Vector(spot.Axis), foot) / h;
  const long double b = glm::dot(Vector(spot.Axis), place.Ray);
  const long double cosine = std::cos(std::acos(static_cast<long double>(spot.CosCone)) + widened);
  const long double ratio = cosine / std::hypot(a, b);
  if (ratio >= 1.0L)
  {
    return 0.0;
  }
  const long double middle = std::atan2(b, a);
  const long double from = std::max(middle - std::acos(ratio), std::atan2(-tL, h));
  const long double to = std::min(middle + std::acos(ratio), std::acos(-1.0L) / 2.0L);
  if (from >= to)
  {
    return 0.0;
  }
  const auto integrand = [&](long double phi) {
    const long double way = tL + h * (std::tan(phi) + 1.0L / std::cos(phi));
    return std::exp(-spot.SigmaT * way) / (4.0L * std::acos(-1.0L) * h);
  };
  return static_cast<double>(Integrate(integrand, { from, to }, 1e-12));
}

// In the shaders' precision: by tails, and by AirlightEquiangular.glsl.
struct Scattered
{
  float ByTails;
  float ByAngle;
};

Scattered Scatter(const PixelAndLight& place, const Spot& spot)
{
  f32::AirlightMedia media{};
  media.count = 1;
  f32::AirlightMedium& medium = media.item[0];
  medium.sigmaS = glm::vec3(1.0f);
  medium.sigmaT = glm::vec3(static_cast<float>(spot.SigmaT));
  medium.phase.poleCount = 1;
  medium.phase.order = 1;
  medium.phase.pole[0] = glm::vec4(1.0f, 0.0795774715f, 0.0f, 0.0f);
  f32::AirlightLight light{};
  light.kind = AIRLIGHT_POINT_CLOSED;
  light.position = glm::vec3(place.Light);
  light.intensity = glm::vec3(1.0f);
  light.radius = 1e-5f * glm::length(light.position);
  light.axis = glm::vec3(spot.Axis);
  light.cosCone = static_cast<float>(spot.CosCone);
  const f32::AirlightRay ray = f32::airlightRayBeside(
    media, light, glm::vec3(0.0f), glm::vec3(place.Ray), 1e18f, place.GetFloatMoment());
  const auto tail = [&](float t) { return f32::airlightTail3(media, light, ray, t); };
  Scattered scattered = { 0.0f, 0.0f };
  scattered.ByTails = f32::airlightInterval3(
    media, light, ray, ray.lit.x, tail(ray.lit.x), ray.lit.y, tail(ray.lit.y))
                        .x;
  const f32::AirlightEquiangular arc =
    f32::airlightEquiangularRange(medium, ray, ray.lit.x, ray.lit.y);
  for (float psi = 0.0f; psi < arc.end;)
  {
    const float end = f32::airlightEquiangularPanelEnd(medium, arc, psi);
    scattered.ByAngle +=
      2.0f * f32::airlightEquiangularPanel(medium, arc, psi, end).whole.x / arc.h;
    psi = end;
  }
  return scattered;
}

// Within 1e-4 (physics.md, 7), but where a cone narrower or wider by 1e-6 makes half as much of a
// difference.
bool TestSpot()
{
  Comparison byTails("a spot beside a pixel's ray, single precision, by tails, of its airlight");
  Comparison byAngle("the same by the angle");
  Random random(9);
  int grazing = 0;
  constexpr int Count = 4000;
  for (int i = 0; i < Count; ++i)
  {
    const PixelAndLight place(random);
    Spot spot;
    spot.Axis.x = random.Uniform(-1.0, 1.0);
    spot.Axis.y = random.Uniform(-1.0, 1.0);
    spot.Axis.z = random.Uniform(-1.0, 1.0);
    spot.Axis = glm::normalize(spot.Axis);
    spot.CosCone = std::cos(random.Uniform(0.2, 1.5));
    spot.SigmaT = random.LogUniform(0.01, 3.0) / glm::length(place.Light);
    const double expected = Expected(place, spot, 0.0);
    const double limit = 1e-4 * expected + 1e-37;
    if (std::abs(Expected(place, spot, 1e-6) - expected) > 0.5 * limit)
    {
      ++grazing;
      continue;
    }
    const Scattered got = Scatter(place, spot);
    const auto describe = [&] {
      return Text(place.Describe(), ", axis ", spot.Axis.x, ", ", spot.Axis.y, ", ", spot.Axis.z,
        ", cone's cosine ", spot.CosCone, ", sigmaT ", spot.SigmaT, ": expected ", expected,
        ", got ", got.ByTails, " and ", got.ByAngle);
    };
    byTails.Add(std::abs(got.ByTails - expected), limit, describe);
    byAngle.Add(std::abs(got.ByAngle - expected), limit, describe);
  }
  Comparison few("rays that graze the cone, of all");
  few.Add(static_cast<double>(grazing) / Count, 0.03, [&] { return Text(grazing, " rays"); });
  return AllOk({ &byTails, &byAngle, &few });
}
}

//------------------------------------------------------------------------------
int TestLightBesideRay(int, char*[])
{
  bool ok = TestMoment();
  ok = TestRadius() && ok;
  ok = TestSpot() && ok;
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
