// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Memory that shadow boundaries just fill, and pictures with more rows than there is memory for: all
// boundaries are kept.

#include "AirlightTestCheck.h"
#include "AirlightTestGlass.h"
#include "AirlightWindowScene.h"

#include <cstdlib>

using namespace airlighttest;

namespace
{
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

// Four sheets of glass on the far left, whose shadows reach across the view: each ray crosses two planes of
// each. The lists have room for 2^18 boundaries, one of which is not used, so that all but one fit.
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
int TestShadowBands(int, char*[])
{
  TestRows();
  TestFullList();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
