// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a volume takes away of the light that passes through it (AirlightVolumeOpacity.h), as an
 * image of density. Between the volume's points extinction is not linear, as the opacity function
 * is applied to interpolated scalars: so the image has up to four samples along each axis for each
 * of the volume's. Of volumes of more than 2^21 points it has fewer, each a mean.
 *
 * Not installed; exported for the module's own tests.
 */

#ifndef AirlightVolumeExtinction_h
#define AirlightVolumeExtinction_h

#include "Density/AirlightDensityGrid.h"
#include "vtkAirlightModule.h" // for export macro
#include "vtkImageData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <glm/glm.hpp>

#include <map>
#include <memory>
#include <string>

class vtkMatrix4x4;
class vtkVolume;

namespace airlight
{
// The same as an image, with densities from 0 to 1.
struct VolumeImage
{
  vtkSmartPointer<vtkImageData> Image; // placed in the world
  double SigmaT = 0.0;                 // extinction at density 1, 1/world
  int Refinement = 1;                  // samples for each of the volume's, along an axis
};

// With an array VolumeAlbedos of the volume's colours, if these are asked for: means over what a
// sample stands for, by extinction. No image, and a reason, if the volume's opacity is no function
// of its scalars alone; no image alone if it is all transparent.
constexpr const char* VolumeAlbedos = "Albedo";
VTKAIRLIGHT_EXPORT VolumeImage MakeVolumeImage(
  vtkVolume* volume, vtkMatrix4x4* toWorld, bool colours, std::string& reason);

// The latest time of what a volume's image depends on, but for its matrix.
vtkMTimeType GetVolumeTime(vtkVolume* volume);

struct VTKAIRLIGHT_EXPORT VolumeExtinction
{
  std::shared_ptr<const DensityGrid> Grid; // densities from 0 to 1, placed in the world
  double SigmaT = 0.0;                     // extinction at density 1, 1/world
  int Refinement = 1;                      // samples for each of the volume's, along an axis

  // Null, and a reason, if the volume cannot cast a shadow; null alone if it is all transparent.
  static std::shared_ptr<const VolumeExtinction> Build(
    vtkVolume* volume, vtkMatrix4x4* toWorld, std::string& error);
};

// Those of the last frames.
class VTKAIRLIGHT_EXPORT VolumeExtinctions
{
public:
  // VolumeExtinction::Build(), again only if what it depends on has changed.
  std::shared_ptr<const VolumeExtinction> Get(
    vtkVolume* volume, vtkMatrix4x4* toWorld, std::string& error);

  // Forgets those that were not used in the last few frames: renderers may share a pass.
  void Forget();

private:
  struct Entry
  {
    vtkMTimeType Time = 0;
    glm::dmat4 ToWorld{ 0.0 };
    std::shared_ptr<const VolumeExtinction> Values;
    std::string Error;
    int Age = 0; // calls of Forget() since it was used
  };

  std::map<vtkVolume*, Entry> Entries;
};
}

#endif
