// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Region/AirlightRegionKinds.h"

#include "Region/AirlightSurfaceTree.h"
#include "vtkParticipatingMedium.h"

#include <iterator>
#include <memory>

namespace airlight
{
namespace
{
using Medium = vtkParticipatingMedium;

bool ConvertUnbounded(Medium*, const glm::dvec3&, f64::AirlightRegion&) { return true; }

bool ConvertBox(Medium* medium, const glm::dvec3& origin, f64::AirlightRegion& region)
{
  const double* bounds = medium->GetBounds();
  region.boxMin = glm::dvec3(bounds[0], bounds[2], bounds[4]) - origin;
  region.boxMax = glm::dvec3(bounds[1], bounds[3], bounds[5]) - origin;
  return true;
}

bool ConvertSphere(Medium* medium, const glm::dvec3& origin, f64::AirlightRegion& region)
{
  medium->GetCenter(&region.centre.x);
  region.centre -= origin;
  region.radius = medium->GetRadius();
  return true;
}

bool ConvertCylinder(Medium* medium, const glm::dvec3& origin, f64::AirlightRegion& region)
{
  medium->GetAxis(&region.axis.x);
  region.halfHeight = 0.5 * medium->GetHeight();
  return ConvertSphere(medium, origin, region); // centre and radius
}

bool ConvertSurface(Medium* medium, const glm::dvec3& origin, f64::AirlightRegion& region)
{
  const std::shared_ptr<const SurfaceTree> tree = medium->GetSurfaceTree();
  if (!tree)
  {
    return false;
  }
  region.boxMin = tree->GetLeast() - origin;
  region.boxMax = tree->GetGreatest() - origin;
  region.centre = tree->GetCentre() - origin;
  region.data = tree->GetTexels().data();
  region.nodes = tree->GetNodeCount();
  return true;
}

struct RegionKind
{
  int Type; // vtkParticipatingMedium::RegionType
  int Kind; // in shaders: the same number
  const char* Name;
  const char* Constant;
  bool (*Convert)(Medium* medium, const glm::dvec3& origin, f64::AirlightRegion& region);
};

constexpr RegionKind Kinds[] = {
  { Medium::UNBOUNDED, AIRLIGHT_REGION_UNBOUNDED, "Unbounded", "UNBOUNDED", &ConvertUnbounded },
  { Medium::BOX, AIRLIGHT_REGION_BOX, "Box", "BOX", &ConvertBox },
  { Medium::SPHERE, AIRLIGHT_REGION_SPHERE, "Sphere", "SPHERE", &ConvertSphere },
  { Medium::SURFACE, AIRLIGHT_REGION_SURFACE, "Surface", "SURFACE", &ConvertSurface },
  { Medium::CYLINDER, AIRLIGHT_REGION_CYLINDER, "Cylinder", "CYLINDER", &ConvertCylinder },
};

const RegionKind* FindKind(int type)
{
  for (const RegionKind& kind : Kinds)
  {
    if (kind.Type == type)
    {
      return &kind;
    }
  }
  return nullptr;
}
}

//------------------------------------------------------------------------------
std::string GetRegionName(int type)
{
  const RegionKind* kind = FindKind(type);
  return kind ? kind->Name : "";
}

//------------------------------------------------------------------------------
std::string ListRegionConstants()
{
  std::string list;
  for (const RegionKind& kind : Kinds)
  {
    const bool last = &kind == std::end(Kinds) - 1;
    list += (list.empty() ? "" : last ? " or " : ", ") + std::string(kind.Constant);
  }
  return list;
}

//------------------------------------------------------------------------------
bool ConvertRegion(
  vtkParticipatingMedium* medium, const glm::dvec3& origin, f64::AirlightRegion& region)
{
  const RegionKind* kind = FindKind(medium->GetRegion());
  region.kind = kind->Kind;
  // Positions that the kind does not use are in one place of the world, too: what is kept for a
  // region (LightGrids) is kept when the eye moves.
  region.boxMin = region.boxMax = region.centre = -origin;
  return kind->Convert(medium, origin, region);
}
}
