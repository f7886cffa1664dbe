// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestDistances.h"

namespace airlight_test
{
//------------------------------------------------------------------------------
OwnMapper* OwnMapper::New() { VTK_STANDARD_NEW_BODY(OwnMapper); }

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> GetDepths(
  vtkPolyDataMapper* mapper, vtkPolyData* data, const Change& change, int& others)
{
  Scenery scene;
  mapper->SetInputData(data);
  vtkSmartPointer<vtkActor> actor = Scene::MakeActor(mapper);
  actor->SetPosition(0.3, -0.2, 0.4);
  actor->RotateWXYZ(30.0, 1.0, 0.3, 0.2);
  change(actor, mapper);
  scene.Renderer->AddActor(actor);
  scene.Watch(mapper);
  scene.Window->Render();
  // The second frame has the programs that the first one made.
  scene.Renderer->GetActiveCamera()->Azimuth(7.0);
  scene.Others = 0;
  auto copy = vtkSmartPointer<vtkImageData>::New();
  copy->DeepCopy(scene.Render().at("Depth"));
  others = scene.Others;
  return copy;
}

//------------------------------------------------------------------------------
int CountSurface(vtkImageData* depths)
{
  int count = 0;
  for (int y = 0; y < 75; ++y)
  {
    for (int x = 0; x < 100; ++x)
    {
      count += GetValue(depths, x, y) > 0.0 ? 1 : 0;
    }
  }
  return count;
}

//------------------------------------------------------------------------------
void CompareDistances(
  const std::string& name, vtkPolyData* data, int programs, const Change& change)
{
  int ours = 0;
  int others = 0;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<OwnMapper> own;
  const vtkSmartPointer<vtkImageData> a = GetDepths(mapper, data, change, ours);
  const vtkSmartPointer<vtkImageData> b = GetDepths(own, data, change, others);
  const int pixels = CountSurface(a);
  std::cout << name << ": " << pixels << " pixels, " << ours << " programs for distances\n";
  Check(AreSame(a, b), name + ": the same distances");
  Check(pixels > 50, name + ": there is something to see");
  Check(ours == programs, name + ": " + std::to_string(programs) + " programs for distances");
  Check(others == 0, name + ": a class that is not known keeps its program");
}
}
