// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The spherical harmonics of an equirectangular texture, as VTK orients it: texels run from -pi to
 * pi about the up axis, from the right axis on towards right x up, and rows from straight below to
 * straight above.
 */

#ifndef AirlightEnvironment_h
#define AirlightEnvironment_h

#include "Medium/AirlightSkyHarmonics.h"
#include "vtkAirlightModule.h" // for export macro
#include "vtkType.h"

#include <string>

class vtkImageData;
class vtkTexture;

namespace airlight
{
class VTKAIRLIGHT_EXPORT Environment
{
public:
  // False with an error where the texture or the axes are no good; then there are no harmonics. The
  // picture is read again after a change.
  bool Update(
    vtkTexture* texture, const glm::dvec3& up, const glm::dvec3& right, std::string& error);

  // In the world's axes.
  const SkyHarmonics& GetHarmonics() const { return this->Harmonics; }

private:
  bool Read(vtkTexture* texture, std::string& error);

  SkyHarmonics Own{}; // in the picture's axes: right, up, right x up
  SkyHarmonics Harmonics{};
  vtkImageData* Image = nullptr; // that was read; not to be used
  vtkMTimeType ImageTime = 0;
  bool Decoded = false;
};
}

#endif
