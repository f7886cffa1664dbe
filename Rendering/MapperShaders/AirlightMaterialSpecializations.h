// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The coefficients of materials that are known when the mappers' shaders are made
 * (AirlightSpecialization.h), and when the shaders have to be made again.
 *
 * A mapper's shader serves all actors that share the mapper, and VTK makes it again if it is
 * drawn with a property that has changed since, but not if an actor gets another one.
 */

#ifndef AirlightMaterialSpecializations_h
#define AirlightMaterialSpecializations_h

#include "MapperShaders/AirlightSpecialization.h"

#include "vtkType.h"

#include <map>
#include <vector>

class vtkAbstractMapper;
class vtkActor;
class vtkProp;

namespace airlight
{
class MaterialSpecializations
{
public:
  // Before a frame: of all that it draws. `known`: whether that is all of it. True where some
  // mapper's shader says something else and VTK would not make it again: then all are to be, so
  // that no frame depends on those before it.
  bool Update(const std::vector<vtkActor*>& actors, bool known);

  // While a mapper's shader is made: what is known of its actors. Remembers it as the shader's.
  MaterialSpecialization Compile(vtkProp* prop);

private:
  struct Entry
  {
    MaterialSpecialization Current;  // of all actors of this frame
    MaterialSpecialization Compiled; // the shader
    vtkMTimeType CompileTime = 0;    // when that was; 0: there is none that is up to date
    bool AllNewer = false;           // all of its properties are, so that VTK makes it again
    bool Drawn = false;              // in this frame
  };
  void AddActor(vtkActor* actor);
  void Invalidate();

  std::map<vtkAbstractMapper*, Entry> Entries; // not read through
  bool CoversAll = false;
};
}

#endif
