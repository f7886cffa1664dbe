// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
// Where a medium is; the rest of the class is in vtkParticipatingMedium.cxx.
#include "vtkParticipatingMedium.h"

#include "Region/AirlightSurfaceTree.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
void vtkParticipatingMedium::SetRegion(int type)
{
  if (type < UNBOUNDED || type > SURFACE)
  {
    vtkErrorMacro(<< "Region " << type
                  << " is not a region: use UNBOUNDED, BOX, SPHERE or SURFACE.");
    return;
  }
  if (this->Region != type)
  {
    this->Region = type;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkParticipatingMedium::SetBounds(
  double xmin, double xmax, double ymin, double ymax, double zmin, double zmax)
{
  const double bounds[6] = { xmin, xmax, ymin, ymax, zmin, zmax };
  for (int i = 0; i < 6; i += 2)
  {
    if (!std::isfinite(bounds[i]) || !std::isfinite(bounds[i + 1]) || bounds[i] > bounds[i + 1])
    {
      vtkErrorMacro(<< "Bounds (" << xmin << ", " << xmax << ", " << ymin << ", " << ymax << ", "
                    << zmin << ", " << zmax
                    << ") must be finite, each minimum at most its maximum; the old ones stay.");
      return;
    }
  }
  if (!std::equal(bounds, bounds + 6, this->Bounds))
  {
    std::copy(bounds, bounds + 6, this->Bounds);
    this->Modified();
  }
}

void vtkParticipatingMedium::SetBounds(const double bounds[6])
{
  this->SetBounds(bounds[0], bounds[1], bounds[2], bounds[3], bounds[4], bounds[5]);
}

//------------------------------------------------------------------------------
bool vtkParticipatingMedium::SetVector(
  const char* name, double target[3], double x, double y, double z)
{
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
  {
    vtkErrorMacro(<< name << " (" << x << ", " << y << ", " << z
                  << ") must be finite; the old one stays.");
    return false;
  }
  const double values[3] = { x, y, z };
  if (!std::equal(values, values + 3, target))
  {
    std::copy(values, values + 3, target);
    this->Modified();
  }
  return true;
}

bool vtkParticipatingMedium::SetNumber(
  const char* name, double& target, double value, bool accepted, const char* range)
{
  if (!std::isfinite(value) || !accepted)
  {
    vtkErrorMacro(<< name << " " << value << " must be " << range << "; it stays " << target
                  << ".");
    return false;
  }
  if (target != value)
  {
    target = value;
    this->Modified();
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkParticipatingMedium::SetCenter(double x, double y, double z)
{
  this->SetVector("Center", this->Center, x, y, z);
}

void vtkParticipatingMedium::SetCenter(const double center[3])
{
  this->SetCenter(center[0], center[1], center[2]);
}

void vtkParticipatingMedium::SetRadius(double radius)
{
  this->SetNumber("Radius", this->Radius, radius, radius >= 0.0, "finite and at least 0");
}

//------------------------------------------------------------------------------
void vtkParticipatingMedium::SetSurface(vtkPolyData* surface)
{
  if (this->Surface == surface)
  {
    return;
  }
  std::string error;
  std::shared_ptr<const airlight::SurfaceTree> tree;
  if (surface && !(tree = airlight::SurfaceTree::Build(surface, error)))
  {
    vtkErrorMacro(<< "The surface " << error << ". The old surface stays.");
    return;
  }
  this->Surface = surface;
  this->Tree = tree;
  this->TreeTime = surface ? surface->GetMTime() : 0;
  this->Modified();
}

vtkPolyData* vtkParticipatingMedium::GetSurface() { return this->Surface; }

//------------------------------------------------------------------------------
std::shared_ptr<const airlight::SurfaceTree> vtkParticipatingMedium::GetSurfaceTree()
{
  if (this->Region != SURFACE)
  {
    return nullptr;
  }
  const vtkMTimeType time = this->Surface ? this->Surface->GetMTime() : 0;
  if (this->Surface && time != this->TreeTime)
  {
    std::string error;
    this->Tree = airlight::SurfaceTree::Build(this->Surface, error);
    this->TreeTime = time;
    if (!this->Tree)
    {
      vtkErrorMacro(<< "The surface " << error << ". The medium is nowhere until it is mended.");
    }
  }
  if (!this->Surface && this->MissingSurfaceTime != this->GetMTime())
  {
    this->MissingSurfaceTime = this->GetMTime();
    vtkErrorMacro("The region is a surface and there is none: call SetSurface(). The medium is "
                  "nowhere until then.");
  }
  return this->Tree;
}
