// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Many lights, many actors, many triangles: time, memory, and pictures that have to be those of
// fewer.

#include "LoadTools.h"

#include "vtkAppendPolyData.h"
#include "vtkSphereSource.h"

#include <iomanip>

using namespace airlight_test;

namespace airlightload
{
namespace
{
void SetDefaultSize(const Options& options, int width, int height, int size[2])
{
  size[0] = options.Size.empty() ? width : options.Size[0];
  size[1] = options.Size.empty() ? height : options.Size[1];
}

// A first frame, in which shaders are compiled and casters prepared, and others with a moving
// camera.
void TimeFrames(Scene& scene, const std::string& what, int frames)
{
  const double before = GetResident();
  Clock clock;
  scene.Window->Render();
  scene.Window->WaitForCompletion();
  const double first = clock.GetSeconds();
  clock = Clock();
  for (int i = 0; i < frames; ++i)
  {
    scene.Renderer->GetActiveCamera()->Azimuth(i % 2 == 0 ? 1.0 : -1.0);
    scene.Window->Render();
    scene.Window->WaitForCompletion();
  }
  std::cout << what << ", " << scene.Width << " x " << scene.Height << ": first frame " << first
            << " s, then " << clock.GetSeconds() / frames << " s a frame; " << before
            << " MiB before, " << GetResident() << " MiB after, " << GetPeak() << " MiB at most\n";
}

// The same without the pass.
void TimePlain(Scene& scene, const std::string& what)
{
  scene.Renderer->SetPass(nullptr);
  TimeFrames(scene, what + " without the medium", 2);
  scene.Renderer->SetPass(scene.Pass);
}

// The share of values that differ by more than this part of the largest.
double CompareShare(vtkImageData* a, vtkImageData* b, double most)
{
  const auto* p = static_cast<const float*>(a->GetScalarPointer());
  const auto* q = static_cast<const float*>(b->GetScalarPointer());
  const vtkIdType count = a->GetNumberOfPoints() * a->GetNumberOfScalarComponents();
  const double largest = *std::max_element(p, p + count);
  vtkIdType different = 0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    different += std::abs(p[i] - q[i]) <= most * largest ? 0 : 1;
  }
  Check(largest > 0.0, "something is seen");
  return static_cast<double>(different) / static_cast<double>(count);
}
}

//------------------------------------------------------------------------------
// As many lamps in one place, of one part of the power each, are one lamp. Sums of that many
// numbers in single precision are off by some 64 roundings of 6e-8.
void RunLights(const Options& options)
{
  int size[2];
  SetDefaultSize(options, 320, 240, size);
  const glm::dvec3 power(40.0, 30.0, 20.0);
  WindowScene one(size[0], size[1], 0);
  one.Lights[0]->SetPosition(2.5, 4.0, 1.5);
  one.Window->Render();
  WindowScene scene(size[0], size[1], 0);
  scene.Renderer->RemoveAllLights();
  for (int k = 0; k < options.Lights; ++k)
  {
    scene.AddPointLight({ 2.5, 4.0, 1.5 }, power / static_cast<double>(options.Lights));
  }
  TimeFrames(scene, std::to_string(options.Lights) + " lights", 2);
  for (const char* name : { "Radiance", "Airlight" })
  {
    const double off = CompareBuffers(one.GetBuffer(name), scene.GetBuffer(name));
    std::cout << name << " is off by " << off << " of the largest value\n";
    Check(off < 1e-5, std::string("many lamps are one: ") + name);
  }
  Check(AreSame(one.GetBuffer("Depth"), scene.GetBuffer("Depth")), "the same distances");
}

//------------------------------------------------------------------------------
namespace
{
// `known`: that nothing is seen through the floor, behind which casters' planes may then end, all
// of one caster together.
void FillActors(Scene& scene, int count, bool merged, bool known)
{
  scene.AddPointLight({ 5, 9, 4 }, { 200, 180, 160 });
  vtkNew<vtkCubeSource> floor;
  floor->SetBounds(-9, 9, -3.1, -3, -9, 9);
  scene.Add(floor, [known](vtkActor* actor) {
    if (!known)
    {
      airlight_test::MakeUnknown(actor);
    }
  });
  vtkNew<vtkAppendPolyData> all;
  const int side = static_cast<int>(std::ceil(std::cbrt(count)));
  for (int i = 0; i < count; ++i)
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetThetaResolution(8);
    ball->SetPhiResolution(6);
    ball->SetRadius(1.2 / side * (1.0 + 0.5 * std::sin(i)));
    const double step = 8.0 / side;
    ball->SetCenter((i % side + 0.3 * std::sin(3.0 * i)) * step - 4.0,
      i / side % side * 0.7 * step - 2.4, (i / side / side + 0.3 * std::cos(5.0 * i)) * step - 4.0);
    if (merged)
    {
      all->AddInputData(Make(ball));
    }
    else
    {
      scene.Renderer->AddActor(Scene::MakeActor(Make(ball)));
    }
  }
  if (merged)
  {
    scene.Renderer->AddActor(Scene::MakeActor(Make(all)));
  }
}
}

namespace
{
Buffers DrawActors(const int size[2], int count, bool merged, bool known)
{
  Scene scene(size[0], size[1]);
  FillActors(scene, count, merged, known);
  scene.Window->Render();
  return scene.CopyBuffers();
}
}

// Each caster of its own, or all in one mesh: the same shadows, to the last bit where all planes
// have the same ends. Where they have not, their sides are rounded otherwise, which some pixels on
// them see.
void RunActors(const Options& options)
{
  int size[2];
  SetDefaultSize(options, 320, 240, size);
  Scene scene(size[0], size[1]);
  FillActors(scene, options.Actors, false, true);
  TimeFrames(scene, std::to_string(options.Actors) + " actors", 2);
  const Buffers many = scene.CopyBuffers();
  CheckFinite(many, "many actors");
  TimePlain(scene, std::to_string(options.Actors) + " actors");
  Scene one(size[0], size[1]);
  FillActors(one, options.Actors, true, true);
  TimeFrames(one, "the same in one actor", 2);
  const double off = CompareShare(one.GetBuffer("Airlight"), many.at("Airlight"), 1e-3);
  std::cout << "of the airlight " << 100.0 * off << " % are off by more than a thousandth\n";
  Check(off < 1e-3, "many actors are one");
  CheckSame(DrawActors(size, options.Actors, true, false),
    DrawActors(size, options.Actors, false, false), "many actors are one, planes without ends");
}

//------------------------------------------------------------------------------
namespace
{
// A ball with about so many triangles.
void AddBall(Scene& scene, double triangles)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(2.0);
  const int side = static_cast<int>(std::sqrt(triangles / 4.0));
  ball->SetThetaResolution(2 * side);
  ball->SetPhiResolution(side + 2);
  ball->Update();
  std::cout << ball->GetOutput()->GetNumberOfPolys() << " triangles, " << GetResident()
            << " MiB with the mesh\n";
  scene.Renderer->AddActor(Scene::MakeActor(ball->GetOutput()));
  scene.AddPointLight({ 3, 5, 1 }, { 80, 70, 60 });
}
}

// A ball of triangles is smaller than the true one by an eighth of the square of the angle between
// its corners: with 25 000 triangles 2e-4 of the radius. Less than a hundredth of the pixels sees a
// difference of 1e-3 from that.
void RunTriangles(const Options& options)
{
  int size[2];
  SetDefaultSize(options, 320, 240, size);
  Scene coarse(size[0], size[1]);
  AddBall(coarse, std::min(options.Triangles / 8.0, 200e3));
  coarse.Window->Render();
  Scene fine(size[0], size[1]);
  AddBall(fine, options.Triangles);
  TimeFrames(fine, "triangles", 2);
  Check(fine.Pass->GetEffectiveShadowTechnique() == vtkAirlightPass::SHADOW_PLANES,
    "shadows come from planes");
  const double share = CompareShare(coarse.GetBuffer("Airlight"), fine.GetBuffer("Airlight"), 1e-3);
  std::cout << 100.0 * share << " % of the airlight differ by more than 1e-3 from that of the "
            << "coarser ball\n";
  Check(share < 0.01, "the shadow of a ball is that of a coarser one");
  CheckFinite(fine.CopyBuffers(), "many triangles");
  TimePlain(fine, "triangles");
}
}
