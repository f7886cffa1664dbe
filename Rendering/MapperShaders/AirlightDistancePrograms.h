// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Programs of mappers that draw distances and nothing else.
 *
 * In the stage of distances a mapper's program ends before it shades, by a branch. Renderers that run
 * both sides of every branch (Mesa's on processors) shade all the same, and graphics cards set aside
 * the registers for it. So what is about to be drawn gets a twin: the same shaders without what comes
 * after that branch (AIRLIGHT_ONLY_DISTANCES), attributes at the same places, and the same values of
 * uniforms. Making the mapper's shaders anew for each stage, as VTK can, takes longer than it saves.
 */

#ifndef AirlightDistancePrograms_h
#define AirlightDistancePrograms_h

#include "vtkAbstractMapper.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <map>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace airlight
{
// From a place in a program to one in the current program.
using CopyUniform = void (*)(unsigned int program, int from, int to);

class DistancePrograms
{
public:
  // In the stage of distances, when a mapper asks for its uniforms: what it draws from now on, until
  // Unwatch(), is drawn by its program's twin, if it has one.
  void Watch(vtkOpenGLRenderWindow* window, vtkAbstractMapper* mapper);
  void Unwatch();

  void Release() { this->Twins.clear(); }

private:
  // One element of what both programs know.
  struct Uniform
  {
    int From; // location in the mapper's program
    int To;   // in the twin
    CopyUniform Copy;
  };
  struct Twin
  {
    vtkWeakPointer<vtkShaderProgram> Original;
    int OriginalHandle = 0;
    vtkWeakPointer<vtkShaderProgram> Program; // null: it has none
    int Handle = 0;
    std::vector<Uniform> Uniforms;
  };

  void Use(vtkShaderProgram* program);
  static bool IsCurrent(const Twin& twin);
  static Twin Make(vtkOpenGLRenderWindow* window, vtkShaderProgram* program);
  static bool Link(Twin& twin);
  static bool FindUniforms(Twin& twin);

  std::map<vtkShaderProgram*, Twin> Twins;
  std::map<vtkSmartPointer<vtkAbstractMapper>, unsigned long> Watched; // and the observers
  vtkNew<vtkCallbackCommand> Command;
  vtkOpenGLRenderWindow* Window = nullptr; // while mappers are watched
};
}

#endif
