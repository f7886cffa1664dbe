// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowVolumes/AirlightClippedRegions.h"

#include "Casters/AirlightCasterBox.h"
#include "Scene/AirlightCameraRays.h"

#include <algorithm>
#include <limits>

namespace airlight
{
namespace
{
// Of regions beyond their ends, as roundings of what the graphics card clips ask for.
constexpr double EndMargin = 0.01;

// Above 0 where all of the points are in front of the plane.
template <typename Points>
double GetLeast(const glm::dvec4& plane, const Points& points)
{
  double least = std::numeric_limits<double>::infinity();
  for (const glm::dvec4& point : points)
  {
    least = std::min(least, glm::dot(plane, point));
  }
  return least;
}

glm::dvec4 MakePlane(const glm::dvec3& normal, const glm::dvec3& point)
{
  return glm::dvec4(normal, -glm::dot(normal, point));
}
}

//------------------------------------------------------------------------------
ClippedRegions::ClippedRegions(const CameraRays& rays, bool anyPicture)
  : Eye(rays.GetEye())
  , AnyPicture(anyPicture)
{
  const std::array<CameraRays::Ray, 4> corners = rays.GetCornerRays();
  const CameraRays::Ray middle = rays.GetRay(0.5 * rays.GetWidth(), 0.5 * rays.GetHeight());
  this->InFront.End = glm::dvec4(rays.GetForward(), -(1.0 + EndMargin) * rays.GetNear());
  this->Beyond.End = glm::dvec4(-rays.GetForward(), (1.0 - EndMargin) * rays.GetFar());
  for (size_t i = 0; i < corners.size(); ++i)
  {
    const CameraRays::Ray& ray = corners[i];
    const CameraRays::Ray& next = corners[(i + 1) % corners.size()];
    const glm::dvec3 across = next.Origin + next.Direction - ray.Origin;
    const glm::dvec4 side = MakePlane(glm::cross(ray.Direction, across), ray.Origin);
    const glm::dvec4 inside(middle.Origin + middle.Direction, 1.0);
    this->Sides[i] = glm::dot(side, inside) < 0.0 ? -side : side;

    const double nearest = (1.0 + EndMargin) * ray.Nearest;
    const double farthest = (1.0 - EndMargin) * ray.Farthest;
    this->InFront.Corners.emplace_back(ray.Origin + nearest * ray.Direction, 1.0);
    this->InFront.Corners.push_back(
      rays.IsParallel() ? glm::dvec4(-ray.Direction, 0.0) : glm::dvec4(ray.Origin, 1.0));
    this->Beyond.Corners.emplace_back(ray.Origin + farthest * ray.Direction, 1.0);
    this->Beyond.Corners.emplace_back(ray.Direction, 0.0);
  }
}

//------------------------------------------------------------------------------
// Where one of the view's sides, the clipping plane or one of the box's sides is between the two.
bool ClippedRegions::IsOutside(const Box& box, const Region& region) const
{
  if (GetLeast(region.End, box) > 0.0)
  {
    return true;
  }
  if (this->AnyPicture)
  {
    return false;
  }
  if (std::any_of(this->Sides.begin(), this->Sides.end(),
        [&](const glm::dvec4& side) { return GetLeast(-side, box) > 0.0; }))
  {
    return true;
  }
  const glm::dvec3 edges[3] = { box[1] - box[0], box[2] - box[0], box[4] - box[0] };
  for (int axis = 0; axis < 3; ++axis)
  {
    const glm::dvec3 normal = glm::cross(edges[(axis + 1) % 3], edges[(axis + 2) % 3]);
    for (const double sign : { -1.0, 1.0 })
    {
      // Of the side that the normal points out of.
      const double reach = -GetLeast(glm::dvec4(-sign * normal, 0.0), box);
      if (GetLeast(glm::dvec4(sign * normal, -reach), region.Corners) > 0.0)
      {
        return true;
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool ClippedRegions::MayCutOff(const Caster& caster) const
{
  const std::array<glm::dvec3, 8> corners = GetCorners(caster);
  Box box;
  std::transform(corners.begin(), corners.end(), box.begin(),
    [this](const glm::dvec3& corner) { return glm::dvec4(corner - this->Eye, 1.0); });
  return !this->IsOutside(box, this->InFront) || !this->IsOutside(box, this->Beyond);
}
}
