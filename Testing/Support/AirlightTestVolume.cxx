// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestVolume.h"

namespace airlight_test
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeSlabImage(const Slab& slab, int components)
{
  const int n = 16;
  const glm::dvec3 spacing = (slab.High - slab.Low) / double(n);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n + 1, n + 1, n + 1);
  image->SetOrigin(&slab.Low.x);
  image->SetSpacing(&spacing.x);
  vtkNew<vtkUnsignedCharArray> values;
  values->SetNumberOfComponents(components);
  values->SetNumberOfTuples(n * n * n);
  for (int i = 0; i < n * n * n * components; ++i)
  {
    values->SetValue(i, static_cast<unsigned char>(10 * (i / components / (n * n))));
  }
  image->GetCellData()->SetScalars(values);
  return image;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkVolumeProperty> MakeSlabProperty(const Slab& slab)
{
  vtkNew<vtkColorTransferFunction> colours;
  vtkNew<vtkPiecewiseFunction> opacities;
  for (const double x : { 0.0, 255.0 })
  {
    colours->AddRGBPoint(x, slab.Colour.x, slab.Colour.y, slab.Colour.z);
    opacities->AddPoint(x, 1.0 - std::exp(-slab.Kappa));
  }
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetColor(colours);
  property->SetScalarOpacity(opacities);
  property->SetScalarOpacityUnitDistance(1.0);
  property->SetInterpolationTypeToLinear();
  property->SetShade(slab.Lit);
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  property->SetSpecular(0.0);
  return property;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkVolume> AddSlab(Scene& scene, const Slab& slab)
{
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(MakeSlabImage(slab));
  mapper->SetScalarModeToUseCellData();
  mapper->SetAutoAdjustSampleDistances(0);
  mapper->SetSampleDistance(static_cast<float>(slab.Step));
  mapper->UseJitteringOff();
  auto volume = vtkSmartPointer<vtkVolume>::New();
  volume->SetMapper(mapper);
  volume->SetProperty(MakeSlabProperty(slab));
  scene.Renderer->AddVolume(volume);
  return volume;
}

//------------------------------------------------------------------------------
Interval GetSpan(const Slab& slab, const Ray& ray)
{
  Interval span{ 0.0, Infinity };
  for (int i = 0; i < 3; ++i)
  {
    glm::dvec3 normal(0.0);
    normal[i] = 1.0;
    Clip(span, ray, normal, slab.Low);
    Clip(span, ray, -normal, slab.High);
  }
  return span;
}

//------------------------------------------------------------------------------
Answer GetAirBefore(Scene& scene, const Ray& ray, double t)
{
  std::vector<Triangle> all = scene.Triangles;
  const glm::dvec3 p = ray.Origin + t * ray.Direction;
  const double size = 1e3;
  all.push_back({ p + glm::dvec3(-size, -size, 0.0), p + glm::dvec3(size, -size, 0.0),
    p + glm::dvec3(0.0, size, 0.0), false, false });
  return Trace(all, scene.Lights, scene.Medium, ray);
}

//------------------------------------------------------------------------------
bool IsInShadow(Scene& scene, vtkLight* lamp, const Ray& ray, double t)
{
  return std::any_of(scene.Triangles.begin(), scene.Triangles.end(), [&](const Triangle& triangle) {
    Interval shadow;
    return FindShadow(triangle, GetPosition(lamp), ray, shadow) && shadow.From < t && t < shadow.To;
  });
}

//------------------------------------------------------------------------------
double GetEdgeError(Scene& scene, const Slab& slab, const Ray& ray, double from, double length)
{
  const int steps = 200;
  double sum = 0.0;
  for (vtkLight* lamp : scene.Lights)
  {
    int edges = 0;
    double most = 0.0;
    bool shadowed = IsInShadow(scene, lamp, ray, from);
    for (int i = 0; i <= steps; ++i)
    {
      const double t = from + length * i / steps;
      const glm::dvec3 x = ray.Origin + t * ray.Direction;
      const bool before = shadowed;
      shadowed = IsInShadow(scene, lamp, ray, t);
      edges += shadowed != before ? 1 : 0;
      for (const double side : { -1.0, 1.0 })
      {
        const glm::dvec3 c = slab.Colour * Shade(scene.Medium, lamp, x, glm::dvec3(0.0, 0.0, side));
        most = std::max({ most, c.x, c.y, c.z });
      }
    }
    sum += edges * 0.5 * length / 15.0 * slab.Kappa * most;
  }
  return sum;
}

//------------------------------------------------------------------------------
glm::dvec3 GetSample(Scene& scene, const Slab& slab, const Ray& ray, double t)
{
  const glm::dvec3 x = ray.Origin + t * ray.Direction;
  glm::dvec3 passes;
  vtkAirlight::Transmittance(scene.Medium, &ray.Origin.x, &x.x, &passes.x);
  glm::dvec3 light(slab.Lit ? 0.0 : 1.0);
  for (vtkLight* lamp : scene.Lights)
  {
    const bool lit = slab.Lit && !IsInShadow(scene, lamp, ray, t);
    for (const double side : { -1.0, 1.0 }) // it is lit from both
    {
      light += lit ? Shade(scene.Medium, lamp, x, glm::dvec3(0.0, 0.0, side)) : glm::dvec3(0.0);
    }
  }
  return slab.Colour * light * passes + GetAirBefore(scene, ray, t).Airlight;
}

//------------------------------------------------------------------------------
glm::dvec3 GetThroughSlab(Scene& scene, const Slab& slab, const Ray& ray, double opacity,
  const glm::dvec3& behind, int panels)
{
  const double from = GetSpan(slab, ray).From;
  const double length = -std::log(1.0 - opacity) / slab.Kappa;
  glm::dvec3 sum = (1.0 - opacity) * behind;
  for (int panel = 0; panel < panels; ++panel)
  {
    static const GaussRule rule = MakeGaussRule();
    for (int i = 0; i < GaussCount; ++i)
    {
      const double s = length * (panel + 0.5 + 0.5 * rule.X[i]) / panels;
      sum += 0.5 * rule.W[i] * length / panels * slab.Kappa * std::exp(-slab.Kappa * s) *
        GetSample(scene, slab, ray, from + s + 0.5 * slab.Step);
    }
  }
  return sum;
}
}
