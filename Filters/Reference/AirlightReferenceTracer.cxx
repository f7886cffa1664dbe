// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/AirlightReferenceTracer.h"

#include "Integration/AirlightIntegrate.h"
#include "Integration/AirlightMembers.h"
#include "Reference/AirlightReferenceLitParts.h"
#include "Reference/AirlightReferenceSurface.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace airlight
{
namespace
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

// A surface is lit as the air this little before it, relative to the distance: its own shadow, and
// those of what it touches, begin or end there.
constexpr double RelativeMargin = 1e-9;

// A light whose numbers are not finite shades surfaces with NaN.
glm::dvec3 MakeFinite(glm::dvec3 colour)
{
  for (int c = 0; c < 3; ++c)
  {
    colour[c] = std::isnan(colour[c]) ? 0.0 : std::min(colour[c], 1e30);
  }
  return colour;
}
}

//------------------------------------------------------------------------------
struct ReferenceTracer::PixelRay
{
  glm::dvec3 Origin; // from the eye
  glm::dvec3 World;  // the same in the world
  glm::dvec3 Direction;
  double Nearest;
  double Farthest;
  std::vector<std::vector<ReferenceLitPart>> Lit; // for each light, up to the end of the ray
};

//------------------------------------------------------------------------------
ReferenceTracer::ReferenceTracer(vtkRenderer* renderer,
  const std::vector<vtkParticipatingMedium*>& media, const ReferenceSettings& settings)
  : Settings(settings)
  , Rays(renderer->GetActiveCamera(), static_cast<double>(settings.Width) / settings.Height,
      settings.Width, settings.Height)
  , Media(ConvertMedia(media, this->Rays.GetEye()))
  , Scene(renderer, settings.TranslucentShadows, settings.VolumeShadows)
  , Lights(renderer, this->Media, this->Rays.GetEye(), settings.LightRadius, settings.LampPoints)
{
  this->Media.multiple.on = settings.MultipleScattering ? this->Media.multiple.on : 0;
  for (const ReferenceLight& light : this->Lights.GetPoints())
  {
    if (light.Support == LightSupport::Scatters && !AddMultipleLamp(this->Media, light.Values))
    {
      ++this->ScatteredOnce;
    }
  }
  for (int i = 0; i < this->Media.count && HasSky(this->Media); ++i)
  {
    this->Skies.emplace_back(media[i]);
  }
  renderer->GetBackground(&this->Bottom.x);
  this->Top = this->Bottom;
  if (renderer->GetGradientBackground())
  {
    renderer->GetBackground2(&this->Top.x);
  }
}

//------------------------------------------------------------------------------
glm::dvec3 ReferenceTracer::GetBackground(double y) const
{
  return glm::mix(this->Bottom, this->Top, y / this->Settings.Height);
}

//------------------------------------------------------------------------------
bool ReferenceTracer::FindSurface(const Occluders& surfaces, const PixelRay& ray, double after,
  double before, SurfaceHit& hit) const
{
  return this->Scene.FindFirst(surfaces, ray.World, ray.Direction, after, before, hit);
}

//------------------------------------------------------------------------------
void ReferenceTracer::FindLitParts(PixelRay& ray, double end) const
{
  for (const ReferenceLight& light : this->Lights.GetAll())
  {
    ray.Lit.push_back(light.CastsShadows
        ? FindReferenceLitParts(this->Scene, light.World, ray.World, ray.Direction, end)
        : std::vector<ReferenceLitPart>{ { 0.0, end } });
  }
}

//------------------------------------------------------------------------------
// The share of a light that casters let through to the surface that ends the ray at t.
glm::dvec3 ReferenceTracer::GetPassing(const PixelRay& ray, size_t light, double t) const
{
  if (!this->Settings.SurfaceShadows || !this->Lights.GetAll()[light].CastsShadows)
  {
    return glm::dvec3(1.0);
  }
  for (const ReferenceLitPart& part : ray.Lit[light])
  {
    if (part.From < t * (1.0 - RelativeMargin) && part.To >= t * (1.0 - RelativeMargin))
    {
      return part.Passes;
    }
  }
  return glm::dvec3(0.0);
}

//------------------------------------------------------------------------------
// The share of the light that volumes let through to a point, relative to the eye.
double ReferenceTracer::PassVolumes(const ReferenceLight& light, const glm::dvec3& point) const
{
  return std::exp(-this->Scene.GetVolumes().GetDepth(light.World, point + this->Rays.GetEye()));
}

//------------------------------------------------------------------------------
glm::dvec3 ReferenceTracer::ScatterLight(
  const ReferenceLight& light, const f64::AirlightRay& ray, double from, double to) const
{
  if (this->Scene.GetVolumes().IsEmpty())
  {
    return IntegrateAirlight(this->Media, light.Values, ray, from, to);
  }
  return IntegrateDimmed(this->Media, light.Values, ray, from, to,
    [&](const glm::dvec3& point) { return this->PassVolumes(light, point); });
}

//------------------------------------------------------------------------------
// Scattered into the ray before `end`, and the length of it that is lit, inside media, for all
// lights together.
glm::dvec3 ReferenceTracer::Scatter(const PixelRay& ray, double end, double* litLength) const
{
  end = std::min(end, AIRLIGHT_FAR);
  glm::dvec3 sum(0.0);
  for (size_t k = 0; k < this->Lights.GetAll().size(); ++k)
  {
    const ReferenceLight& light = this->Lights.GetAll()[k];
    if (light.Support != LightSupport::Scatters)
    {
      continue;
    }
    glm::dvec3 own(0.0);
    const f64::AirlightRay part =
      f64::airlightRay(this->Media, light.Values, ray.Origin, ray.Direction, end);
    for (const ReferenceLitPart& lit : ray.Lit[k])
    {
      const double from = std::max(lit.From, part.lit.x);
      const double to = std::min(lit.To, part.lit.y);
      if (!(from < to))
      {
        continue;
      }
      if (light.Values.intensity != glm::dvec3(0.0))
      {
        own += lit.Passes * this->ScatterLight(light, part, from, to);
      }
      if (litLength)
      {
        *litLength += f64::airlightLengthInside(this->Media, ray.Origin, ray.Direction, from, to);
      }
    }
    const int lamp = FindMultipleLamp(this->Media, light.Values);
    sum += own;
    if (lamp >= 0)
    {
      sum += IntegrateMultiple(this->Media, lamp, ray.Origin, ray.Direction, end, own);
    }
  }
  const glm::dvec3 ambient = this->Skies.empty()
    ? IntegrateAmbient(this->Media, ray.Origin, ray.Direction, end)
    : IntegrateAmbient(
        WithSkies(this->Media, this->Skies, ray.Direction), ray.Origin, ray.Direction, end);
  sum += ambient + IntegrateCollisions(this->Media, ray.Origin, ray.Direction, end);
  // A channel that neither scatters nor emits is dark, whatever the limit of its integral.
  return KeepBright(this->Media, sum);
}

//------------------------------------------------------------------------------
glm::dvec4 ReferenceTracer::Shade(const PixelRay& ray, const SurfaceHit& hit) const
{
  const glm::dvec3 point = ray.Origin + hit.T * ray.Direction;
  std::vector<glm::dvec3> arriving;
  for (size_t k = 0; k < this->Lights.GetAll().size(); ++k)
  {
    const ReferenceLight& light = this->Lights.GetAll()[k];
    glm::dvec3 share(1.0);
    if (light.Support == LightSupport::Scatters)
    {
      const glm::dvec3& position = light.Values.position;
      share = glm::exp(-(f64::airlightIsDirectional(light.Values)
          ? f64::airlightSunDepths(this->Media, point, position)
          : f64::airlightDepthBetween(this->Media, point, position)));
      share *= this->GetPassing(ray, k, hit.T) * this->PassVolumes(light, point) *
        f64::airlightPhotometricShare(light.Values, point);
    }
    arriving.push_back(share);
  }
  const glm::dvec3& eye = this->Rays.GetEye();
  const ReferencePart& part = this->Scene.GetPart(*hit.Triangle);
  const glm::dvec4 shaded =
    this->Lights.Shade(part, *hit.Triangle, point + eye, ray.Direction, eye, arriving);
  glm::dvec3 colour(shaded);
  if (this->Media.multiple.count > 0 && part.Lighting)
  {
    const ReferenceSurface surface(part, *hit.Triangle, point + eye, ray.Direction);
    colour += surface.Material.Diffuse / vtkMath::Pi() *
      f64::airlightMultipleIrradiance(this->Media.multiple, this->Media, point, surface.Normal);
  }
  return { MakeFinite(colour), shaded.a };
}

//------------------------------------------------------------------------------
// The share of light that passes from `end` to the eye.
glm::dvec3 ReferenceTracer::Pass(const PixelRay& ray, double end) const
{
  return glm::exp(
    -f64::airlightDepth(this->Media, ray.Origin, ray.Direction, std::min(end, AIRLIGHT_FAR)));
}

//------------------------------------------------------------------------------
// Puts translucent surfaces before what is seen, the farthest first, each behind the medium before
// it.
void ReferenceTracer::AddLayers(const PixelRay& ray, double end, glm::dvec3& radiance) const
{
  std::vector<SurfaceHit> layers;
  SurfaceHit hit{ ray.Nearest, nullptr };
  while (
    this->FindSurface(this->Scene.GetTranslucent(), ray, hit.T, std::min(end, ray.Farthest), hit))
  {
    layers.push_back(hit);
  }
  for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer)
  {
    const glm::dvec4 shaded = this->Shade(ray, *layer);
    const glm::dvec3 seen =
      glm::dvec3(shaded) * this->Pass(ray, layer->T) + this->Scatter(ray, layer->T, nullptr);
    radiance = glm::mix(radiance, seen, std::clamp(shaded.a, 0.0, 1.0));
  }
}

//------------------------------------------------------------------------------
ReferenceTracer::PixelRay ReferenceTracer::MakeRay(
  double x, double y, const ReferenceChange& change) const
{
  const CameraRays::Ray own = this->Rays.GetRay(x, y);
  const glm::dvec3 origin = own.Origin + change.Shift;
  return { origin, origin + this->Rays.GetEye(), own.Direction,
    std::max(own.Nearest / change.Wider, change.After), own.Farthest * change.Wider, {} };
}

//------------------------------------------------------------------------------
void ReferenceTracer::TraceMedium(PixelRay& ray, double end, ReferencePixel& pixel) const
{
  this->FindLitParts(ray, end);
  pixel.Airlight = this->Scatter(ray, end, &pixel.LitLength);
  pixel.Transmittance = this->Pass(ray, end);
}

//------------------------------------------------------------------------------
ReferencePixel ReferenceTracer::TraceTo(double x, double y, double end) const
{
  PixelRay ray = this->MakeRay(x, y, {});
  ReferencePixel pixel;
  pixel.Depth = end;
  this->TraceMedium(ray, end, pixel);
  return pixel;
}

//------------------------------------------------------------------------------
ReferencePixel ReferenceTracer::Trace(double x, double y, const ReferenceChange& change) const
{
  PixelRay ray = this->MakeRay(x, y, change);
  ReferencePixel pixel;
  SurfaceHit hit{ Infinity, nullptr };
  if (this->FindSurface(this->Scene.GetOpaque(), ray, ray.Nearest, ray.Farthest, hit))
  {
    pixel.Depth = hit.T;
  }
  this->TraceMedium(ray, hit.T, pixel);
  glm::dvec3 behind = this->GetBackground(y);
  if (hit.Triangle)
  {
    behind = glm::dvec3(this->Shade(ray, hit));
    pixel.Surface = pixel.Transmittance * behind;
  }
  pixel.Radiance = pixel.Airlight + pixel.Transmittance * behind;
  this->AddLayers(ray, hit.T, pixel.Radiance);
  return pixel;
}

//------------------------------------------------------------------------------
ReferenceTracer::EyeRay ReferenceTracer::FindEyeRay(double x, double y) const
{
  const PixelRay ray = this->MakeRay(x, y, {});
  EyeRay result;
  result.Origin = ray.Origin;
  result.Direction = ray.Direction;
  SurfaceHit hit{ AIRLIGHT_FAR, nullptr };
  this->FindSurface(this->Scene.GetOpaque(), ray, ray.Nearest, ray.Farthest, hit);
  result.End = hit.T;
  result.Triangle = hit.Triangle;
  hit = { ray.Nearest, nullptr };
  const double before = std::min(result.End, ray.Farthest);
  while (this->FindSurface(this->Scene.GetTranslucent(), ray, hit.T, before, hit))
  {
    const ReferenceSurface surface(this->Scene.GetPart(*hit.Triangle), *hit.Triangle,
      ray.World + hit.T * ray.Direction, ray.Direction);
    result.Layers.push_back({ hit.T, std::clamp(surface.Material.Opacity, 0.0, 1.0) });
  }
  return result;
}

//------------------------------------------------------------------------------
ReferenceSurface ReferenceTracer::GetSurface(const EyeRay& ray) const
{
  return { this->Scene.GetPart(*ray.Triangle), *ray.Triangle,
    ray.Origin + this->Rays.GetEye() + ray.End * ray.Direction, ray.Direction };
}

//------------------------------------------------------------------------------
glm::dvec3 ReferenceTracer::GetAmbient(
  const glm::dvec3& origin, const glm::dvec3& direction, double end) const
{
  return Shines(this->Media) ? IntegrateAmbient(this->Media, origin, direction, end)
                             : glm::dvec3(0.0);
}
}
