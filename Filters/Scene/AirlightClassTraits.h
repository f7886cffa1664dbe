// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What Airlight relies on of single classes of VTK and ParaView. All of their names are here.
 *
 * Not installed; exported for the module's own tests.
 */

#ifndef AirlightClassTraits_h
#define AirlightClassTraits_h

#include "vtkAirlightModule.h" // for export macro

class vtkAbstractVolumeMapper;
class vtkMapper;
class vtkObject;

namespace airlight
{
enum class ClassTrait
{
  DrawsItsMapper,    // actors: their opaque geometry is what their mapper draws
  DrawsItself,       // actors: draw with that mapper at any time, and with no other prop
  DrawsItsParts,     // props: their geometry is what vtkProp::GetActors() and GetVolumes() draw
  KeepsItsKeys,      // and does not give them its property keys, which name the render passes
  NothingOpaque,     // props: draw nothing as opaque, though VTK takes any prop to do so
  InjectableShaders, // mappers: the pass adds to all shaders that they draw with
  DrawsItsInput,     // mappers: draw all of their input, where it is, in one opacity
  UsesItsProperty,   // mappers: shade with the coefficients of their actor's property
  OneProgram,        // mappers: draw with one program between two updates of its uniforms
  OpaqueSurfaces     // passes: draw opaque surfaces whatever the settings of the renderer
};

// Whether the object is of a class that has the trait. Derived classes may do anything else, and
// have none. False for null.
VTKAIRLIGHT_EXPORT bool HasTrait(vtkObject* object, ClassTrait trait);

// Whether a mapper, also of a derived class, draws the polygons of its input as they are. Others
// (point Gaussians, imposters) draw other geometry in their place.
VTKAIRLIGHT_EXPORT bool DrawsItsPolygons(vtkMapper* mapper);

// Whether a mapper, also of a derived class, may cast rays on the graphics card, with shaders that
// the pass can rewrite.
VTKAIRLIGHT_EXPORT bool MayCastRays(vtkAbstractVolumeMapper* mapper);
}

#endif
