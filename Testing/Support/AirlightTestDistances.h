// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Distances that programs of their own draw (AirlightDepthPrePassVariants.h) beside those of the mappers'
 * programs.
 */

#ifndef AirlightTestDistances_h
#define AirlightTestDistances_h

#include "AirlightTestScene.h"

#include "vtkCallbackCommand.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"

namespace airlighttest
{
// Draws as its parent does. What a class that is not known sets between drawings nobody knows, so it
// keeps its program.
class OwnMapper : public vtkOpenGLPolyDataMapper
{
public:
  static OwnMapper* New();
  vtkTypeMacro(OwnMapper, vtkOpenGLPolyDataMapper);
};
inline OwnMapper* OwnMapper::New() { VTK_STANDARD_NEW_BODY(OwnMapper); }

using Change = std::function<void(vtkActor*, vtkPolyDataMapper*)>;

// Counts the drawings of which another program than the mapper's is bound right before.
class Scenery : public Scene
{
public:
  Scenery()
    : Scene(100, 75)
  {
    this->AddPointLight({ 2.0, 4.0, 3.0 });
    this->AddPointLight({ -3.0, 2.0, 4.0 });
    this->Count->SetClientData(this);
    this->Count->SetCallback([](vtkObject*, unsigned long, void* client, void* program) {
      auto* self = static_cast<Scenery*>(client);
      auto* window = vtkOpenGLRenderWindow::SafeDownCast(self->Window);
      self->Others += window->GetShaderCache()->GetLastShaderBound() != program ? 1 : 0;
    });
  }

  // After all other observers.
  void Watch(vtkPolyDataMapper* mapper)
  {
    mapper->AddObserver(vtkCommand::UpdateShaderEvent, this->Count, -1e6f);
  }

  int Others = 0;
  vtkNew<vtkCallbackCommand> Count;
};

// The picture's distances with an actor whose mapper is of this class.
inline vtkSmartPointer<vtkImageData> GetDepths(
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

inline int CountSurface(vtkImageData* depths)
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

// `programs`: the drawings of a frame that have a program for distances alone.
inline void CompareDistances(
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

#endif
