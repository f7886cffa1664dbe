// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Programs of mappers for the stages that do not shade: distances, and records of translucent
 * fragments.
 *
 * In these stages a mapper's program ends before it shades, by a branch. Renderers that run both
 * sides of every branch (Mesa's on processors) shade all the same, and graphics cards set aside the
 * registers for it. So what is about to be drawn gets a variant: the same shaders without what
 * comes after that branch (GetStageMacro()), attributes at the same locations, and the same values
 * of uniforms. Making the mapper's shaders again for each stage, as VTK can, takes longer than it
 * saves.
 */

#ifndef AirlightStageVariants_h
#define AirlightStageVariants_h

#include "MapperShaders/AirlightSurfaceShader.h"

#include "vtkAbstractMapper.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <map>
#include <utility>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace airlight
{
// From a location in a program to one in the current program.
using CopyUniform = void (*)(unsigned int program, int from, int to);

class StageVariants
{
public:
  // When a mapper asks for its uniforms: what it draws from now on, until StopObserving(), is drawn
  // by its program's variant for this stage, if it has one.
  void Observe(vtkOpenGLRenderWindow* window, vtkAbstractMapper* mapper, SurfaceStage stage);
  void StopObserving();

  void Release() { this->Variants.clear(); }

private:
  // One element of what both programs know.
  struct Uniform
  {
    int From; // location in the mapper's program
    int To;   // in the variant
    CopyUniform Copy;
  };
  struct Variant
  {
    vtkWeakPointer<vtkShaderProgram> Original;
    int OriginalHandle = 0;
    vtkWeakPointer<vtkShaderProgram> Program; // null: it has none
    int Handle = 0;
    std::vector<Uniform> Uniforms;
  };

  void Use(vtkShaderProgram* program);
  static bool IsCurrent(const Variant& variant);
  static Variant Make(vtkOpenGLRenderWindow* window, vtkShaderProgram* program, SurfaceStage stage);
  static bool Link(Variant& variant);
  static bool FindUniforms(Variant& variant);

  std::map<std::pair<vtkShaderProgram*, SurfaceStage>, Variant> Variants;
  std::map<vtkSmartPointer<vtkAbstractMapper>, unsigned long> Observed; // and the observers
  vtkNew<vtkCallbackCommand> Command;
  vtkOpenGLRenderWindow* Window = nullptr;     // while mappers are observed
  SurfaceStage Stage = SurfaceStage::Distance; // likewise
};
}

#endif
