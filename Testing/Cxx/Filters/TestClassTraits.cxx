// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Which classes of VTK have which traits; derived classes have none.

#include "Scene/AirlightClassTraits.h"

#include "Scene/AirlightVTKVersions.h"
#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkDataSetMapper.h"
#include "vtkDefaultPass.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkFollower.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMultiVolume.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpaquePass.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPolyDataMapper.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkVolume.h"

#include <cstdlib>
#include <initializer_list>
#include <iostream>
#include <string>

using namespace airlight;

namespace
{
int Failures = 0;

void Check(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "Failed: " << what << "\n";
    ++Failures;
  }
}

class DerivedActor : public vtkActor
{
public:
  static DerivedActor* New();
  vtkTypeMacro(DerivedActor, vtkActor);
};
vtkStandardNewMacro(DerivedActor);

class DerivedMapper : public vtkOpenGLPolyDataMapper
{
public:
  static DerivedMapper* New();
  vtkTypeMacro(DerivedMapper, vtkOpenGLPolyDataMapper);
};
vtkStandardNewMacro(DerivedMapper);

// These traits and no others.
void CheckTraits(vtkObject* object, std::initializer_list<ClassTrait> traits)
{
  for (int i = 0; i <= static_cast<int>(ClassTrait::OpaqueSurfaces); ++i)
  {
    bool expected = false;
    for (ClassTrait trait : traits)
    {
      expected = expected || static_cast<int>(trait) == i;
    }
    Check(HasTrait(object, static_cast<ClassTrait>(i)) == expected,
      std::string("trait ") + std::to_string(i) + " of " +
        (object ? object->GetClassName() : "null"));
  }
}
}

int TestClassTraits(int, char*[])
{
  using T = ClassTrait;
  CheckTraits(nullptr, {});
  CheckTraits(vtkNew<vtkActor>(), { T::DrawsItsMapper, T::DrawsItself });
  CheckTraits(vtkNew<DerivedActor>(), {});
  CheckTraits(vtkNew<vtkFollower>(), {});
  CheckTraits(vtkNew<vtkVolume>(), { T::NothingOpaque });
  CheckTraits(vtkNew<vtkMultiVolume>(), { T::NothingOpaque });
  CheckTraits(vtkNew<vtkAssembly>(), { T::DrawsItsParts });
  CheckTraits(vtkNew<vtkPolyDataMapper>(),
    { T::InjectableShaders, T::DrawsItsInput, T::UsesItsProperty, T::OneProgram });
  CheckTraits(vtkNew<DerivedMapper>(), {});
  CheckTraits(
    vtkNew<vtkDataSetMapper>(), { T::InjectableShaders, T::DrawsItsInput, T::UsesItsProperty });
  CheckTraits(vtkNew<BlocksMapper>(), { T::InjectableShaders, T::UsesItsProperty });
  CheckTraits(vtkNew<vtkGlyph3DMapper>(), { T::InjectableShaders });
  CheckTraits(vtkNew<vtkPointGaussianMapper>(), {});
  CheckTraits(vtkNew<vtkDefaultPass>(), { T::OpaqueSurfaces });
  CheckTraits(vtkNew<vtkOpaquePass>(), {});

  Check(DrawsItsPolygons(vtkNew<vtkPolyDataMapper>()), "polygons of vtkPolyDataMapper");
  Check(DrawsItsPolygons(vtkNew<DerivedMapper>()), "polygons of a derived mapper");
  Check(DrawsItsPolygons(vtkNew<vtkDataSetMapper>()), "polygons of vtkDataSetMapper");
  Check(DrawsItsPolygons(vtkNew<BlocksMapper>()), "polygons of blocks");
  Check(!DrawsItsPolygons(vtkNew<vtkPointGaussianMapper>()), "point Gaussians");
  Check(!DrawsItsPolygons(vtkNew<vtkOpenGLSphereMapper>()), "imposters");
  Check(!DrawsItsPolygons(vtkNew<vtkGlyph3DMapper>()), "glyphs");

  Check(MayCastRays(vtkNew<vtkSmartVolumeMapper>()), "rays of vtkSmartVolumeMapper");
  Check(MayCastRays(vtkNew<vtkGPUVolumeRayCastMapper>()), "rays of vtkGPUVolumeRayCastMapper");
  Check(!MayCastRays(vtkNew<vtkFixedPointVolumeRayCastMapper>()), "rays on the processor");
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
