// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
// How a medium's density varies; the rest of the class is in vtkParticipatingMedium.cxx.
#include "vtkParticipatingMedium.h"

#include "Density/AirlightDensityGrid.h"
#include "vtkImageData.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
void vtkParticipatingMedium::SetDensity(int type)
{
  if (type < UNIFORM || type > IMAGE)
  {
    vtkErrorMacro(<< "Density " << type
                  << " is not a density: use UNIFORM, EXPONENTIAL_HEIGHT or IMAGE.");
    return;
  }
  if (this->Density != type)
  {
    this->Density = type;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkParticipatingMedium::SetScaleHeight(double height)
{
  this->SetNumber("ScaleHeight", this->ScaleHeight, height, height > 0.0, "finite and above 0");
}

void vtkParticipatingMedium::SetReferenceHeight(double height)
{
  this->SetNumber("ReferenceHeight", this->ReferenceHeight, height, true, "finite");
}

void vtkParticipatingMedium::SetUp(double x, double y, double z)
{
  // Its square may be beyond all numbers.
  const double largest = std::max({ std::abs(x), std::abs(y), std::abs(z) });
  const bool finite = std::isfinite(x) && std::isfinite(y) && std::isfinite(z);
  if (!finite || largest == 0.0)
  {
    vtkErrorMacro(<< "Up (" << x << ", " << y << ", " << z
                  << ") must be a direction: finite and not 0; the old one stays.");
    return;
  }
  const double up[3] = { x / largest, y / largest, z / largest };
  const double length = std::hypot(up[0], up[1], up[2]);
  this->SetVector("Up", this->Up, up[0] / length, up[1] / length, up[2] / length);
}

void vtkParticipatingMedium::SetUp(const double up[3]) { this->SetUp(up[0], up[1], up[2]); }

//------------------------------------------------------------------------------
void vtkParticipatingMedium::SetDensityImage(vtkImageData* image)
{
  if (this->DensityImage == image)
  {
    return;
  }
  std::string error;
  std::shared_ptr<const airlight::DensityGrid> grid;
  if (image && !(grid = airlight::DensityGrid::Build(image, error)))
  {
    vtkErrorMacro(<< "The density image " << error << ". The old image stays.");
    return;
  }
  this->DensityImage = image;
  this->Grid = grid;
  this->GridTime = image ? image->GetMTime() : 0;
  this->Modified();
}

vtkImageData* vtkParticipatingMedium::GetDensityImage() { return this->DensityImage; }

//------------------------------------------------------------------------------
std::shared_ptr<const airlight::DensityGrid> vtkParticipatingMedium::GetDensityGrid()
{
  if (this->Density != IMAGE)
  {
    return nullptr;
  }
  const vtkMTimeType time = this->DensityImage ? this->DensityImage->GetMTime() : 0;
  if (this->DensityImage && time != this->GridTime)
  {
    std::string error;
    this->Grid = airlight::DensityGrid::Build(this->DensityImage, error);
    this->GridTime = time;
    if (!this->Grid)
    {
      vtkErrorMacro(<< "The density image " << error
                    << ". The medium is nowhere until it is mended.");
    }
  }
  if (!this->DensityImage && this->MissingImageTime != this->GetMTime())
  {
    this->MissingImageTime = this->GetMTime();
    vtkErrorMacro(
      "The density is an image and there is none: call SetDensityImage(). The medium is "
      "nowhere until then.");
  }
  return this->Grid;
}
