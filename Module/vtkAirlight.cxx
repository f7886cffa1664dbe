// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAirlight.h"

#include "AirlightConvert.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkParticipatingMedium.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace airlight;

namespace
{
glm::dvec3 Vector(const double v[3]) { return { v[0], v[1], v[2] }; }

// Squares of larger numbers overflow.
constexpr double Largest = 1e100;

// False for NaN, too.
bool IsModerate(const double v[3])
{
  return std::abs(v[0]) <= Largest && std::abs(v[1]) <= Largest && std::abs(v[2]) <= Largest;
}

// The unit vector in a direction of any length but 0; 0 for 0.
glm::dvec3 Normalize(const glm::dvec3& v)
{
  const double largest = std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
  return largest > 0.0 ? glm::normalize(v / largest) : v;
}

// Reports what is wrong with a vector argument, in the medium's name.
bool CheckVector(vtkParticipatingMedium* medium, const char* name, const double v[3])
{
  if (!IsModerate(v))
  {
    vtkErrorWithObjectMacro(medium,
      "vtkAirlight: " << name << " (" << v[0] << ", " << v[1] << ", " << v[2]
                      << ") must be finite and at most 1e100.");
    return false;
  }
  return true;
}

// Checks what all integrals along a ray take. Returns the unit direction.
bool CheckRay(vtkParticipatingMedium* medium, const double origin[3], const double direction[3],
  double t0, double t1, glm::dvec3& unit)
{
  if (!medium)
  {
    vtkGenericWarningMacro("vtkAirlight: the medium is null; give it a vtkParticipatingMedium.");
    return false;
  }
  unit = Normalize(Vector(direction));
  if (!CheckVector(medium, "origin", origin) || !CheckVector(medium, "direction", &unit.x))
  {
    return false;
  }
  if (unit == glm::dvec3(0.0))
  {
    vtkErrorWithObjectMacro(medium, "vtkAirlight: the direction has length 0.");
    return false;
  }
  if (std::isnan(t0) || std::isnan(t1))
  {
    vtkErrorWithObjectMacro(
      medium, "vtkAirlight: the interval [" << t0 << ", " << t1 << "] is not a number.");
    return false;
  }
  return true;
}

// The quadrature's panels, halved until two halves agree with the whole. Samples that see kinks
// (a leg that leaves the region through another face) converge as quickly as smooth ones that way.
glm::dvec3 AdaptivePanel(const f64::AirlightMedium& medium, const f64::AirlightLight& light,
  const f64::AirlightRay& ray, double v0, double v1, const glm::dvec3& whole, double scale,
  int depth)
{
  const double middle = 0.5 * (v0 + v1);
  const glm::dvec3 low = f64::airlightQuadraturePanel(medium, light, ray, v0, middle);
  const glm::dvec3 high = f64::airlightQuadraturePanel(medium, light, ray, middle, v1);
  const glm::dvec3 error = glm::abs(low + high - whole);
  const double worst = std::max({ error.x, error.y, error.z });
  if (depth == 0 || !(worst > 1e-12 * scale))
  {
    return low + high;
  }
  return AdaptivePanel(medium, light, ray, v0, middle, low, scale, depth - 1) +
    AdaptivePanel(medium, light, ray, middle, v1, high, scale, depth - 1);
}

glm::dvec3 AdaptiveQuadrature(const f64::AirlightMedium& medium, const f64::AirlightLight& light,
  const f64::AirlightRay& ray, double t0, double t1)
{
  const double x0 = t0 - ray.range.x - ray.foot.tL;
  const double x1 = f64::airlightQuadratureEnd(medium, t0, t1) - ray.range.x - ray.foot.tL;
  if (x1 - x0 < 1e-4 * std::max(std::abs(x0), ray.foot.h))
  {
    return f64::airlightStraightPanel(medium, light, ray, x0, x1);
  }
  const double v0 = std::asinh(x0 / ray.foot.h);
  const double v1 = std::asinh(x1 / ray.foot.h);
  const int panels = static_cast<int>((v1 - v0) / 1.5) + 1;
  std::vector<glm::dvec3> rough(panels);
  glm::dvec3 total(0.0);
  const auto end = [&](int i) { return v0 + (v1 - v0) * i / panels; };
  for (int i = 0; i < panels; ++i)
  {
    rough[i] = f64::airlightQuadraturePanel(medium, light, ray, end(i), end(i + 1));
    total += rough[i];
  }
  const double scale = std::max({ total.x, total.y, total.z });
  glm::dvec3 sum(0.0);
  for (int i = 0; i < panels; ++i)
  {
    sum += AdaptivePanel(medium, light, ray, end(i), end(i + 1), rough[i], scale, 24);
  }
  return sum;
}

// Airlight on [t0, t1] of a light that the mathematics can do. All positions are relative to the
// ray's origin.
glm::dvec3 Integrate(const f64::AirlightMedium& medium, f64::AirlightLight light,
  const glm::dvec3& direction, double t0, double t1)
{
  t1 = std::min(t1, AIRLIGHT_FAR);
  if (light.kind != AIRLIGHT_DIRECTIONAL)
  {
    // Keeps the logarithms and quotients of a light on the ray finite; far below what a double
    // resolves of the distances involved.
    const double distance = glm::length(light.position);
    light.radius = distance > 0.0 ? 1e-12 * distance : 1e-12 * std::min(t1, 1.0);
    light.radius = std::max(light.radius, 1e-100);
  }
  const f64::AirlightRay ray = f64::airlightRay(medium, light, glm::dvec3(0.0), direction, t1);
  const double from = std::max(t0, ray.range.x);
  const double to = std::min(t1, ray.range.y);
  if (!(to > from))
  {
    return glm::dvec3(0.0);
  }
  if (light.kind == AIRLIGHT_POINT_QUADRATURE)
  {
    return medium.sigmaS * light.intensity * AdaptiveQuadrature(medium, light, ray, from, to);
  }
  return f64::airlightInterval3(medium, light, ray, from,
    f64::airlightTail3(medium, light, ray, from), to, f64::airlightTail3(medium, light, ray, to));
}

// Channels without scattering are exactly dark, whatever the limits of their integrals.
void Store(const f64::AirlightMedium& medium, const glm::dvec3& radiance, double rgb[3])
{
  for (int i = 0; i < 3; ++i)
  {
    rgb[i] = medium.sigmaS[i] > 0.0 && std::isfinite(radiance[i]) ? radiance[i] : 0.0;
  }
}
}

vtkStandardNewMacro(vtkAirlight);

//------------------------------------------------------------------------------
bool vtkAirlight::Inscatter(vtkParticipatingMedium* medium, const double lightPosition[3],
  const double radiantIntensity[3], const double origin[3], const double direction[3], double t0,
  double t1, double rgb[3])
{
  std::fill_n(rgb, 3, 0.0);
  glm::dvec3 unit;
  if (!CheckRay(medium, origin, direction, t0, t1, unit) ||
    !CheckVector(medium, "lightPosition", lightPosition) ||
    !CheckVector(medium, "radiantIntensity", radiantIntensity))
  {
    return false;
  }
  const f64::AirlightMedium converted = ConvertMedium(medium, Vector(origin));
  const f64::AirlightLight light =
    ConvertPointLight(converted, Vector(lightPosition), Vector(radiantIntensity), Vector(origin));
  Store(converted, Integrate(converted, light, unit, t0, t1), rgb);
  return true;
}

//------------------------------------------------------------------------------
bool vtkAirlight::Inscatter(vtkParticipatingMedium* medium, vtkLight* light, const double origin[3],
  const double direction[3], double t0, double t1, double rgb[3])
{
  std::fill_n(rgb, 3, 0.0);
  glm::dvec3 unit;
  if (!CheckRay(medium, origin, direction, t0, t1, unit))
  {
    return false;
  }
  if (!light)
  {
    vtkErrorWithObjectMacro(medium, "vtkAirlight: the light is null; give it a vtkLight.");
    return false;
  }
  const f64::AirlightMedium converted = ConvertMedium(medium, Vector(origin));
  f64::AirlightLight lamp;
  switch (ConvertLight(converted, light, Vector(origin), lamp))
  {
    case LightSupport::Dark:
      return true;
    case LightSupport::Scatters:
      Store(converted, Integrate(converted, lamp, unit, t0, t1), rgb);
      return true;
    case LightSupport::Unsupported:
      vtkErrorWithObjectMacro(light,
        "vtkAirlight: spot lights (cone angle "
          << light->GetConeAngle()
          << " below 90) and directional lights in a bounded medium are not supported.");
      return false;
    case LightSupport::Invalid:
      break;
  }
  vtkErrorWithObjectMacro(light,
    "vtkAirlight: the light's position, colour and attenuation must be finite, its attenuation at "
    "least 0 with one term above 0, and a directional light's focal point apart from its "
    "position.");
  return false;
}

//------------------------------------------------------------------------------
bool vtkAirlight::Transmittance(
  vtkParticipatingMedium* medium, const double a[3], const double b[3], double rgb[3])
{
  std::fill_n(rgb, 3, 0.0);
  if (!medium)
  {
    vtkGenericWarningMacro("vtkAirlight: the medium is null; give it a vtkParticipatingMedium.");
    return false;
  }
  if (!CheckVector(medium, "a", a) || !CheckVector(medium, "b", b))
  {
    return false;
  }
  const f64::AirlightMedium converted = ConvertMedium(medium, Vector(a));
  const double inside =
    f64::airlightInsideLength(converted.region, glm::dvec3(0.0), Vector(b) - Vector(a));
  for (int i = 0; i < 3; ++i)
  {
    rgb[i] = std::exp(-converted.sigmaT[i] * inside);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkAirlight::Ambient(vtkParticipatingMedium* medium, const double origin[3],
  const double direction[3], double t1, double rgb[3])
{
  std::fill_n(rgb, 3, 0.0);
  glm::dvec3 unit;
  if (!CheckRay(medium, origin, direction, 0.0, t1, unit))
  {
    return false;
  }
  const f64::AirlightMedium converted = ConvertMedium(medium, Vector(origin));
  const glm::dvec2 range = f64::airlightRegionRange(
    converted.region, glm::dvec3(0.0), unit, std::min(std::max(t1, 0.0), AIRLIGHT_FAR));
  Store(converted, f64::airlightAmbient(converted, range.y - range.x), rgb);
  return true;
}

//------------------------------------------------------------------------------
void vtkAirlight::SetRadiantIntensity(vtkLight* light, const double rgb[3])
{
  light->SwitchOn();
  light->PositionalOn();
  light->SetConeAngle(90.0);
  light->SetAttenuationValues(0.0, 0.0, 1.0);
  light->SetIntensity(1.0);
  light->SetColor(rgb[0] / vtkMath::Pi(), rgb[1] / vtkMath::Pi(), rgb[2] / vtkMath::Pi());
}

//------------------------------------------------------------------------------
void vtkAirlight::GetRadiantIntensity(vtkLight* light, double rgb[3])
{
  light->GetDiffuseColor(rgb);
  for (int i = 0; i < 3; ++i)
  {
    rgb[i] *= vtkMath::Pi() * light->GetIntensity();
  }
}

//------------------------------------------------------------------------------
void vtkAirlight::SetIrradiance(vtkLight* light, const double rgb[3])
{
  SetRadiantIntensity(light, rgb);
  light->PositionalOff();
  light->SetAttenuationValues(1.0, 0.0, 0.0);
}

//------------------------------------------------------------------------------
void vtkAirlight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
