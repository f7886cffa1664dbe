// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAirlight.h"

#include "Integration/AirlightIntegrate.h"
#include "Medium/AirlightConvert.h"
#include "Medium/AirlightConvertSky.h"
#include "Medium/AirlightEnvironment.h"
#include "Photometry/AirlightBlackbody.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkParticipatingMedium.h"
#include "vtkTexture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

using namespace airlight;

namespace
{
glm::dvec3 Vector(const double v[3]) { return { v[0], v[1], v[2] }; }

// The unit vector in a direction of any length but 0; 0 for 0.
glm::dvec3 Normalize(const glm::dvec3& v)
{
  const double largest = std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
  return largest > 0.0 ? glm::normalize(v / largest) : v;
}

// Reports what is wrong with a vector argument, in the medium's name.
bool CheckVector(vtkParticipatingMedium* medium, const char* name, const double v[3])
{
  if (!IsModerate(Vector(v)))
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

// A medium with one lamp that is scattered more than once, relative to `origin`.
bool MakeLamp(vtkParticipatingMedium* medium, const double position[3],
  const double radiantIntensity[3], const double origin[3], f64::AirlightMedia& converted)
{
  if (!CheckVector(medium, "lightPosition", position) ||
    !CheckVector(medium, "radiantIntensity", radiantIntensity))
  {
    return false;
  }
  converted = ConvertMedia({ medium }, Vector(origin));
  f64::AirlightLight light =
    ConvertPointLight(converted, Vector(position), Vector(radiantIntensity), Vector(origin));
  light.radius = LeastDistance(light.position, 1.0);
  if (!AddMultipleLamp(converted, light))
  {
    vtkErrorWithObjectMacro(medium,
      "vtkAirlight: the lamp at (" << position[0] << ", " << position[1] << ", " << position[2]
                                   << ") has no light. " << GetScatteredOnceText(1));
    return false;
  }
  return true;
}

void Store(const f64::AirlightMedia& media, const glm::dvec3& radiance, double rgb[3])
{
  const glm::dvec3 kept = KeepBright(media, radiance);
  std::copy_n(&kept.x, 3, rgb);
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
  const f64::AirlightMedia converted = ConvertMedia({ medium }, Vector(origin));
  const f64::AirlightLight light =
    ConvertPointLight(converted, Vector(lightPosition), Vector(radiantIntensity), Vector(origin));
  Store(converted, IntegrateLight(converted, light, unit, t0, t1), rgb);
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
  const f64::AirlightMedia converted = ConvertMedia({ medium }, Vector(origin));
  f64::AirlightLight sceneLight;
  switch (ConvertLight(converted, light, Vector(origin), sceneLight))
  {
    case LightSupport::Off:
      return true;
    case LightSupport::Scatters:
      Store(converted, IntegrateLight(converted, sceneLight, unit, t0, t1), rgb);
      return true;
    case LightSupport::Invalid:
      break;
  }
  vtkErrorWithObjectMacro(light,
    "vtkAirlight: the light's position, colour and attenuation must be finite, its attenuation at "
    "least 0 with one term above 0, its exponent at least 0, and the focal point of a spot or a "
    "directional light apart from its position.");
  return false;
}

//------------------------------------------------------------------------------
bool vtkAirlight::MultipleScattering(vtkParticipatingMedium* medium, const double lightPosition[3],
  const double radiantIntensity[3], const double origin[3], const double direction[3], double t1,
  double rgb[3])
{
  std::fill_n(rgb, 3, 0.0);
  glm::dvec3 unit;
  f64::AirlightMedia converted;
  if (!CheckRay(medium, origin, direction, 0.0, t1, unit) ||
    !MakeLamp(medium, lightPosition, radiantIntensity, origin, converted))
  {
    return false;
  }
  const double end = std::min(std::max(t1, 0.0), AIRLIGHT_FAR);
  const glm::dvec3 unshadowed(std::numeric_limits<double>::max());
  glm::dvec3 sum(0.0);
  for (int lamp = 0; lamp < converted.multiple.count; ++lamp)
  {
    sum += IntegrateMultiple(converted, lamp, glm::dvec3(0.0), unit, end, unshadowed);
  }
  Store(converted, sum, rgb);
  return true;
}

//------------------------------------------------------------------------------
bool vtkAirlight::MultipleIrradiance(vtkParticipatingMedium* medium, const double lightPosition[3],
  const double radiantIntensity[3], const double point[3], const double normal[3], double rgb[3])
{
  std::fill_n(rgb, 3, 0.0);
  glm::dvec3 unit;
  f64::AirlightMedia converted;
  if (!CheckRay(medium, point, normal, 0.0, 0.0, unit) ||
    !MakeLamp(medium, lightPosition, radiantIntensity, point, converted))
  {
    return false;
  }
  if (converted.multiple.count > 0)
  {
    Store(converted,
      f64::airlightMultipleIrradiance(converted.multiple, converted, glm::dvec3(0.0), unit), rgb);
  }
  return true;
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
  const f64::AirlightMedia converted = ConvertMedia({ medium }, Vector(a));
  const glm::dvec3 depth =
    f64::airlightDepthBetween(converted, glm::dvec3(0.0), Vector(b) - Vector(a));
  for (int i = 0; i < 3; ++i)
  {
    rgb[i] = std::exp(-depth[i]);
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
  f64::AirlightMedia converted = ConvertMedia({ medium }, Vector(origin));
  if (converted.multiple.on != 0)
  {
    // MultipleScattering() is the same light, but for emission.
    RemoveAmbient(converted.item[0]);
  }
  const glm::dvec3 ambient =
    IntegrateAmbient(converted, glm::dvec3(0.0), unit, std::min(std::max(t1, 0.0), AIRLIGHT_FAR));
  Store(converted, ambient, rgb);
  return true;
}

//------------------------------------------------------------------------------
bool vtkAirlight::EnvironmentHarmonics(
  vtkTexture* texture, const double up[3], const double right[3], double coefficients[27])
{
  std::fill_n(coefficients, 27, 0.0);
  if (!texture)
  {
    vtkGenericWarningMacro("vtkAirlight: the environment's texture is null; give it a vtkTexture.");
    return false;
  }
  Environment environment;
  std::string error;
  if (!environment.Update(texture, Vector(up), Vector(right), error))
  {
    vtkErrorWithObjectMacro(texture, << "vtkAirlight: " << error << ".");
    return false;
  }
  for (int i = 0; i < 27; ++i)
  {
    coefficients[i] = environment.GetHarmonics()[i / 3][i % 3];
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkAirlight::BlackbodyRadiance(double temperature, double rgb[3])
{
  std::fill_n(rgb, 3, 0.0);
  if (!std::isfinite(temperature) || temperature <= 0.0)
  {
    vtkGenericWarningMacro(<< "vtkAirlight: the temperature " << temperature
                           << " K must be finite and above 0.");
    return false;
  }
  const glm::dvec3 radiance = GetBlackbodyRadiance(temperature);
  std::copy_n(&radiance.x, 3, rgb);
  return true;
}

//------------------------------------------------------------------------------
void vtkAirlight::SetRadiantIntensity(vtkLight* light, const double rgb[3])
{
  if (!light)
  {
    vtkGenericWarningMacro("vtkAirlight: the light is null; give it a vtkLight.");
    return;
  }
  light->SwitchOn();
  light->PositionalOn();
  light->SetConeAngle(180.0); // at 90 VTK shades volumes as in the light of a spot
  light->SetAttenuationValues(0.0, 0.0, 1.0);
  light->SetIntensity(1.0);
  light->SetColor(rgb[0] / vtkMath::Pi(), rgb[1] / vtkMath::Pi(), rgb[2] / vtkMath::Pi());
}

//------------------------------------------------------------------------------
void vtkAirlight::GetRadiantIntensity(vtkLight* light, double rgb[3])
{
  if (!light)
  {
    vtkGenericWarningMacro("vtkAirlight: the light is null; give it a vtkLight.");
    std::fill_n(rgb, 3, 0.0);
    return;
  }
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
  if (light)
  {
    light->PositionalOff();
    light->SetAttenuationValues(1.0, 0.0, 0.0);
  }
}

//------------------------------------------------------------------------------
void vtkAirlight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
