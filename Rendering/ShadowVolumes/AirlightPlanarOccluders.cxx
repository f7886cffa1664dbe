// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowVolumes/AirlightPlanarOccluders.h"

#include "Casters/AirlightCasterBox.h"
#include "Scene/AirlightCameraRays.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <tuple>
#include <utility>

namespace airlight
{
namespace
{
// Of the face's extent: how far inside its outline and behind its plane it is taken to lie, for
// roundings of what is drawn and what of the mesh is not quite flat.
constexpr double Inset = 1e-3;
constexpr double Setback = 1e-4;
// Of the clipping planes' depths.
constexpr double Margin = 0.01;
// Of its distance: smaller faces do not hide enough to be worth a look.
constexpr double LeastExtent = 0.2;
// Of lengths, in what the graphics card makes of them in single precision.
constexpr double Rounding = 1e-6;
// The view is probed by so many rays across and up; a face is to hide so many of them.
constexpr int Probes = 8;
constexpr int LeastProbes = 3;

// Corners from the eye.
std::optional<PlanarOccluder> MakeFace(
  const std::vector<glm::dvec3>& corners, const CameraRays& rays)
{
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& corner : corners)
  {
    middle += corner / static_cast<double>(corners.size());
  }
  double extent = 0.0;
  for (const glm::dvec3& corner : corners)
  {
    extent = std::max(extent, 2.0 * glm::distance(corner, middle));
  }
  glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  normal /= glm::length(normal) * (glm::dot(normal, middle) > 0.0 ? -1.0 : 1.0);
  const double height = -glm::dot(normal, middle);
  // As an eye in the plane sees nothing of it. Not true of what is not finite, either.
  if (!(extent >= LeastExtent * glm::length(middle)) || !(height > 10.0 * Setback * extent))
  {
    return {};
  }
  PlanarOccluder face;
  face.Plane = glm::dvec4(normal, height + Setback * extent);
  face.Sides.fill(-normal); // all behind the plane is inside of it
  for (size_t i = 0; i < corners.size(); ++i)
  {
    const glm::dvec3 from = glm::mix(corners[i], middle, Inset);
    const glm::dvec3 to = glm::mix(corners[(i + 1) % corners.size()], middle, Inset);
    const glm::dvec3 side = glm::normalize(glm::cross(from, to));
    face.Sides[i] = glm::dot(side, middle) < 0.0 ? -side : side;
  }
  // A ray meets the plane at a depth of -height dot(forward, ray) / dot(normal, ray).
  const glm::dvec3 deep = height * rays.GetForward();
  face.Sides[4] = glm::normalize(deep + (1.0 + Margin) * rays.GetNear() * normal);
  face.Sides[5] = -glm::normalize(deep + (1.0 - Margin) * rays.GetFar() * normal);
  return face;
}

//------------------------------------------------------------------------------
// Of a grid over the view.
int CountHiddenRays(const PlanarOccluder& face, const CameraRays& rays)
{
  int count = 0;
  for (int i = 0; i < Probes * Probes; ++i)
  {
    const glm::dvec2 place = (glm::dvec2(i % Probes, i / Probes) + 0.5) / double(Probes);
    const glm::dvec3 ray =
      rays.GetRay(place.x * rays.GetWidth(), place.y * rays.GetHeight()).Direction;
    count += glm::dot(glm::dvec3(face.Plane), ray) < 0.0 &&
      std::all_of(face.Sides.begin(), face.Sides.end(),
        [&](const glm::dvec3& side) { return glm::dot(side, ray) >= 0.0; });
  }
  return count;
}

//------------------------------------------------------------------------------
// Leaves out the sides that the whole view is inside of.
void LimitToView(PlanarOccluder& face, const std::array<CameraRays::Ray, 4>& corners)
{
  for (glm::dvec3& side : face.Sides)
  {
    if (std::all_of(corners.begin(), corners.end(),
          [&](const CameraRays::Ray& ray) { return glm::dot(side, ray.Direction) >= 0.0; }))
    {
      side = -glm::dvec3(face.Plane);
    }
  }
}

//------------------------------------------------------------------------------
using Candidate = std::pair<int, PlanarOccluder>; // with the number of rays that it hides

// Whatever the order of the casters.
bool ComesBefore(const Candidate& a, const Candidate& b)
{
  const auto key = [](const Candidate& candidate) {
    const glm::dvec4& plane = candidate.second.Plane;
    const glm::dvec3& side = candidate.second.Sides[0];
    return std::make_tuple(
      -candidate.first, plane.w, plane.x, plane.y, plane.z, side.x, side.y, side.z);
  };
  return key(a) < key(b);
}

//------------------------------------------------------------------------------
// The conditions on places and on directions are linear in them, and the rays from a light through
// a box before a plane meet that inside the outline of where those through its corners do: if the
// corners' are hidden, all are.
bool HidesShadow(const PlanarOccluder& face, const std::array<glm::dvec3, 8>& box,
  const glm::dvec4& light, const glm::dvec3& eye)
{
  const glm::dvec3 normal(face.Plane);
  return std::all_of(box.begin(), box.end(), [&](const glm::dvec3& corner) {
    const glm::dvec3 from = corner - eye;
    const glm::dvec3 away = light.w != 0.0 ? corner - glm::dvec3(light) : -glm::dvec3(light);
    const double speed = -glm::dot(normal, away);
    const double height = glm::dot(normal, from) + face.Plane.w;
    const glm::dvec3 place = from + height / speed * away;
    return speed > 0.0 && height > 0.0 &&
      std::all_of(face.Sides.begin(), face.Sides.end(), [&](const glm::dvec3& side) {
        return glm::dot(side, away) >= 0.0 &&
          glm::dot(side, place) > Rounding * (glm::length(from) + glm::length(place));
      });
  });
}
}

//------------------------------------------------------------------------------
std::vector<PlanarOccluder> FindPlanarOccluders(
  const std::vector<Caster>& casters, const std::vector<vtkProp*>& solid, const CameraRays& rays)
{
  std::vector<Candidate> found;
  for (const Caster& caster : casters)
  {
    if (rays.IsParallel() || !caster.Faces ||
      !std::binary_search(solid.begin(), solid.end(), caster.Owner, std::less<const vtkProp*>()))
    {
      continue;
    }
    for (const PlanarFace& flat : *caster.Faces)
    {
      std::vector<glm::dvec3> corners;
      for (const glm::dvec3& corner : flat)
      {
        corners.emplace_back(glm::dvec3(caster.ToWorld * glm::dvec4(corner, 1.0)) - rays.GetEye());
      }
      const std::optional<PlanarOccluder> face = MakeFace(corners, rays);
      const int hidden = face ? CountHiddenRays(*face, rays) : 0;
      if (hidden >= LeastProbes)
      {
        found.emplace_back(hidden, *face);
      }
    }
  }
  std::sort(found.begin(), found.end(), ComesBefore);
  found.resize(std::min(found.size(), MostPlanarOccluders));
  std::vector<PlanarOccluder> faces;
  for (Candidate& candidate : found)
  {
    LimitToView(candidate.second, rays.GetCornerRays());
    faces.push_back(candidate.second);
  }
  return faces;
}

//------------------------------------------------------------------------------
std::vector<glm::vec4> FindTruncationPlanes(const std::vector<Caster>& casters,
  const std::vector<PlanarOccluder>& faces, const glm::dvec4& light, const glm::dvec3& eye)
{
  std::vector<glm::vec4> ends(casters.size() + 1, glm::vec4(0.0f));
  for (size_t i = 0; i < casters.size() && !faces.empty(); ++i)
  {
    const std::array<glm::dvec3, 8> box = GetCorners(casters[i]);
    const auto face = std::find_if(faces.begin(), faces.end(),
      [&](const PlanarOccluder& other) { return HidesShadow(other, box, light, eye); });
    if (face != faces.end())
    {
      ends[i] = glm::vec4(face->Plane);
    }
  }
  return ends;
}
}
