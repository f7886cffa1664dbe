// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What explains a pixel that is not right: edges, outlines, roundings.

#include "SceneComparison.h"

#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkPropCollection.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace airlight_test
{
namespace
{
constexpr double EdgePixels = 0.02;
constexpr double LastPlace = 5e-7; // of single precision, some of them
constexpr double DepthPlace = 1.0 / (1 << 24);

glm::dvec2 GetDirection(int i)
{
  const double angle = (i + 0.3) * std::acos(-1.0) / 4.0;
  return { std::cos(angle), std::sin(angle) };
}

// The middle of a pixel and two rings around it.
std::vector<glm::dvec2> GetPlaces(const glm::dvec2& middle)
{
  std::vector<glm::dvec2> places = { middle };
  for (int i = 0; i < 16; ++i)
  {
    places.push_back(middle + (i < 8 ? EdgePixels : 0.25 * EdgePixels) * GetDirection(i));
  }
  return places;
}

}

//------------------------------------------------------------------------------
std::unique_ptr<airlight::ReferenceTracer> SceneComparison::MakeTracer()
{
  airlight::ReferenceSettings settings;
  settings.Width = this->Scene.Width;
  settings.Height = this->Scene.Height;
  settings.LightRadius = this->Scene.Pass->GetLightRadius();
  settings.SurfaceShadows = this->Scene.Pass->GetSurfaceShadows();
  return std::make_unique<airlight::ReferenceTracer>(this->Scene.Renderer, this->Media, settings);
}

//------------------------------------------------------------------------------
std::unique_ptr<airlight::ReferenceTracer> SceneComparison::MakeUnshadowedTracer()
{
  vtkNew<vtkInformation> keys;
  keys->Set(vtkAirlightPass::CASTS_SHADOW(), 0);
  const auto setKeys = [&](vtkInformation* information) {
    vtkCollectionSimpleIterator it = nullptr;
    vtkPropCollection* props = this->Scene.Renderer->GetViewProps();
    props->InitTraversal(it);
    while (vtkProp* prop = props->GetNextProp(it))
    {
      prop->SetPropertyKeys(information);
    }
  };
  setKeys(keys);
  auto tracer = this->MakeTracer();
  setKeys(nullptr);
  return tracer;
}

//------------------------------------------------------------------------------
airlight::ReferencePixel SceneComparison::TraceUnshadowed(
  const glm::dvec2& place, const airlight::ReferenceChange& change)
{
  if (!this->Unshadowed)
  {
    this->Unshadowed = this->MakeUnshadowedTracer();
  }
  return this->Unshadowed->Trace(place.x, place.y, change);
}

//------------------------------------------------------------------------------
void SceneComparison::MakeTools()
{
  if (!this->Tracer)
  {
    this->Tracer = this->MakeTracer();
    this->Triangles = std::make_unique<ScreenTriangles>(
      this->Scene.Renderer, this->Scene.Width, this->Scene.Height);
  }
}

//------------------------------------------------------------------------------
airlight::ReferencePixel SceneComparison::Trace(
  vtkIdType pixel, const airlight::ReferenceChange& change)
{
  this->MakeTools();
  const glm::dvec2 middle = this->GetMiddle(pixel);
  return this->Tracer->Trace(middle.x, middle.y, change);
}

//------------------------------------------------------------------------------
airlight::ReferencePixel SceneComparison::TraceTo(vtkIdType pixel, double depth)
{
  this->MakeTools();
  const glm::dvec2 middle = this->GetMiddle(pixel);
  return this->Tracer->TraceTo(middle.x, middle.y, depth);
}

//------------------------------------------------------------------------------
airlight::ReferencePixel SceneComparison::TraceUnshadowed(vtkIdType pixel)
{
  return this->TraceUnshadowed(this->GetMiddle(pixel));
}

//------------------------------------------------------------------------------
bool SceneComparison::IsExplained(vtkIdType pixel)
{
  this->MakeTools();
  const glm::dvec2 middle = this->GetMiddle(pixel);
  const std::vector<glm::dvec2> beside = this->Triangles->FindPlaces(middle, EdgePixels);
  Range range;
  std::vector<airlight::ReferencePixel> there;
  for (const glm::dvec2& place : beside)
  {
    there.push_back(this->Tracer->Trace(place.x, place.y));
    range.Add(there.back());
  }
  for (const glm::dvec2& place : GetPlaces(middle))
  {
    range.Add(this->Tracer->Trace(place.x, place.y));
  }
  if (this->IsBetween(pixel, range))
  {
    return true;
  }
  Range outline = range;
  for (size_t i = 0; i < beside.size(); ++i)
  {
    airlight::ReferencePixel lit = there[i];
    const glm::dvec3 surface = this->TraceUnshadowed(beside[i]).Surface;
    lit.Radiance += surface - lit.Surface;
    lit.Surface = surface;
    outline.Add(lit);
  }
  if (this->IsBetween(pixel, outline))
  {
    ++this->Figures.Outlines;
    return true;
  }
  this->AddMoved(middle, range);
  this->AddBehind(middle, range);
  if (this->IsBetween(pixel, range))
  {
    ++this->Figures.Rounded;
    return true;
  }
  const bool is =
    (this->Triangles->IsNearBorder(middle, EdgePixels) || this->AreSurfacesCoarse(pixel)) &&
    this->IsMediumRight(pixel) && this->IsShadingPossible(pixel);
  this->Figures.Borders += is ? 1 : 0;
  return is;
}

//------------------------------------------------------------------------------
// Whether roundings of single precision can move surfaces by more than a thousandth of their
// distance.
bool SceneComparison::AreSurfacesCoarse(vtkIdType pixel)
{
  return LastPlace * this->GetReach() > 1e-3 * this->GetDrawn(DEPTH, pixel);
}

//------------------------------------------------------------------------------
// Surfaces that are behind the first by no more than what depth buffers of 24 bits resolve.
void SceneComparison::AddBehind(const glm::dvec2& middle, Range& range)
{
  vtkCamera* camera = this->Scene.Renderer->GetActiveCamera();
  const double* clip = camera->GetClippingRange();
  const double first = this->Tracer->Trace(middle.x, middle.y).Depth;
  const double slope =
    camera->GetParallelProjection() ? clip[1] - clip[0] : first * first / clip[0];
  airlight::ReferenceChange change;
  change.After = first;
  while (change.After > 0.0)
  {
    change.After *= 1.0 + 1e-12;
    const airlight::ReferencePixel next = this->Tracer->Trace(middle.x, middle.y, change);
    if (next.Depth < 0.0 || next.Depth - first > 2.0 * DepthPlace * slope)
    {
      return;
    }
    range.Add(next);
    // Behind by so little, it is shadowed by the first or not.
    airlight::ReferencePixel lit = next;
    lit.Surface = this->TraceUnshadowed(middle, change).Surface;
    lit.Radiance += lit.Surface - next.Surface;
    range.Add(lit);
    change.After = next.Depth;
  }
}

//------------------------------------------------------------------------------
// The medium before the surface that VTK has drawn, with its depth.
bool SceneComparison::IsMediumRight(vtkIdType pixel)
{
  const double depth = this->GetDrawn(DEPTH, pixel);
  if (!(depth > 0.0))
  {
    return false;
  }
  Range range;
  for (const glm::dvec2& place : GetPlaces(this->GetMiddle(pixel)))
  {
    airlight::ReferencePixel traced = this->Tracer->TraceTo(place.x, place.y, depth);
    // As drawn: VTK shades what it has found.
    for (int c = 0; c < 3; ++c)
    {
      traced.Surface[c] = this->GetDrawn(SURFACE, pixel, c);
    }
    traced.Radiance = traced.Airlight + traced.Surface;
    range.Add(traced);
  }
  return this->IsBetween(pixel, range);
}

//------------------------------------------------------------------------------
// Whether the surface that VTK has drawn is no brighter than a white one that faces all lights
// there, through what the medium leaves of it. More cannot be said of slivers: single precision
// turns their normals.
bool SceneComparison::IsShadingPossible(vtkIdType pixel)
{
  const glm::dvec2 middle = this->GetMiddle(pixel);
  const airlight_test::Ray ray = this->Scene.GetRay(middle.x, middle.y);
  const glm::dvec3 point = ray.Origin + this->GetDrawn(DEPTH, pixel) * ray.Direction;
  glm::dvec3 white(0.0);
  vtkCollectionSimpleIterator it = nullptr;
  vtkLightCollection* lights = this->Scene.Renderer->GetLights();
  lights->InitTraversal(it);
  while (vtkLight* light = lights->GetNextLight(it))
  {
    glm::dvec3 position;
    light->GetTransformedPosition(&position.x);
    const double r = glm::length(point - position);
    const double* fall = light->GetAttenuationValues();
    const double share = light->GetPositional() ? fall[0] + r * (fall[1] + r * fall[2]) : 1.0;
    white += glm::make_vec3(light->GetDiffuseColor()) * light->GetIntensity() / share;
  }
  for (int c = 0; c < 3; ++c)
  {
    const double room = Tolerance * std::max(white[c], this->Buffers[SURFACE].Floor);
    const double most = this->GetDrawn(TRANSMITTANCE, pixel, c) * white[c] + room;
    if (!(this->GetDrawn(SURFACE, pixel, c) <= most))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// What rays find that begin elsewhere by roundings of single precision.
void SceneComparison::AddMoved(const glm::dvec2& middle, Range& range)
{
  const double reach = LastPlace * this->GetReach();
  const double wider =
    1.0 + 0.5 * reach / this->Scene.Renderer->GetActiveCamera()->GetClippingRange()[0];
  for (int i = 0; i < 16; ++i)
  {
    const glm::dvec3 corner(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0);
    const glm::dvec2 place = middle + (i < 8 ? 0.0 : EdgePixels) * GetDirection(i);
    airlight::ReferenceChange change;
    change.Shift = reach * corner;
    change.Wider = i % 2 ? wider : 1.0 / wider;
    range.Add(this->Tracer->Trace(place.x, place.y, change));
  }
}

//------------------------------------------------------------------------------
// The farthest corner of a box around any part, from the eye.
double SceneComparison::GetReach()
{
  const glm::dvec3 eye = glm::make_vec3(this->Scene.Renderer->GetActiveCamera()->GetPosition());
  double reach = 0.0;
  vtkCollectionSimpleIterator it = nullptr;
  vtkPropCollection* props = this->Scene.Renderer->GetViewProps();
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    const double* bounds = prop->GetVisibility() ? prop->GetBounds() : nullptr;
    for (int corner = 0; bounds && corner < 8; ++corner)
    {
      const glm::dvec3 point(
        bounds[corner & 1], bounds[2 + (corner >> 1 & 1)], bounds[4 + (corner >> 2 & 1)]);
      reach = std::max(reach, glm::length(point - eye));
    }
  }
  return reach;
}

//------------------------------------------------------------------------------
void SceneComparison::Range::Add(const airlight::ReferencePixel& pixel)
{
  const std::vector<double> values = Flatten(pixel);
  this->Low.resize(values.size(), std::numeric_limits<double>::infinity());
  this->High.resize(values.size(), -std::numeric_limits<double>::infinity());
  for (size_t k = 0; k < values.size(); ++k)
  {
    this->Low[k] = std::min(this->Low[k], values[k]);
    this->High[k] = std::max(this->High[k], values[k]);
  }
}

//------------------------------------------------------------------------------
bool SceneComparison::IsBetween(vtkIdType pixel, const Range& range) const
{
  size_t k = 0;
  for (const Buffer& buffer : this->Buffers)
  {
    for (int c = 0; c < buffer.Components; ++c, ++k)
    {
      const double a = buffer.Get(pixel, c);
      const double room = Tolerance * std::max(std::abs(a), buffer.Floor);
      if (!(a >= range.Low[k] - room && a <= range.High[k] + room) &&
        !(a > Endless && range.High[k] > Endless))
      {
        return false;
      }
    }
  }
  return true;
}
}
