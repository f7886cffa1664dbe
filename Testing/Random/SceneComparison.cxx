// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneComparison.h"

#include "AirlightTestTools.h"

#include "vtkAirlightReference.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkPointData.h"
#include "vtkPropCollection.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>

namespace airlight_test
{
namespace
{
constexpr double Tolerance = 0.01;
constexpr double EdgePixels = 0.02;
constexpr double LastPlace = 5e-7; // of single precision, some of them
constexpr double Rounding = 1e-5;  // of the airlight without shadows
constexpr double Black = 1e-6;     // radiance below which no picture is measured
constexpr int Described = 3;

constexpr const char* Names[] = { "Radiance", "Airlight", "Surface", "Transmittance", "Depth",
  "LitLength" };

// Beyond this the pass and the reference mean "without end".
constexpr double Endless = 1e15;

double GetQuantile(std::vector<double> values, double share)
{
  if (values.empty())
  {
    return 0.0;
  }
  const auto place =
    values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

// Of buffers that hold radiance.
bool IsLight(const std::string& name)
{
  return name == "Radiance" || name == "Airlight" || name == "Surface";
}

glm::dvec2 GetDirection(int i)
{
  const double angle = (i + 0.3) * std::acos(-1.0) / 4.0;
  return { std::cos(angle), std::sin(angle) };
}

// The values of a pixel's trace in the order of Names.
std::vector<double> Flatten(const airlight::ReferencePixel& p)
{
  return { p.Radiance.x, p.Radiance.y, p.Radiance.z, p.Airlight.x, p.Airlight.y, p.Airlight.z,
    p.Surface.x, p.Surface.y, p.Surface.z, p.Transmittance.x, p.Transmittance.y, p.Transmittance.z,
    p.Depth, p.LitLength };
}
}

//------------------------------------------------------------------------------
SceneComparison::SceneComparison(airlighttest::Scene& scene,
  const std::vector<vtkSmartPointer<vtkParticipatingMedium>>& media, bool byBound)
  : Scene(scene)
  , ByBound(byBound)
  , Media(media.begin(), media.end())
{
  vtkNew<vtkAirlightReference> reference;
  reference->SetRenderer(scene.Renderer);
  for (vtkParticipatingMedium* medium : this->Media)
  {
    reference->AddMedium(medium);
  }
  reference->SetLightRadius(scene.Pass->GetLightRadius());
  reference->SetSurfaceShadows(scene.Pass->GetSurfaceShadows());
  reference->SetSize(scene.Width, scene.Height);
  reference->Update();
  for (const char* name : Names)
  {
    this->AddBuffer(name, reference->GetOutput());
  }
  this->Figures.Pixels = scene.Width * scene.Height;
  this->Excused.assign(static_cast<size_t>(this->Figures.Pixels), 0);
  for (vtkIdType pixel = 0; pixel < this->Figures.Pixels; ++pixel)
  {
    const bool right = this->IsRight(pixel);
    const int improper = this->Figures.Improper;
    this->CountImproper(pixel);
    this->Figures.Wrong += right ? 0 : 1;
    const bool excused = !right && this->IsExplained(pixel);
    this->Excused[static_cast<size_t>(pixel)] = excused;
    this->Figures.Unexplained += right || excused ? 0 : 1;
    if ((!right && !excused) || improper < this->Figures.Improper)
    {
      this->Describe(pixel);
    }
  }
  this->MeasureRadiance();
}

//------------------------------------------------------------------------------
void SceneComparison::AddBuffer(const char* name, vtkImageData* computed)
{
  Buffer buffer;
  buffer.Name = name;
  buffer.Drawn = this->Scene.GetBuffer(name);
  buffer.Computed = computed->GetPointData()->GetArray(name);
  buffer.Components = buffer.Computed->GetNumberOfComponents();
  buffer.MayBeNegative = std::string(name) == "Depth"; // -1: no surface
  std::vector<double> sizes;
  for (vtkIdType i = 0; i < buffer.Computed->GetNumberOfValues(); ++i)
  {
    const double value = std::abs(buffer.Computed->GetVariantValue(i).ToDouble());
    if (value < Endless * std::max(1.0, this->Scene.Pass->GetLightRadius()))
    {
      sizes.push_back(value);
    }
  }
  buffer.Floor = std::max(1e-3 * GetQuantile(sizes, 0.99), IsLight(name) ? Black : 1e-30);
  this->Buffers.push_back(buffer);
}

//------------------------------------------------------------------------------
// In units of what is allowed; infinite where a value is not a number.
double SceneComparison::GetError(const Buffer& buffer, vtkIdType pixel) const
{
  double error = 0.0;
  for (int c = 0; c < buffer.Components; ++c)
  {
    const double a = buffer.Drawn->GetPointData()->GetScalars()->GetComponent(pixel, c);
    const double b = buffer.Computed->GetComponent(pixel, c);
    if (a > Endless && b > Endless)
    {
      continue;
    }
    double allowed = Tolerance * std::max(std::abs(b), buffer.Floor);
    const std::string name = buffer.Name;
    if (this->ByBound && (name == "Airlight" || name == "Radiance"))
    {
      allowed = std::max(allowed,
        this->Scene.GetBuffer("ErrorBound")->GetPointData()->GetScalars()->GetComponent(pixel, c));
    }
    const double own = std::abs(a - b) / allowed;
    error = std::isnan(own) ? std::numeric_limits<double>::infinity() : std::max(error, own);
  }
  return error;
}

//------------------------------------------------------------------------------
void SceneComparison::CountImproper(vtkIdType pixel)
{
  for (const Buffer& buffer : this->Buffers)
  {
    for (int c = 0; c < buffer.Components; ++c)
    {
      const double a = buffer.Drawn->GetPointData()->GetScalars()->GetComponent(pixel, c);
      if (!std::isfinite(a) || (a < 0.0 && !(buffer.MayBeNegative && a == -1.0)))
      {
        ++this->Figures.Improper;
        return;
      }
    }
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
  settings.Scatters = [](vtkLight*) { return true; };
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
bool SceneComparison::IsRight(vtkIdType pixel)
{
  std::vector<double> unshadowed;
  for (const Buffer& buffer : this->Buffers)
  {
    if (this->GetError(buffer, pixel) <= 1.0)
    {
      continue;
    }
    // What it is without shadows: the airlight's channels, or the length.
    const std::string name = buffer.Name;
    const bool isLight = name == "Radiance" || name == "Airlight";
    if (!isLight && name != "LitLength")
    {
      return false;
    }
    if (unshadowed.empty())
    {
      if (!this->Unshadowed)
      {
        this->Unshadowed = this->MakeUnshadowedTracer();
      }
      const glm::dvec2 middle = this->GetMiddle(pixel);
      unshadowed = Flatten(this->Unshadowed->Trace(middle.x, middle.y));
    }
    for (int c = 0; c < buffer.Components; ++c)
    {
      const double a = buffer.Drawn->GetPointData()->GetScalars()->GetComponent(pixel, c);
      const double b = buffer.Computed->GetComponent(pixel, c);
      const double whole = isLight ? unshadowed[3 + static_cast<size_t>(c)] : unshadowed.back();
      if (!(std::abs(a - b) <=
            std::max(Tolerance * std::max(std::abs(b), buffer.Floor), Rounding * whole)))
      {
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool SceneComparison::IsExplained(vtkIdType pixel)
{
  if (!this->Tracer)
  {
    this->Tracer = this->MakeTracer();
    this->Unshadowed = this->MakeUnshadowedTracer();
    this->Triangles = std::make_unique<ScreenTriangles>(
      this->Scene.Renderer, this->Scene.Width, this->Scene.Height);
  }
  const glm::dvec2 middle = this->GetMiddle(pixel);
  const std::vector<glm::dvec2> beside = this->Triangles->FindPlaces(middle, EdgePixels);
  Range range;
  range.Add(this->Tracer->Trace(middle.x, middle.y));
  for (const glm::dvec2& place : beside)
  {
    range.Add(this->Tracer->Trace(place.x, place.y));
  }
  for (int i = 0; i < 16; ++i)
  {
    const glm::dvec2 place = middle + (i < 8 ? EdgePixels : 0.25 * EdgePixels) * GetDirection(i);
    range.Add(this->Tracer->Trace(place.x, place.y));
  }
  if (this->IsBetween(pixel, range))
  {
    return true;
  }
  Range outline = range;
  for (const glm::dvec2& place : beside)
  {
    airlight::ReferencePixel lit = this->Tracer->Trace(place.x, place.y);
    const glm::dvec3 more = this->Unshadowed->Trace(place.x, place.y).Surface - lit.Surface;
    lit.Surface += more;
    lit.Radiance += more;
    outline.Add(lit);
  }
  if (this->IsBetween(pixel, outline))
  {
    ++this->Figures.Outlines;
    return true;
  }
  this->AddMoved(middle, range);
  const bool rounded = this->IsBetween(pixel, range);
  this->Figures.Rounded += rounded ? 1 : 0;
  return rounded;
}

//------------------------------------------------------------------------------
glm::dvec2 SceneComparison::GetMiddle(vtkIdType pixel) const
{
  const vtkIdType column = pixel % this->Scene.Width;
  const vtkIdType row = pixel / this->Scene.Width;
  return glm::dvec2(column, row) + 0.5;
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
    range.Add(this->Tracer->Trace(place.x, place.y, reach * corner, i % 2 ? wider : 1.0 / wider));
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
      const double a = buffer.Drawn->GetPointData()->GetScalars()->GetComponent(pixel, c);
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

//------------------------------------------------------------------------------
void SceneComparison::MeasureRadiance()
{
  const Buffer& radiance = this->Buffers.front();
  std::vector<double> errors;
  for (vtkIdType pixel = 0; pixel < this->Figures.Pixels; ++pixel)
  {
    const double error = Tolerance * this->GetError(radiance, pixel);
    errors.push_back(error);
    if (this->Excused[static_cast<size_t>(pixel)])
    {
      continue;
    }
    this->Figures.Largest = std::max(this->Figures.Largest, error);
    for (int c = 0; c < 3; ++c)
    {
      const double a = radiance.Drawn->GetPointData()->GetScalars()->GetComponent(pixel, c);
      const double b = radiance.Computed->GetComponent(pixel, c);
      if (b <= radiance.Floor)
      {
        this->Figures.Leak = std::max(this->Figures.Leak, 1e-3 * std::abs(a - b) / radiance.Floor);
      }
    }
  }
  this->Figures.Median = GetQuantile(errors, 0.5);
  this->Figures.P99 = GetQuantile(errors, 0.99);
}

//------------------------------------------------------------------------------
void SceneComparison::Describe(vtkIdType pixel)
{
  if (std::count(this->Figures.Worst.begin(), this->Figures.Worst.end(), '\n') >= Described)
  {
    return;
  }
  std::ostringstream out;
  out << "    pixel " << pixel % this->Scene.Width << " " << pixel / this->Scene.Width;
  for (const Buffer& buffer : this->Buffers)
  {
    out << "; " << buffer.Name << (this->GetError(buffer, pixel) <= 1.0 ? "" : " WRONG");
    for (int c = 0; c < buffer.Components; ++c)
    {
      out << " " << buffer.Drawn->GetPointData()->GetScalars()->GetComponent(pixel, c) << " ("
          << buffer.Computed->GetComponent(pixel, c) << ")";
    }
  }
  this->Figures.Worst += out.str() + "\n";
}

//------------------------------------------------------------------------------
void SceneComparison::Print(const std::string& name, std::ostream& out) const
{
  for (const Buffer& buffer : this->Buffers)
  {
    for (int i = 0; i < this->Figures.Pixels && name == buffer.Name; ++i)
    {
      const double drawn = buffer.Drawn->GetPointData()->GetScalars()->GetComponent(i, 0);
      out << i % this->Scene.Width << " " << i / this->Scene.Width << ": " << drawn << " ("
          << buffer.Computed->GetComponent(i, 0) << ")\n";
    }
  }
}
}
