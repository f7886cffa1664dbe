// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestBruteForce.h"

namespace airlight_test
{
//------------------------------------------------------------------------------
std::vector<Interval> Complement(std::vector<Interval> parts, double end)
{
  std::sort(parts.begin(), parts.end(),
    [](const Interval& a, const Interval& b) { return a.From < b.From; });
  std::vector<Interval> result;
  double from = 0.0;
  for (const Interval& part : parts)
  {
    if (part.From > from && from < end)
    {
      result.push_back({ from, std::min(part.From, end) });
    }
    from = std::max(from, part.To);
  }
  if (from < end)
  {
    result.push_back({ from, end });
  }
  return result;
}

//------------------------------------------------------------------------------
// Lit intervals, cut where the shadows of translucent triangles begin and end.
static std::vector<LitPart> Dim(
  const std::vector<Interval>& lit, const std::vector<LitPart>& shadows)
{
  std::vector<LitPart> result;
  for (const Interval& whole : lit)
  {
    std::vector<double> ends = { whole.From, whole.To };
    for (const LitPart& shadow : shadows)
    {
      ends.push_back(std::clamp(shadow.Where.From, whole.From, whole.To));
      ends.push_back(std::clamp(shadow.Where.To, whole.From, whole.To));
    }
    std::sort(ends.begin(), ends.end());
    for (size_t i = 1; i < ends.size(); ++i)
    {
      LitPart part = { { ends[i - 1], ends[i] }, glm::dvec3(1.0) };
      for (const LitPart& shadow : shadows)
      {
        const bool inside =
          shadow.Where.From <= part.Where.From && shadow.Where.To >= part.Where.To;
        part.Passes *= inside ? shadow.Passes : glm::dvec3(1.0);
      }
      if (part.Where.From < part.Where.To)
      {
        result.push_back(part);
      }
    }
  }
  return result;
}

//------------------------------------------------------------------------------
void Clip(Interval& part, const Ray& ray, const glm::dvec3& normal, const glm::dvec3& point)
{
  const double slope = glm::dot(normal, ray.Direction);
  const double offset = glm::dot(normal, ray.Origin - point);
  if (slope == 0.0)
  {
    part.To = offset >= 0.0 ? part.To : part.From;
    return;
  }
  double& end = slope > 0.0 ? part.From : part.To;
  const double t = -offset / slope;
  end = slope > 0.0 ? std::max(end, t) : std::min(end, t);
}

//------------------------------------------------------------------------------
Interval ClipToBox(Interval part, const Ray& ray, const glm::dvec3& low, const glm::dvec3& high)
{
  for (int i = 0; i < 3; ++i)
  {
    glm::dvec3 normal(0.0);
    normal[i] = 1.0;
    Clip(part, ray, normal, low);
    Clip(part, ray, -normal, high);
  }
  return part;
}

//------------------------------------------------------------------------------
bool FindShadow(const Triangle& t, const glm::dvec4& light, const Ray& ray, Interval& shadow)
{
  const glm::dvec3 corners[3] = { t.A, t.B, t.C };
  const glm::dvec3 normal = glm::cross(t.B - t.A, t.C - t.A);
  const glm::dvec3 toLight = glm::dvec3(light) - light.w * t.A;
  const double facing = glm::dot(normal, toLight);
  // Seen edge-on, or not a triangle at all (also where something is not a number): no shadow.
  if (!(std::abs(facing) > 1e-12 * glm::length(normal) * glm::length(toLight)))
  {
    return false;
  }
  shadow = { 0.0, Infinity };
  Clip(shadow, ray, facing > 0.0 ? -normal : normal, t.A);
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3& p = corners[i];
    glm::dvec3 inward = glm::cross(corners[(i + 1) % 3] - p, glm::dvec3(light) - light.w * p);
    inward *= glm::dot(inward, corners[(i + 2) % 3] - p) < 0.0 ? -1.0 : 1.0;
    Clip(shadow, ray, inward, p);
  }
  return shadow.From < shadow.To;
}

//------------------------------------------------------------------------------
double Hit(const Triangle& t, const Ray& ray)
{
  const glm::dvec3 e1 = t.B - t.A;
  const glm::dvec3 e2 = t.C - t.A;
  const glm::dvec3 p = glm::cross(ray.Direction, e2);
  const double determinant = glm::dot(e1, p);
  const glm::dvec3 s = ray.Origin - t.A;
  const glm::dvec3 q = glm::cross(s, e1);
  const double u = glm::dot(s, p) / determinant;
  const double v = glm::dot(ray.Direction, q) / determinant;
  const double distance = glm::dot(e2, q) / determinant;
  const bool culled =
    !t.Stops || (t.FrontCulled && glm::dot(glm::cross(e1, e2), ray.Direction) < 0.0);
  return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance > ray.Nearest && !culled ? distance
                                                                                   : Infinity;
}

//------------------------------------------------------------------------------
std::vector<LitPart> FindLitParts(
  const std::vector<Triangle>& triangles, const glm::dvec4& light, const Ray& ray, double end)
{
  std::vector<Interval> dark;
  std::vector<LitPart> dimmed;
  for (const Triangle& t : triangles)
  {
    Interval shadow;
    if (!t.Casts || !FindShadow(t, light, ray, shadow))
    {
      continue;
    }
    if (t.Opacity == glm::dvec3(1.0))
    {
      dark.push_back(shadow);
    }
    else
    {
      dimmed.push_back({ shadow, 1.0 - t.Opacity });
    }
  }
  return Dim(Complement(dark, end), dimmed);
}

//------------------------------------------------------------------------------
double LengthInside(vtkParticipatingMedium* medium, const Ray& ray, Interval part)
{
  if (medium->GetRegion() == vtkParticipatingMedium::BOX)
  {
    const double* b = medium->GetBounds();
    part = ClipToBox(part, ray, { b[0], b[2], b[4] }, { b[1], b[3], b[5] });
  }
  return std::max(part.To - part.From, 0.0);
}

//------------------------------------------------------------------------------
glm::dvec4 GetPosition(vtkLight* light)
{
  glm::dvec3 position;
  glm::dvec3 focus;
  light->GetPosition(&position.x);
  light->GetFocalPoint(&focus.x);
  return light->GetPositional() ? glm::dvec4(position, 1.0)
                                : glm::dvec4(glm::normalize(position - focus), 0.0);
}

//------------------------------------------------------------------------------
glm::dvec3 Shade(vtkParticipatingMedium* medium, vtkLight* light, const glm::dvec3& x,
  const glm::dvec3& normalToEye)
{
  const glm::dvec4 position = GetPosition(light);
  const glm::dvec3 toLight = glm::dvec3(position) - position.w * x;
  const double r = glm::length(toLight);
  glm::dvec3 colour;
  light->GetDiffuseColor(&colour.x);
  colour *= light->GetIntensity() * std::max(0.0, glm::dot(normalToEye, toLight) / r);
  glm::dvec3 passes(1.0);
  if (position.w != 0.0)
  {
    const double r2 = r * r;
    vtkAirlight::Transmittance(medium, &x.x, &position.x, &passes.x);
    passes /= r2;
  }
  else if (medium->GetRegion() != vtkParticipatingMedium::UNBOUNDED)
  {
    const glm::dvec3 outside = x + 1e6 * toLight;
    vtkAirlight::Transmittance(medium, &x.x, &outside.x, &passes.x);
  }
  return colour * passes;
}

//------------------------------------------------------------------------------
Answer Trace(const std::vector<Triangle>& triangles, const std::vector<vtkLight*>& lights,
  vtkParticipatingMedium* medium, const Ray& ray)
{
  Answer answer;
  double end = Infinity;
  glm::dvec3 normal(0.0);
  for (const Triangle& t : triangles)
  {
    const double distance = Hit(t, ray);
    if (distance < end)
    {
      end = distance;
      normal = glm::normalize(glm::cross(t.B - t.A, t.C - t.A));
    }
  }
  const glm::dvec3 x = ray.Origin + std::min(end, 1e9) * ray.Direction;
  normal *= glm::dot(normal, ray.Direction) > 0.0 ? -1.0 : 1.0;
  for (vtkLight* light : lights)
  {
    const auto add = [&](const Interval& part, const glm::dvec3& passes, glm::dvec3& sum) {
      glm::dvec3 rgb;
      vtkAirlight::Inscatter(
        medium, light, &ray.Origin.x, &ray.Direction.x, part.From, part.To, &rgb.x);
      sum += passes * rgb;
    };
    LitPart last = { { 0.0, 0.0 }, glm::dvec3(0.0) };
    for (const LitPart& part : FindLitParts(triangles, GetPosition(light), ray, end))
    {
      add(part.Where, part.Passes, answer.Airlight);
      const bool reached = part.Passes != glm::dvec3(0.0);
      answer.LitLength += reached ? LengthInside(medium, ray, part.Where) : 0.0;
      // The surface's own shadow may begin within rounding before it.
      last = part.Where.From < part.Where.To * (1.0 - 1e-9) ? part : last;
    }
    add({ 0.0, end }, glm::dvec3(1.0), answer.Unshadowed);
    // The surface is lit as the air just before it: its own shadow begins or ends at it.
    if (end < Infinity && last.Where.To > end * (1.0 - 1e-9))
    {
      answer.Surface += last.Passes * Shade(medium, light, x, normal);
    }
  }
  if (end < Infinity)
  {
    glm::dvec3 passes;
    vtkAirlight::Transmittance(medium, &ray.Origin.x, &x.x, &passes.x);
    answer.Surface *= passes;
    answer.Depth = end;
  }
  return answer;
}
}
