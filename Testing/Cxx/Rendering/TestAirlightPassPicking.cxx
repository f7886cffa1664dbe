// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Selections, picks and depths through vtkAirlightPass are those without it.

#include "AirlightTestWindowScene.h"

#include "vtkCellPicker.h"
#include "vtkHardwareSelector.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkPropPicker.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkWorldPointPicker.h"

#include <set>

using namespace airlight_test;

namespace
{
// A viewport off the window's origin; a body that lets light through.
struct PickScene : WindowScene
{
  PickScene()
    : WindowScene(160, 120, 2)
  {
    this->Cube->GetProperty()->SetOpacity(0.5);
    this->Renderer->SetViewport(0.25, 0.25, 1.0, 1.0);
  }
};

//------------------------------------------------------------------------------
// Everything in the viewport: props, and ids of their points or cells.
using Selected = std::map<vtkProp*, std::set<vtkIdType>>;

Selected Select(PickScene& scene, int association)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetArea(40, 30, 159, 119);
  selector->SetFieldAssociation(association);
  const auto selection = vtk::TakeSmartPointer(selector->Select());
  Selected selected;
  for (unsigned int i = 0; selection && i < selection->GetNumberOfNodes(); ++i)
  {
    vtkSelectionNode* node = selection->GetNode(i);
    auto* prop = vtkProp::SafeDownCast(node->GetProperties()->Get(vtkSelectionNode::PROP()));
    auto* ids = vtkIdTypeArray::SafeDownCast(node->GetSelectionList());
    for (vtkIdType k = 0; ids && k < ids->GetNumberOfValues(); ++k)
    {
      selected[prop].insert(ids->GetValue(k));
    }
  }
  return selected;
}

void TestHardwareSelector(PickScene& scene)
{
  for (const int association :
    { vtkDataObject::FIELD_ASSOCIATION_CELLS, vtkDataObject::FIELD_ASSOCIATION_POINTS })
  {
    const std::string what =
      association == vtkDataObject::FIELD_ASSOCIATION_CELLS ? "cells" : "points";
    scene.Renderer->SetPass(nullptr);
    scene.Window->Render();
    const Selected without = Select(scene, association);
    scene.Renderer->SetPass(scene.Pass);
    const Buffers before = scene.Render();
    const Picture picture = Capture(scene.Window);
    const Selected with = Select(scene, association);
    size_t ids = 0;
    for (const auto& entry : without)
    {
      ids += entry.second.size();
    }
    std::cout << "selector: " << without.size() << " props with " << ids << " " << what
              << (with == without ? ", the same" : ", not the same") << " with the pass\n";
    Check(without.size() == 3 && ids > 20, "selector: there is something to select: " + what);
    Check(with == without, "selector: the same " + what);
    CheckSame(before, scene.Render(), "frame after the selection of " + what);
    Check(Compare(picture, Capture(scene.Window)) == 0, "picture after the selection of " + what);
  }
}

//------------------------------------------------------------------------------
struct Pick
{
  vtkProp* Prop = nullptr;
  vtkProp* CellProp = nullptr;
  vtkIdType Cell = -1;
  double CellPosition[3] = { 0.0, 0.0, 0.0 };
  double Z = 0.0;
  double World[3] = { 0.0, 0.0, 0.0 };
};

Pick PickAt(PickScene& scene, int x, int y)
{
  Pick pick;
  pick.Z = scene.Renderer->GetZ(x, y);
  vtkNew<vtkWorldPointPicker> world;
  world->Pick(x, y, 0, scene.Renderer);
  world->GetPickPosition(pick.World);
  vtkNew<vtkCellPicker> cells;
  cells->SetTolerance(0.0);
  cells->Pick(x, y, 0, scene.Renderer);
  pick.CellProp = cells->GetViewProp();
  pick.Cell = cells->GetCellId();
  cells->GetPickPosition(pick.CellPosition);
  vtkNew<vtkPropPicker> props;
  props->Pick(x, y, 0, scene.Renderer);
  pick.Prop = props->GetViewProp();
  // The selection of props drew over the picture.
  scene.Window->Render();
  return pick;
}

double Distance(const double a[3], const double b[3])
{
  return glm::length(glm::dvec3(a[0], a[1], a[2]) - glm::dvec3(b[0], b[1], b[2]));
}

void TestPicks(PickScene& scene)
{
  int props = 0;
  int other = 0;
  double z = 0.0;
  double position = 0.0;
  double world = 0.0;
  int count = 0;
  for (int y = 35; y < 120; y += 12)
  {
    for (int x = 45; x < 160; x += 12, ++count)
    {
      scene.Renderer->SetPass(nullptr);
      scene.Window->Render();
      const Pick a = PickAt(scene, x, y);
      scene.Renderer->SetPass(scene.Pass);
      scene.Window->Render();
      const Pick b = PickAt(scene, x, y);
      props += a.Prop != nullptr;
      other += a.Prop != b.Prop || a.CellProp != b.CellProp || a.Cell != b.Cell;
      z = std::max(z, std::abs(a.Z - b.Z));
      position = std::max(position, Distance(a.CellPosition, b.CellPosition));
      const double distance = glm::length(glm::dvec3(b.World[0], b.World[1] - 1, b.World[2] - 10));
      world = std::max(world, Distance(a.World, b.World) * 0.1 / (distance * distance));
    }
  }
  std::cout << count << " picks, " << props << " of a prop: " << other
            << " are others with the pass; GetZ differs by " << z << ", cell positions by "
            << position << ", world points by " << world << " of depth"
            << "\n";
  Check(props > 30 && props < count, "picks: some hit, some miss");
  Check(other == 0, "picks: the same props and cells");
  Check(z <= 1e-5, "GetZ() is the same");
  Check(position == 0.0, "cell positions are the same");
  // Depth 1 - 0.1/d, nearly, at distance d, has 24 bits: the bit that GetZ() may be off by, and
  // half a bit of rounding on either side, move a point by d^2/0.1 times as much.
  Check(world <= 2.0 / (1 << 24), "world points are the same");
}
}

//------------------------------------------------------------------------------
int TestAirlightPassPicking(int, char*[])
{
  PickScene scene;
  TestHardwareSelector(scene);
  TestPicks(scene);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
