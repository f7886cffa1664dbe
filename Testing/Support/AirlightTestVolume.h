// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A slab of constant density in a scene, and what a pixel ought to show through it.
 */

#ifndef AirlightTestVolume_h
#define AirlightTestVolume_h

#include "AirlightCompareScene.h"
#include "AirlightTestQuadrature.h"
#include "AirlightTestTools.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace airlighttest
{
using airlight_test::Comparison;
using airlight_test::Text;

// From Low to High; its values grow along z, so that VTK shades it as if it faced along z, but its
// colour and its opacity are the same everywhere: what goes through one unit is exp(-Kappa).
struct Slab
{
  glm::dvec3 Low{ -3.0, -2.0, -1.0 };
  glm::dvec3 High{ 3.0, 2.5, 1.0 };
  glm::dvec3 Colour{ 0.9, 0.5, 0.2 };
  double Kappa = 0.6;
  double Step = 0.01; // of VTK's samples
  bool Lit = false;
};

// Values of cells: with values of points VTK shades as if samples were up to half a voxel elsewhere.
inline vtkSmartPointer<vtkImageData> MakeSlabImage(const Slab& slab, int components = 1)
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

inline vtkSmartPointer<vtkVolumeProperty> MakeSlabProperty(const Slab& slab)
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

inline vtkSmartPointer<vtkVolume> AddSlab(Scene& scene, const Slab& slab)
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
// Where the ray is in the slab.
inline Interval GetSpan(const Slab& slab, const Ray& ray)
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

// What the air before distance t scatters into the ray, brute force.
inline Answer GetAirBefore(Scene& scene, const Ray& ray, double t)
{
  std::vector<Triangle> all = scene.Triangles;
  const glm::dvec3 p = ray.Origin + t * ray.Direction;
  const double size = 1e3;
  all.push_back({ p + glm::dvec3(-size, -size, 0.0), p + glm::dvec3(size, -size, 0.0),
    p + glm::dvec3(0.0, size, 0.0), false, false });
  return Trace(all, scene.Lights, scene.Medium, ray);
}

inline bool IsInShadow(Scene& scene, vtkLight* lamp, const Ray& ray, double t)
{
  return std::any_of(scene.Triangles.begin(), scene.Triangles.end(), [&](const Triangle& triangle) {
    Interval shadow;
    return FindShadow(triangle, GetPosition(lamp), ray, shadow) && shadow.From < t && t < shadow.To;
  });
}

// What a ray may show wrongly since whether a light arrives is known at 16 nodes alone: between a lit
// node and one in shadow the share goes from 1 to 0 in a straight line, which over the interval
// differs from a step by at most half of it.
inline double GetEdgeError(
  Scene& scene, const Slab& slab, const Ray& ray, double from, double length)
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

// A sample of the slab, by T C + L.
inline glm::dvec3 GetSample(Scene& scene, const Slab& slab, const Ray& ray, double t)
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

// The sum of VTK's samples over what is behind. `opacity` is that of all of them, as the frame in
// clear air shows it. VTK's samples lie at whole steps from 1 on and stand for the step before them,
// so that the sum is, to second order in the step, the integral with samples half a step farther.
inline glm::dvec3 GetThroughSlab(Scene& scene, const Slab& slab, const Ray& ray, double opacity,
  const glm::dvec3& behind, int panels)
{
  const double from = GetSpan(slab, ray).From;
  const double length = -std::log(1.0 - opacity) / slab.Kappa;
  glm::dvec3 sum = (1.0 - opacity) * behind;
  for (int panel = 0; panel < panels; ++panel)
  {
    static const airlight_test::GaussRule rule = airlight_test::MakeGaussRule();
    for (int i = 0; i < airlight_test::GaussCount; ++i)
    {
      const double s = length * (panel + 0.5 + 0.5 * rule.X[i]) / panels;
      sum += 0.5 * rule.W[i] * length / panels * slab.Kappa * std::exp(-slab.Kappa * s) *
        GetSample(scene, slab, ray, from + s + 0.5 * slab.Step);
    }
  }
  return sum;
}
}

#endif
