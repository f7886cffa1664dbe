// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowVolumes/AirlightBoundaryEstimate.h"

#include "Scene/AirlightCameraUniforms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace airlight
{
namespace
{
// Four corners, and one more for each of the planes that cut them.
constexpr size_t MostCorners = 9;

struct Polygon
{
  std::array<glm::dvec4, MostCorners> Corners;
  size_t Count = 0;

  void Add(const glm::dvec4& corner) { this->Corners[this->Count++] = corner; }
};

// All casters of a prop together.
struct PropBoundaries
{
  const vtkProp* Prop = nullptr;
  double Boundaries = 0.0;
  bool Stays = false; // some of them let light through
};

// What is on the positive side of a plane in clip coordinates.
Polygon Clip(const Polygon& polygon, const glm::dvec4& plane)
{
  Polygon inside;
  for (size_t i = 0; i < polygon.Count; ++i)
  {
    const glm::dvec4& a = polygon.Corners[i];
    const glm::dvec4& b = polygon.Corners[(i + 1) % polygon.Count];
    const double heightA = glm::dot(plane, a);
    const double heightB = glm::dot(plane, b);
    if (heightA >= 0.0)
    {
      inside.Add(a);
    }
    if ((heightA >= 0.0) != (heightB >= 0.0))
    {
      inside.Add(a + heightA / (heightA - heightB) * (b - a));
    }
  }
  return inside;
}

// Of the picture, by a polygon in clip coordinates.
double GetCoveredShare(Polygon polygon)
{
  // The picture's sides and the near clipping plane.
  for (const glm::dvec4& plane : { glm::dvec4(0, 0, 1, 1), glm::dvec4(1, 0, 0, 1),
         glm::dvec4(-1, 0, 0, 1), glm::dvec4(0, 1, 0, 1), glm::dvec4(0, -1, 0, 1) })
  {
    polygon = Clip(polygon, plane);
  }
  double area = 0.0;
  for (size_t i = 0; i < polygon.Count; ++i)
  {
    const glm::dvec4& p = polygon.Corners[i];
    const glm::dvec4& q = polygon.Corners[(i + 1) % polygon.Count];
    const double scale = p.w * q.w;
    area += scale > 0.0 ? (p.x * q.y - p.y * q.x) / scale : 0.0;
  }
  // The picture's area is 4.
  return 0.125 * std::abs(area);
}
}

//------------------------------------------------------------------------------
BoundaryEstimate::BoundaryEstimate(
  const CameraUniforms& view, const glm::dvec3& anchor, const glm::dvec4& light)
  : ToClip(view.GetClipMatrix(anchor))
  , Anchor(anchor - view.GetEye())
  , FromLight(light.w != 0.0 ? glm::dvec4(0.0, 0.0, 0.0, 1.0) : glm::dvec4(-glm::dvec3(light), 0.0))
{
}

//------------------------------------------------------------------------------
// As glsl/AirlightPlanesVS.glsl.
glm::dvec4 BoundaryEstimate::GetFarCorner(
  const glm::dvec3& point, const glm::vec4& truncation) const
{
  const glm::dvec3 away = this->FromLight.w == 0.0 ? glm::dvec3(this->FromLight) : point;
  const glm::dvec3 normal(truncation);
  const double speed = -glm::dot(normal, away);
  const double height = glm::dot(normal, this->Anchor + point) + truncation.w;
  return speed > 0.0 ? glm::dvec4(point + std::max(height, 0.0) / speed * away, 1.0)
                     : glm::dvec4(away, 0.0);
}

//------------------------------------------------------------------------------
double BoundaryEstimate::Get(const ShadowEdge& edge, const glm::vec4& truncation) const
{
  const glm::dvec3 a(edge.A);
  const glm::dvec3 b(edge.B);
  Polygon polygon;
  polygon.Add(this->ToClip * glm::dvec4(a, 1.0));
  polygon.Add(this->ToClip * glm::dvec4(b, 1.0));
  polygon.Add(this->ToClip * this->GetFarCorner(b, truncation));
  polygon.Add(this->ToClip * this->GetFarCorner(a, truncation));
  return GetCoveredShare(polygon);
}

//------------------------------------------------------------------------------
double BoundaryEstimate::Get(const ShadowCap& cap) const
{
  Polygon polygon;
  for (const glm::vec4& corner : { cap.A, cap.B, cap.C })
  {
    polygon.Add(this->ToClip * glm::dvec4(glm::dvec3(corner), 1.0));
  }
  return GetCoveredShare(polygon);
}

//------------------------------------------------------------------------------
std::vector<bool> FindCostlyCasters(
  const std::vector<Caster>& casters, const std::vector<double>& boundaries, double most)
{
  // In the order of the casters, so that of equal ones the first counts.
  std::vector<PropBoundaries> props;
  double sum = 0.0;
  for (size_t i = 0; i < casters.size(); ++i)
  {
    auto place = std::find_if(props.begin(), props.end(),
      [&](const PropBoundaries& prop) { return prop.Prop == casters[i].Owner; });
    if (place == props.end())
    {
      place = props.insert(props.end(), { casters[i].Owner });
    }
    place->Boundaries += boundaries[i];
    place->Stays = place->Stays || casters[i].OpticalThickness.Blocks != glm::ivec3(1);
    sum += boundaries[i];
  }
  props.erase(std::remove_if(
                props.begin(), props.end(), [](const PropBoundaries& prop) { return prop.Stays; }),
    props.end());
  std::set<const vtkProp*> costly;
  while (sum > most && !props.empty())
  {
    const auto worst = std::max_element(props.begin(), props.end(),
      [](const auto& a, const auto& b) { return a.Boundaries < b.Boundaries; });
    sum -= worst->Boundaries;
    costly.insert(worst->Prop);
    props.erase(worst);
  }
  std::vector<bool> left(costly.empty() ? 0 : casters.size());
  std::transform(casters.begin(), casters.begin() + left.size(), left.begin(),
    [&costly](const Caster& caster) { return costly.count(caster.Owner) > 0; });
  return left;
}
}
