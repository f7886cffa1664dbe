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

namespace airlight_test
{
// Draws as its parent does. What a class that is not known sets between drawings nobody knows, so it
// keeps its program.
class OwnMapper : public vtkOpenGLPolyDataMapper
{
public:
  static OwnMapper* New();
  vtkTypeMacro(OwnMapper, vtkOpenGLPolyDataMapper);
};

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
vtkSmartPointer<vtkImageData> GetDepths(
  vtkPolyDataMapper* mapper, vtkPolyData* data, const Change& change, int& others);

int CountSurface(vtkImageData* depths);

// `programs`: the drawings of a frame that have a program for distances alone.
void CompareDistances(
  const std::string& name, vtkPolyData* data, int programs, const Change& change);
}

#endif
