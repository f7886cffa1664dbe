// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/AirlightReferenceLitParts.h"

#include "Reference/AirlightReferenceScene.h"

#include <algorithm>
#include <cmath>

namespace airlight
{
namespace
{
// Of a shadow in which the opacity varies.
constexpr int Parts = 256;

// Where the way from a light to a point goes through a triangle's plane.
glm::dvec3 Project(
  const OccluderTriangle& triangle, const HomogeneousPoint& light, const glm::dvec3& point)
{
  const glm::dvec3 normal = glm::cross(triangle.B - triangle.A, triangle.C - triangle.A);
  const glm::dvec3 way = glm::dvec3(light) - light.w * point;
  const double t = glm::dot(normal, triangle.A - point) / glm::dot(normal, way);
  return point + t * way;
}

// Cuts lit parts where translucent casters' shadows begin and end, and between if their opacity
// varies.
class Dimmer
{
public:
  Dimmer(const ReferenceScene& scene, const HomogeneousPoint& light, const glm::dvec3& origin,
    const glm::dvec3& direction, double end)
    : Scene(scene)
    , Light(light)
    , Origin(origin)
    , Direction(direction)
  {
    scene.GetTranslucentCasters().FindShadows(light, origin, direction, 0.0, end, this->Shadows);
    std::sort(this->Shadows.begin(), this->Shadows.end(),
      [](const auto& a, const auto& b) { return a.From < b.From; });
    for (const Occluders::Shadow& shadow : this->Shadows)
    {
      this->AddCuts(shadow);
    }
    std::sort(this->Cuts.begin(), this->Cuts.end());
  }

  // Appends what reaches the ray between two places.
  void Dim(double from, double to, std::vector<ReferenceLitPart>& parts) const
  {
    auto cut = std::upper_bound(this->Cuts.begin(), this->Cuts.end(), from);
    while (from < to)
    {
      const double next = cut == this->Cuts.end() ? to : std::min(*cut++, to);
      if (next > from)
      {
        Append({ from, next, this->GetTransmittance(0.5 * (from + next)) }, parts);
        from = next;
      }
    }
  }

private:
  const OccluderTriangle& GetTriangle(const Occluders::Shadow& shadow) const
  {
    return this->Scene.GetTranslucentCasters().GetTriangles()[shadow.Triangle];
  }

  // Of a shadow without an end, in shares of the angle from its beginning.
  void AddCuts(const Occluders::Shadow& shadow)
  {
    const ReferencePart& part = this->Scene.GetPart(this->GetTriangle(shadow));
    const bool varies = !part.HasShadowOpacity && (part.Texture || !part.Colours.empty());
    const int count = varies ? Parts : 1;
    for (int i = 0; i <= count; ++i)
    {
      const double share = static_cast<double>(i) / count;
      this->Cuts.push_back(std::isinf(shadow.To)
          ? shadow.From + share / std::max(1.0 - share, 1e-12)
          : shadow.From + share * (shadow.To - shadow.From));
    }
  }

  glm::dvec3 GetTransmittance(double t) const
  {
    const glm::dvec3 point = this->Origin + t * this->Direction;
    glm::dvec3 passes(1.0);
    for (const Occluders::Shadow& shadow : this->Shadows)
    {
      if (shadow.From > t)
      {
        break;
      }
      if (t < shadow.To)
      {
        const OccluderTriangle& triangle = this->GetTriangle(shadow);
        passes *= this->Scene.GetTransmittance(triangle, Project(triangle, this->Light, point));
      }
    }
    return passes;
  }

  static void Append(const ReferenceLitPart& part, std::vector<ReferenceLitPart>& parts)
  {
    if (!parts.empty() && parts.back().To == part.From && parts.back().Passes == part.Passes)
    {
      parts.back().To = part.To;
    }
    else if (part.Passes != glm::dvec3(0.0))
    {
      parts.push_back(part);
    }
  }

  const ReferenceScene& Scene;
  HomogeneousPoint Light;
  glm::dvec3 Origin;
  glm::dvec3 Direction;
  std::vector<Occluders::Shadow> Shadows;
  std::vector<double> Cuts;
};
}

//------------------------------------------------------------------------------
std::vector<ReferenceLitPart> FindReferenceLitParts(const ReferenceScene& scene,
  const HomogeneousPoint& light, const glm::dvec3& origin, const glm::dvec3& unitDirection,
  double end)
{
  const Occluders& casters = scene.GetCasters();
  std::vector<Occluders::Shadow> shadows;
  casters.FindShadows(light, origin, unitDirection, 0.0, end, shadows);
  std::vector<Occluders::Interval> lit;
  Occluders::LitIntervals(shadows, 0.0, end, lit, casters.GetGap(light, origin));
  std::vector<ReferenceLitPart> parts;
  if (scene.GetTranslucentCasters().GetTriangles().empty())
  {
    for (const Occluders::Interval& interval : lit)
    {
      parts.push_back({ interval.From, interval.To });
    }
    return parts;
  }
  const Dimmer dimmer(scene, light, origin, unitDirection, end);
  for (const Occluders::Interval& interval : lit)
  {
    dimmer.Dim(interval.From, interval.To, parts);
  }
  return parts;
}
}
