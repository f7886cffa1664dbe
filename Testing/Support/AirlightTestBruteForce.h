// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a ray ought to see, by brute force and in double precision: each triangle's shadow is cut
 * out of the ray by four planes, the lit intervals are the complement of the union, and each lit
 * interval's airlight comes from vtkAirlight::Inscatter(), which its own tests verify. Triangles
 * that let light through cut lit intervals in parts, and dim each part that lies in their shadow.
 * Nothing here knows of silhouettes, edges or lists.
 */

#ifndef AirlightTestBruteForce_h
#define AirlightTestBruteForce_h

#include "vtkAirlight.h"
#include "vtkLight.h"
#include "vtkParticipatingMedium.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace airlight_test
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

struct Interval
{
  double From, To;
};

// A part of the ray, and the share of the light that reaches it.
struct LitPart
{
  Interval Where;
  glm::dvec3 Passes;
};

// The complement of the union of intervals on [0, end].
std::vector<Interval> Complement(std::vector<Interval> parts, double end);

//------------------------------------------------------------------------------
struct Triangle
{
  glm::dvec3 A, B, C;
  bool FrontCulled = false; // drawn only where seen from behind
  bool Casts = true;
  glm::dvec3 Opacity{ 1.0 }; // of its shadow
  bool Stops = true;         // rays end at it
};

struct Ray
{
  glm::dvec3 Origin;
  glm::dvec3 Direction; // of unit length
  double Nearest = 0.0; // where the camera's near plane lets surfaces be seen
};

struct Answer
{
  glm::dvec3 Airlight{ 0.0 };
  glm::dvec3 Unshadowed{ 0.0 };
  glm::dvec3 Surface{ 0.0 };
  double LitLength = 0.0;
  double Depth = -1.0; // without surface
};

// Keeps the part of the ray where dot(normal, x - point) >= 0.
void Clip(Interval& part, const Ray& ray, const glm::dvec3& normal, const glm::dvec3& point);

// Keeps the part of the ray in a box; From >= To where there is none.
Interval ClipToBox(Interval part, const Ray& ray, const glm::dvec3& low, const glm::dvec3& high);

// The part of the ray from which the triangle hides the light (w = 0: at infinity): behind the
// triangle's plane and inside the cone of the three planes through the light and an edge.
bool FindShadow(const Triangle& t, const glm::dvec4& light, const Ray& ray, Interval& shadow);

// Distance to the triangle; infinite where the ray does not see it.
double Hit(const Triangle& t, const Ray& ray);

// The parts of [0, end] that light reaches.
std::vector<LitPart> FindLitParts(
  const std::vector<Triangle>& triangles, const glm::dvec4& light, const Ray& ray, double end);

// Length of a part of the ray inside the medium.
double LengthInside(vtkParticipatingMedium* medium, const Ray& ray, Interval part);

// Homogeneous position; w = 0 where the light is directional.
glm::dvec4 GetPosition(vtkLight* light);

// What a white diffuse surface at x sends, before it is attenuated: c cos(theta)/r^2 with VTK's
// c = I/pi, times the transmittance from the light; a light at infinity comes through an unbounded
// medium as if it were not there.
glm::dvec3 Shade(vtkParticipatingMedium* medium, vtkLight* light, const glm::dvec3& x,
  const glm::dvec3& normalToEye);

Answer Trace(const std::vector<Triangle>& triangles, const std::vector<vtkLight*>& lights,
  vtkParticipatingMedium* medium, const Ray& ray);
}

#endif
