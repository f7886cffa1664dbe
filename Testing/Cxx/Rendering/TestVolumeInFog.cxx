// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Volumes in fog: each sample's colour becomes C T(t) + L(0, t) before it is blended, with the
// shadows in the air before it, and is lit by what arrives of the lights. A slab of constant
// density against quadrature along the ray of brute force.

#include "AirlightTestQuadrature.h"
#include "AirlightTestVolume.h"

#include "vtkProperty.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
//------------------------------------------------------------------------------
// Where the ray is in the slab.
Interval GetSpan(const Slab& slab, const Ray& ray)
{
  return ClipToBox({ 0.0, Infinity }, ray, slab.Low, slab.High);
}

//------------------------------------------------------------------------------
// What the air before distance t scatters into the ray, brute force.
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
bool IsInShadow(Scene& scene, vtkLight* light, const Ray& ray, double t)
{
  return std::any_of(scene.Triangles.begin(), scene.Triangles.end(), [&](const Triangle& triangle) {
    Interval shadow;
    return FindShadow(triangle, GetPosition(light), ray, shadow) && shadow.From < t &&
      t < shadow.To;
  });
}

//------------------------------------------------------------------------------
// What a ray may show wrongly since whether a light arrives is known at 16 nodes alone: between a
// lit node and one in shadow the share goes from 1 to 0 in a straight line, which over the interval
// differs from a step by at most half of it.
double GetEdgeError(Scene& scene, const Slab& slab, const Ray& ray, double from, double length)
{
  const int steps = 200;
  double sum = 0.0;
  for (vtkLight* light : scene.Lights)
  {
    int edges = 0;
    double most = 0.0;
    bool shadowed = IsInShadow(scene, light, ray, from);
    for (int i = 0; i <= steps; ++i)
    {
      const double t = from + length * i / steps;
      const glm::dvec3 x = ray.Origin + t * ray.Direction;
      const bool before = shadowed;
      shadowed = IsInShadow(scene, light, ray, t);
      edges += shadowed != before ? 1 : 0;
      for (const double side : { -1.0, 1.0 })
      {
        const glm::dvec3 c =
          slab.Colour * Shade(scene.Medium, light, x, glm::dvec3(0.0, 0.0, side));
        most = std::max({ most, c.x, c.y, c.z });
      }
    }
    sum += edges * 0.5 * length / 15.0 * slab.Kappa * most;
  }
  return sum;
}

//------------------------------------------------------------------------------
// A sample of the slab, by T C + L.
glm::dvec3 GetSample(Scene& scene, const Slab& slab, const Ray& ray, double t)
{
  const glm::dvec3 x = ray.Origin + t * ray.Direction;
  glm::dvec3 passes;
  vtkAirlight::Transmittance(scene.Medium, &ray.Origin.x, &x.x, &passes.x);
  glm::dvec3 arriving(slab.Lit ? 0.0 : 1.0);
  for (vtkLight* light : scene.Lights)
  {
    const bool lit = slab.Lit && !IsInShadow(scene, light, ray, t);
    for (const double side : { -1.0, 1.0 }) // it is lit from both
    {
      arriving += lit ? Shade(scene.Medium, light, x, glm::dvec3(0.0, 0.0, side)) : glm::dvec3(0.0);
    }
  }
  return slab.Colour * arriving * passes + GetAirBefore(scene, ray, t).Airlight;
}

//------------------------------------------------------------------------------
// The sum of VTK's samples over what is behind. `opacity` is that of all of them, as the frame in
// clear air shows it. VTK's samples lie at whole steps from 1 on and stand for the step before
// them, so that the sum is, to second order in the step, the integral with samples half a step
// farther.
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

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> Draw(Scene& scene, bool foggy)
{
  scene.Pass->SetMedium(foggy ? scene.Medium.Get() : nullptr);
  scene.Window->Render();
  auto copy = vtkSmartPointer<vtkImageData>::New();
  copy->DeepCopy(scene.GetBuffer("Radiance"));
  return copy;
}

struct Limits
{
  double Median;
  double Largest;
};

// Errors are absolute, of radiances up to about 1.
bool CompareSlab(const std::string& name, Scene& scene, const Slab& slab, int rays, Limits limits,
  int panels = 1, double leastShadow = 0.0)
{
  scene.Window->Render();
  vtkNew<vtkImageData> depth;
  depth->DeepCopy(scene.GetBuffer("Depth"));
  const auto behindClear = Draw(scene, false);
  const auto behind = Draw(scene, true);
  const vtkSmartPointer<vtkVolume> volume = AddSlab(scene, slab);
  volume->GetProperty()->ShadeOff();
  const auto clear = Draw(scene, false);
  volume->GetProperty()->SetShade(slab.Lit);
  const auto foggy = Draw(scene, true);
  Comparison comparison(name);
  Random random(5);
  std::vector<double> errors;
  double change = 0.0;
  double shadow = 0.0; // what the slab's end misses of its airlight through shadows, relative
  for (int i = 0; i < rays;)
  {
    const int x = random.Index(scene.Width);
    const int y = random.Index(scene.Height);
    const Ray ray = scene.GetRay(x + 0.5, y + 0.5);
    const Interval span = GetSpan(slab, ray);
    if (!(span.To > span.From + 0.2))
    {
      continue;
    }
    ++i;
    // Of the channel in which the slab differs most from what is behind it.
    const glm::dvec3 b = GetColour(behindClear, x, y);
    const glm::dvec3 difference = glm::abs(slab.Colour - b);
    const int channel = difference.x > difference.y ? (difference.x > difference.z ? 0 : 2)
                                                    : (difference.y > difference.z ? 1 : 2);
    const double opacity = (GetColour(clear, x, y) - b)[channel] / (slab.Colour - b)[channel];
    const double surface = GetValue(depth, x, y);
    // VTK takes one sample more or less.
    const double length =
      std::max(0.0, (surface >= 0.0 ? std::min(surface, span.To) : span.To) - span.From);
    Check(std::abs(-std::log(1.0 - opacity) / slab.Kappa - length) < 2.5 * slab.Step,
      Text(name, ", pixel ", x, " ", y, ": the slab is ", -std::log(1.0 - opacity) / slab.Kappa,
        " thick, expected ", length));
    const glm::dvec3 expected =
      GetThroughSlab(scene, slab, ray, opacity, GetColour(behind, x, y), panels);
    const Answer atEnd = GetAirBefore(scene, ray, span.From + length);
    shadow = std::max(shadow, 1.0 - atEnd.Airlight.x / atEnd.Unshadowed.x);
    const glm::dvec3 value = GetColour(foggy, x, y);
    const glm::dvec3 error = glm::abs(value - expected);
    errors.push_back(std::max({ error.x, error.y, error.z }));
    change = std::max(change, glm::length(value - GetColour(clear, x, y)));
    const double edges = slab.Lit && leastShadow > 0.0
      ? GetEdgeError(scene, slab, ray, span.From, std::max(length, slab.Step))
      : 0.0;
    comparison.Add(errors.back(), limits.Largest + edges, [&] {
      return Text("pixel ", x, " ", y, ": ", value.x, " ", value.y, " ", value.z, ", expected ",
        expected.x, " ", expected.y, " ", expected.z);
    });
  }
  std::sort(errors.begin(), errors.end());
  const double median = errors[errors.size() / 2];
  std::cout << name << ": median error " << median << ", up to " << shadow << " in shadow\n";
  Check(median <= limits.Median, Text(name, ": median error ", median));
  Check(shadow >= leastShadow, Text(name, ": some rays miss ", shadow, " of their airlight"));
  Check(change > 0.05, name + ": fog changes the picture");
  scene.Renderer->RemoveVolume(volume);
  return AllOk({ &comparison });
}

//------------------------------------------------------------------------------
constexpr Limits Smooth = { 5e-7, 1.7e-6 };

bool TestSlab()
{
  Scene scene;
  scene.Pass->SetShadowTechniqueToNone();
  scene.AddPointLight({ 2, 4, 3 }, { 8.0, 6.0, 4.0 });
  // Along z: VTK's normals in volumes are those of such a camera alone.
  scene.Look({ 0, 0, 10 }, { 0, 0, 0 });
  Slab slab;
  bool ok = CompareSlab("slab", scene, slab, 60, Smooth);
  slab.Lit = true;
  ok = CompareSlab("lit slab", scene, slab, 60, Smooth) && ok;
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(2.5);
  return CompareSlab("lit slab, parallel projection", scene, slab, 60, Smooth) && ok;
}

// In the air before the slab, in it and on it.
bool TestShadows()
{
  Scene scene;
  scene.Look({ 0, 0, 10 }, { 0, 0, 0 });
  scene.AddPointLight({ 6, 0.3, 0 }, { 200.0, 150.0, 100.0 });
  scene.AddPointLight({ -4, 3, 3 }, { 20.0, 30.0, 40.0 });
  // Before, inside and behind the slab.
  for (const double z : { 2.0, 0.0, -3.0 })
  {
    scene.Add(MakeSphere(0.8), [z](vtkActor* actor) { actor->SetPosition(-0.9 * z, 0.3, z); });
  }
  // Between a light and the slab, along which its shadow goes.
  scene.Add(MakeSphere(0.4), [](vtkActor* actor) { actor->SetPosition(4.0, 0.3, 0); });
  Slab slab;
  slab.Colour *= 0.2;
  const bool ok = CompareSlab("slab among spheres", scene, slab, 60, { 1e-6, 1e-4 }, 6, 0.2);
  slab.Lit = true; // its samples stay below 1, at which VTK clips them
  return CompareSlab("lit slab among spheres", scene, slab, 40, { 1e-5, 1e-4 }, 6, 0.2) && ok;
}

bool TestSun()
{
  Scene scene;
  scene.Look({ 0, 0, 10 }, { 0, 0, 0 });
  scene.Pass->SetShadowTechniqueToNone();
  scene.Medium->SetRegionToBox();
  scene.Medium->SetBounds(-2, 2, -3, 3, -2, 0.4);
  scene.AddDirectionalLight({ 0.3, 1.0, 1.0 }, glm::dvec3(1.0));
  Slab slab;
  slab.Lit = true;
  const Limits limits = { 1e-5, 1e-4 };
  const bool ok = CompareSlab("sun, edge of the fog in the slab", scene, slab, 60, limits, 6);
  // VTK 9.2 and later number those with a position first.
  scene.AddPointLight({ 2, 4, 3 }, { 8.0, 6.0, 4.0 });
  slab.Colour *= 0.5; // its samples stay below 1, at which VTK clips them
  return CompareSlab("sun and light", scene, slab, 60, limits, 6) && ok;
}
}

//------------------------------------------------------------------------------
int TestVolumeInFog(int, char*[])
{
  const bool slab = TestSlab();
  const bool shadows = TestShadows();
  const bool sun = TestSun();
  return slab && shadows && sun && Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
