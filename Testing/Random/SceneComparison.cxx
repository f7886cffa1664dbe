// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "SceneComparison.h"

#include "AirlightTestTools.h"

#include "vtkAirlightReference.h"
#include "vtkLightCollection.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <ostream>

namespace airlight_test
{
namespace
{
constexpr double Rounding = 1e-5; // of the airlight without shadows
constexpr double Black = 1e-6;    // radiance below which no picture is measured
constexpr int Described = 3;

// In the order of SceneComparison::BufferIndex.
constexpr const char* Names[] = { "Radiance", "Airlight", "Surface", "Transmittance", "Depth",
  "LitLength" };

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
}

//------------------------------------------------------------------------------
SceneComparison::SceneComparison(airlight_test::Scene& scene,
  const std::vector<vtkSmartPointer<vtkParticipatingMedium>>& media, bool byBound)
  : Scene(scene)
  , ByBound(byBound)
  , Bound(scene.GetBuffer("ErrorBound"))
  , Media(media.begin(), media.end())
{
  vtkNew<vtkAirlightReference> reference;
  for (vtkLight* light : this->GetLights())
  {
    reference->SetLightScatters(light, this->Scene.Pass->GetLightScatters(light));
  }
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
std::vector<vtkLight*> SceneComparison::GetLights()
{
  std::vector<vtkLight*> all;
  vtkCollectionSimpleIterator it = nullptr;
  vtkLightCollection* lights = this->Scene.Renderer->GetLights();
  lights->InitTraversal(it);
  while (vtkLight* light = lights->GetNextLight(it))
  {
    all.push_back(light);
  }
  return all;
}

//------------------------------------------------------------------------------
void SceneComparison::AddBuffer(const char* name, vtkImageData* computed)
{
  Buffer buffer;
  buffer.Name = name;
  buffer.Drawn = vtkSmartPointer<vtkImageData>::New();
  buffer.Drawn->DeepCopy(this->Scene.GetBuffer(name));
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
  for (int c = 0; c < buffer.Components; ++c)
  {
    double largest = 1e3 * buffer.Floor;
    for (vtkIdType i = 0; i < buffer.Computed->GetNumberOfTuples(); ++i)
    {
      const double value = buffer.Computed->GetComponent(i, c);
      largest = std::max(largest, value < Endless ? value : 0.0);
    }
    this->Largest.push_back(largest);
  }
  this->Buffers.push_back(buffer);
}

//------------------------------------------------------------------------------
// In units of what is allowed; infinite where a value is not a number.
double SceneComparison::GetError(const Buffer& buffer, vtkIdType pixel) const
{
  double error = 0.0;
  for (int c = 0; c < buffer.Components; ++c)
  {
    const double a = buffer.Get(pixel, c);
    const double b = buffer.Computed->GetComponent(pixel, c);
    if (a > Endless && b > Endless)
    {
      continue;
    }
    double allowed = Tolerance * std::max(std::abs(b), buffer.Floor);
    const std::string name = buffer.Name;
    if (this->ByBound && (name == "Airlight" || name == "Radiance"))
    {
      allowed =
        std::max(allowed, this->Bound->GetPointData()->GetScalars()->GetComponent(pixel, 0));
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
      const double a = buffer.Get(pixel, c);
      if (!std::isfinite(a) || (a < 0.0 && !(buffer.MayBeNegative && a == -1.0)))
      {
        ++this->Figures.Improper;
        return;
      }
    }
  }
}

//------------------------------------------------------------------------------
bool SceneComparison::IsRight(vtkIdType pixel)
{
  std::optional<airlight::ReferencePixel> unshadowed;
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
    if (!unshadowed)
    {
      unshadowed = this->TraceUnshadowed(this->GetMiddle(pixel));
    }
    for (int c = 0; c < buffer.Components; ++c)
    {
      const double a = buffer.Get(pixel, c);
      const double b = buffer.Computed->GetComponent(pixel, c);
      const double whole = isLight ? unshadowed->Airlight[c] : unshadowed->LitLength;
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
glm::dvec2 SceneComparison::GetMiddle(vtkIdType pixel) const
{
  const vtkIdType column = pixel % this->Scene.Width;
  const vtkIdType row = pixel / this->Scene.Width;
  return glm::dvec2(column, row) + 0.5;
}

//------------------------------------------------------------------------------
std::vector<double> SceneComparison::Flatten(const airlight::ReferencePixel& p)
{
  return { p.Radiance.x, p.Radiance.y, p.Radiance.z, p.Airlight.x, p.Airlight.y, p.Airlight.z,
    p.Surface.x, p.Surface.y, p.Surface.z, p.Transmittance.x, p.Transmittance.y, p.Transmittance.z,
    p.Depth, p.LitLength };
}

//------------------------------------------------------------------------------
airlight::ReferencePixel SceneComparison::GetDrawnPixel(vtkIdType pixel) const
{
  const auto get = [&](BufferIndex buffer) {
    return glm::dvec3(this->GetDrawn(buffer, pixel, 0), this->GetDrawn(buffer, pixel, 1),
      this->GetDrawn(buffer, pixel, 2));
  };
  airlight::ReferencePixel drawn;
  drawn.Radiance = get(RADIANCE);
  drawn.Airlight = get(AIRLIGHT);
  drawn.Surface = get(SURFACE);
  drawn.Transmittance = get(TRANSMITTANCE);
  drawn.Depth = this->GetDrawn(DEPTH, pixel);
  drawn.LitLength = this->GetDrawn(LIT_LENGTH, pixel);
  return drawn;
}

//------------------------------------------------------------------------------
void SceneComparison::SetDrawn(vtkIdType pixel, const std::vector<double>& values)
{
  size_t k = 0;
  for (const Buffer& buffer : this->Buffers)
  {
    for (int c = 0; c < buffer.Components; ++c, ++k)
    {
      buffer.Drawn->GetPointData()->GetScalars()->SetComponent(pixel, c, values[k]);
    }
  }
}

//------------------------------------------------------------------------------
bool SceneComparison::Reports(vtkIdType pixel, const airlight::ReferencePixel& drawn)
{
  const std::vector<double> kept = Flatten(this->GetDrawnPixel(pixel));
  const SceneFigures figures = this->Figures;
  this->SetDrawn(pixel, Flatten(drawn));
  const bool reports = !this->IsRight(pixel) && !this->IsExplained(pixel);
  this->SetDrawn(pixel, kept);
  this->Figures = figures;
  return reports;
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
      const double a = radiance.Get(pixel, c);
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
      out << " " << buffer.Get(pixel, c) << " (" << buffer.Computed->GetComponent(pixel, c) << ")";
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
      const double drawn = buffer.Get(i, 0);
      out << i % this->Scene.Width << " " << i / this->Scene.Width << ": " << drawn << " ("
          << buffer.Computed->GetComponent(i, 0) << ")\n";
    }
  }
}
}
