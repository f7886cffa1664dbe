// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightClassTraits.h"

#include "Scene/AirlightVTKVersions.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkMapper.h"

#include <algorithm>
#include <cstring>
#include <initializer_list>

namespace airlight
{
namespace
{
struct Row
{
  const char* Name;
  std::initializer_list<ClassTrait> Traits;
};

bool IsA(vtkObject* object, std::initializer_list<const char*> names)
{
  return std::any_of(
    names.begin(), names.end(), [object](const char* name) { return object->IsA(name) != 0; });
}
}

//------------------------------------------------------------------------------
bool HasTrait(vtkObject* object, ClassTrait trait)
{
  using T = ClassTrait;
  static const Row rows[] = {
    // What vtkActor::New() makes with VTK's OpenGL, and its base class.
    { "vtkOpenGLActor", { T::DrawsItsMapper, T::DrawsItself } },
    { "vtkActor", { T::DrawsItsMapper, T::DrawsItself } },
    // ParaView's: draws its mapper with an actor inside, to which it gives all that it has; while
    // the camera moves, it draws something coarser.
    { "vtkPVLODActor", { T::DrawsItsMapper } },
    // An actor with axes as its mapper's input, in each of ParaView's views.
    { "vtkPVCenterAxesActor", { T::DrawsItsMapper, T::DrawsItself } },
    // Props in places. Not vtkPropAssembly, which gives no actors.
    { "vtkAssembly", { T::DrawsItsParts } },
    // Six actors. Its labels are drawn over the frame.
    { "vtkAxesActor", { T::DrawsItsParts, T::KeepsItsKeys } },
    { "vtkVolume", { T::NothingOpaque } },
    { "vtkMultiVolume", { T::NothingOpaque } },
    // What vtkPolyDataMapper::New() makes.
    { "vtkOpenGLPolyDataMapper",
      { T::InjectableShaders, T::DrawsItsInput, T::UsesItsProperty, T::OneProgram } },
    // Draws the surface of its input with a vtkPolyDataMapper inside. That one has the program.
    { "vtkDataSetMapper", { T::InjectableShaders, T::DrawsItsInput, T::UsesItsProperty } },
    // Draws blocks, which may be hidden or have opacities of their own, and for each of which it
    // sets some uniforms.
    { BlocksMapperName, { T::InjectableShaders, T::UsesItsProperty } },
    // The same by its former name, which VTK 9.3 and 9.4 keep.
    { "vtkCompositePolyDataMapper2", { T::InjectableShaders, T::UsesItsProperty } },
    // Draws glyphs with helpers whose shaders are those of vtkPolyDataMapper.
    { "vtkOpenGLGlyph3DMapper", { T::InjectableShaders } },
    // Not what is derived from it, as vtkOpaquePass.
    { "vtkDefaultPass", { T::OpaqueSurfaces } },
  };
  return object && std::any_of(std::begin(rows), std::end(rows), [&](const Row& row) {
    return std::strcmp(object->GetClassName(), row.Name) == 0 &&
      std::find(row.Traits.begin(), row.Traits.end(), trait) != row.Traits.end();
  });
}

//------------------------------------------------------------------------------
bool DrawsItsPolygons(vtkMapper* mapper)
{
  // Derived from vtkPolyDataMapper, but the points of their input stand for discs, balls and
  // cylinders.
  const auto others = { "vtkPointGaussianMapper", "vtkOpenGLSphereMapper", "vtkOpenGLStickMapper" };
  return IsA(mapper, { "vtkPolyDataMapper", "vtkDataSetMapper", "vtkCompositePolyDataMapper" }) &&
    !IsA(mapper, others);
}

//------------------------------------------------------------------------------
bool MayCastRays(vtkAbstractVolumeMapper* mapper)
{
  // The last two choose a mapper, or have one for each block.
  return IsA(
    mapper, { "vtkGPUVolumeRayCastMapper", "vtkSmartVolumeMapper", "vtkMultiBlockVolumeMapper" });
}
}
