// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Long lists of shadow boundaries: exact against brute force, the same bits whatever the memory
// they are given, and the same bits each time. Memory that they just fill, and pictures with more
// rows than there is memory for: all boundaries are kept.

#include "AirlightTestBodies.h"
#include "AirlightTestCompareScene.h"
#include "AirlightTestWindowScene.h"

#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
// Thin upright strips beside the view, one behind another; the light from the side draws their
// shadows across it. Each ray enters and leaves each shadow.
void AddStrips(Scene& scene, int count)
{
  scene.Pass->SetMaximumBoundariesPerPixel(VTK_DOUBLE_MAX); // shadow planes
  std::vector<Triangle> triangles;
  const double step = 48.0 / count;
  for (int i = 0; i < count; ++i)
  {
    const double front = 8.0 - step * i;
    const double back = front - 0.5 * step;
    triangles.push_back({ { 30, -40, front }, { 30, -40, back }, { 30, 40, back } });
    triangles.push_back({ { 30, -40, front }, { 30, 40, back }, { 30, 40, front } });
  }
  scene.Add(MakeSoup(triangles));
  scene.AddPointLight({ 60, 1, -10 }, { 3000, 2000, 1000 });
}

double GetLargest(vtkImageData* image) { return image->GetScalarRange()[1]; }

double Sum(vtkImageData* image)
{
  double sum = 0.0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    sum += image->GetPointData()->GetScalars()->GetComponent(i, 0);
  }
  return sum;
}

//------------------------------------------------------------------------------
void TestLongLists()
{
  Scene scene(32, 24);
  AddStrips(scene, 1200);
  // Where many short parts are lit, their roundings add up.
  Limits limits;
  limits.Median = 1e-5;
  limits.P99 = 4e-5;
  CompareScene("1200 strips", scene, 120, limits);
  const double most = GetLargest(scene.GetBuffer("BoundaryCount"));
  std::cout << "  " << most << " boundaries on one pixel\n";
  Check(most > 1000.0, "more than 1000 boundaries on a pixel");
}

//------------------------------------------------------------------------------
// More boundaries than the first buffer of 2^21 holds.
void TestGrowth()
{
  Scene scene(300, 200);
  AddStrips(scene, 40);
  CompareScene("buffer that grows", scene, 500);
  const double boundaries = Sum(scene.GetBuffer("BoundaryCount"));
  std::cout << "  " << boundaries << " boundaries in the picture\n";
  Check(boundaries > (1 << 21), "more boundaries than the first buffer holds");
  const Buffers first = scene.CopyBuffers();
  scene.Window->Render();
  CheckSame(first, scene.CopyBuffers(), "second frame after the buffer grew");

  Scene limited(300, 200);
  AddStrips(limited, 40);
  // On request; the automatic technique takes shadow maps where there are so many bands.
  limited.Pass->SetShadowTechniqueToShadowPlanes();
  limited.Pass->SetMemoryLimit(1);
  limited.Window->Render();
  CheckSame(first, limited.CopyBuffers(), "frame drawn in bands");
  limited.Window->Render();
  CheckSame(first, limited.CopyBuffers(), "second frame drawn in bands");
  limited.Pass->SetMemoryLimit(1024);
  limited.Window->Render();
  CheckSame(first, limited.CopyBuffers(), "limit raised");
  limited.Pass->SetMemoryLimit(1);
  limited.Window->Render();
  CheckSame(first, limited.CopyBuffers(), "limit lowered");
}

//------------------------------------------------------------------------------
// Triangles beyond the light, whose shadows lie outside the view.
vtkActor* AddEdgesElsewhere(Scene& scene, int count)
{
  std::vector<Triangle> triangles;
  for (int i = 0; i < count; ++i)
  {
    const double y = 0.01 * (i % 100);
    const double z = 0.01 * (i / 100);
    triangles.push_back({ { 80, y, z }, { 80, y + 0.005, z }, { 80, y, z + 0.005 } });
  }
  return scene.Add(MakeSoup(triangles));
}

// With more than 8192 silhouette edges a pixel has 32 slots instead of 16: the same bits.
void TestKBufferSize()
{
  Scene scene(160, 120);
  AddStrips(scene, 30);
  vtkActor* many = AddEdgesElsewhere(scene, 3000);
  CompareScene("more than 8192 silhouette edges", scene, 500);
  const Buffers buffers = scene.CopyBuffers();
  const double most = GetLargest(scene.GetBuffer("BoundaryCount"));
  Check(most > 32.0, "more boundaries than slots");
  vtkNew<vtkInformation> keys;
  keys->Set(vtkAirlightPass::CASTS_SHADOW(), 0);
  many->SetPropertyKeys(keys);
  scene.Window->Render();
  CheckSame(buffers, scene.CopyBuffers(), "few silhouette edges");
}

//------------------------------------------------------------------------------
// Two windows in turns, each with its own pass.
void TestTwoWindows()
{
  Scene first(120, 90);
  AddStrips(first, 100);
  first.AddPointLight({ -20, 10, 5 }, { 500, 400, 300 });
  Scene second(120, 90);
  AddStrips(second, 100);
  second.AddPointLight({ -20, 10, 5 }, { 500, 400, 300 });
  first.Window->Render();
  second.Window->Render();
  const Buffers buffers = first.CopyBuffers();
  CheckSame(buffers, second.CopyBuffers(), "second window");
  first.Window->Render();
  CheckSame(buffers, first.CopyBuffers(), "first window again");
  second.Window->SetSize(60, 40);
  second.Window->Render();
  second.Window->SetSize(120, 90);
  second.Window->Render();
  CheckSame(buffers, second.CopyBuffers(), "second window after a change of size");
}

//------------------------------------------------------------------------------
// 64 bytes a pixel: a MiB holds 19 rows of 640 pixels in the three quarters that slots may take.
void TestRows()
{
  WindowScene scene(640, 120);
  const Buffers all = scene.Render();
  scene.Pass->SetMemoryLimit(1);
  const double difference = CompareBuffers(all, scene.Render());
  std::cout << "six bands of rows: off by " << difference << "\n";
  Check(difference == 0.0, "a picture in bands is the same");
}

// Four sheets of glass on the far left, whose shadows reach across the view: each ray crosses two
// planes of each. The lists have room for 2^18 boundaries, one of which is not used, so that all
// but one fit.
void TestFullList()
{
  constexpr int sheets = 4;
  Scene scene(256, 128);
  scene.Look({ 0, 0, 10 }, { 0, 0, 0 });
  scene.Renderer->GetActiveCamera()->SetViewAngle(10.0);
  scene.AddPointLight({ -100, 0, 0 }, glm::dvec3(1e4));
  for (int i = 0; i < sheets; ++i)
  {
    AddGlass(scene, MakeSheet({ -50, -40, 0.3 * i }, { 0, 0, 0.1 }, { 0, 80, 0 }), glm::dvec3(0.5));
  }
  scene.Window->Render();
  vtkDataArray* counts = scene.GetBuffer("BoundaryCount")->GetPointData()->GetScalars();
  int wrong = 0;
  for (vtkIdType i = 0; i < counts->GetNumberOfTuples(); ++i)
  {
    wrong += counts->GetComponent(i, 0) != 2 * sheets;
  }
  std::cout << counts->GetNumberOfTuples() << " pixels, " << wrong << " without their "
            << 2 * sheets << " boundaries\n";
  Check(counts->GetNumberOfTuples() * 2 * sheets == 1 << 18, "as many as the lists have room for");
  Check(wrong == 0, "no boundary is lost");
}
}

//------------------------------------------------------------------------------
int TestShadowLists(int, char*[])
{
  TestLongLists();
  TestGrowth();
  TestKBufferSize();
  TestTwoWindows();
  TestRows();
  TestFullList();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
