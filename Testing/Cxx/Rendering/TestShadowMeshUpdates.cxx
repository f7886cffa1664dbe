// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Meshes whose geometry is swapped, as animations do: each frame is that of a pass that knows
// nothing of the frames before, also where the new points, polygons or strips are older than what
// they replace.

#include "AirlightTestWindowScene.h"

#include "vtkStripper.h"

#include <functional>

using namespace airlight_test;

namespace
{
vtkSmartPointer<vtkPolyData> MakeBall(double x, bool strips)
{
  vtkSmartPointer<vtkPolyData> ball = MakeSphere(0.8);
  for (vtkIdType i = 0; i < ball->GetNumberOfPoints(); ++i)
  {
    double p[3];
    ball->GetPoint(i, p);
    ball->GetPoints()->SetPoint(i, p[0] + x, p[1], p[2]);
  }
  if (!strips)
  {
    return ball;
  }
  vtkNew<vtkStripper> stripper;
  stripper->SetInputData(ball);
  stripper->Update();
  return stripper->GetOutput();
}

// A ball over a floor.
struct BallScene : Scene
{
  explicit BallScene(vtkPolyData* ball)
    : Scene(80, 60)
  {
    vtkNew<vtkCubeSource> floor;
    floor->SetBounds(-6, 6, -2.1, -2, -6, 6);
    this->Add(floor);
    this->Add(ball);
    this->AddPointLight({ 0.5, 4.0, 1.0 });
  }
};

vtkSmartPointer<vtkPolyData> ShareGeometry(vtkPolyData* data)
{
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->SetPoints(data->GetPoints());
  copy->SetPolys(data->GetPolys());
  copy->SetStrips(data->GetStrips());
  return copy;
}

// Draws a mesh before and after a change, which has to be seen.
void TestChange(
  const std::string& what, vtkPolyData* mesh, const std::function<void(vtkPolyData*)>& change)
{
  BallScene scene(mesh);
  const Buffers before = scene.Render();
  change(mesh);
  const Buffers after = scene.Render();
  BallScene fresh(ShareGeometry(mesh));
  const double changed = CompareBuffers(before.at("Airlight"), after.at("Airlight"));
  const double wrong = CompareBuffers(fresh.Render(), after);
  std::cout << what << ": changes airlight by " << changed << ", off by " << wrong << "\n";
  Check(changed > 1e-3, what + ": the shadow moves");
  Check(wrong == 0.0, what + ": the frame is that of a new pass");
}
}

//------------------------------------------------------------------------------
int TestShadowMeshUpdates(int, char*[])
{
  for (const bool strips : { false, true })
  {
    const std::string kind = strips ? "strips" : "polygons";
    // In the order of their times: what is made first is oldest.
    const vtkSmartPointer<vtkPolyData> right = MakeBall(1.5, strips);
    const vtkSmartPointer<vtkPolyData> left = MakeBall(-1.5, strips);
    (strips ? left->GetStrips() : left->GetPolys())->Modified();
    TestChange(kind + ", older points", left,
      [&](vtkPolyData* mesh) { mesh->SetPoints(right->GetPoints()); });
    TestChange(kind + ", newer points", right,
      [&](vtkPolyData* mesh) { mesh->SetPoints(MakeBall(-1.5, strips)->GetPoints()); });

    const vtkSmartPointer<vtkPolyData> half = MakeBall(0.0, strips);
    vtkNew<vtkCellArray> some;
    vtkCellArray* cells = strips ? half->GetStrips() : half->GetPolys();
    for (vtkIdType i = 0; i < cells->GetNumberOfCells() / 2; ++i)
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      cells->GetCellAtId(i, size, ids);
      some->InsertNextCell(size, ids);
    }
    const vtkSmartPointer<vtkPolyData> whole = MakeBall(0.0, strips);
    whole->GetPoints()->Modified();
    TestChange(kind + ", older cells", whole,
      [&](vtkPolyData* mesh) { strips ? mesh->SetStrips(some) : mesh->SetPolys(some); });
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
