// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The colours of a medium's density image by the name of an array, made again after a change of
 * either. For the library's own use.
 */

#ifndef AirlightMediumColours_h
#define AirlightMediumColours_h

#include "Density/AirlightImageColours.h"
#include "vtkImageData.h"

#include <memory>
#include <string>

namespace airlight
{
class MediumColours
{
public:
  // Null without grid or name, and with an error, once for each change, where the array is no
  // good. `grid`: of the image.
  std::shared_ptr<const ImageColours> Update(vtkImageData* image,
    const std::shared_ptr<const DensityGrid>& grid, const std::string& name, double most,
    std::string& error)
  {
    const vtkMTimeType time = grid && !name.empty() ? image->GetMTime() : 0;
    if (time != this->MadeTime || name != this->MadeName)
    {
      this->Made = time != 0 ? ImageColours::Build(image, *grid, name, most, error) : nullptr;
      error += error.empty() ? "" : ". The array is ignored until it is fixed.";
      error = error.empty() ? "" : "The density image " + error;
      this->MadeTime = time;
      this->MadeName = name;
    }
    return this->Made;
  }

private:
  std::shared_ptr<const ImageColours> Made;
  vtkMTimeType MadeTime = 0; // of the image
  std::string MadeName;
};
}

#endif
