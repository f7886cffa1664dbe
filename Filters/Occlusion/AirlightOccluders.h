// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What stands in the way of light: triangles in world coordinates in a hierarchy of boxes, in
 * double precision. Tells what a ray hits, whether a light is seen, and which parts of a ray are
 * lit.
 *
 * Nothing is assumed of the triangles, as in AirlightCasterMesh.h, and each has two sides. What
 * neighbours share is computed alike for both, so that no light leaks between them.
 */

#ifndef AirlightOccluders_h
#define AirlightOccluders_h

#include "Silhouette/AirlightSilhouette.h" // for HomogeneousPoint
#include "vtkAirlightModule.h"             // for export macro

#include <glm/glm.hpp>

#include <functional>
#include <memory>
#include <vector>

class vtkMatrix4x4;
class vtkPolyData;

namespace airlight
{
struct OccluderTriangle
{
  glm::dvec3 A, B, C;
  int Caster;     // the number that its caller gave to Add()
  long long Cell; // of that caster's data
};

// Immutable once built; the queries may then run in many threads.
class VTKAIRLIGHT_EXPORT Occluders
{
public:
  Occluders();
  ~Occluders();
  Occluders(Occluders&&) noexcept;

  // Polygons and strips as triangles; a null matrix leaves them where they are. Triangles without
  // area, with points that are not finite or with coordinates above 1e50 are left out.
  void Add(vtkPolyData* data, vtkMatrix4x4* toWorld, int caster);

  // To be called once, after the last Add() and before the first query, also of an empty set.
  void Build();

  const std::vector<OccluderTriangle>& GetTriangles() const { return this->Triangles; }

  // Largest absolute coordinate of the triangles: what rounding errors are relative to.
  double GetScale() const { return this->Scale; }

  // Says which triangles are as if they were not there.
  using Predicate = std::function<bool(int triangle)>;

  struct Hit
  {
    double T; // along the ray
    int Triangle;
  };

  // The first triangle with t0 < T < t1, the lowest number among equals. t1 may be infinite.
  bool FirstHit(const glm::dvec3& origin, const glm::dvec3& unitDirection, double t0, double t1,
    Hit& hit, const Predicate& skip = {}) const;

  // Whether a triangle lies between the point and the light, further than `margin` from either.
  bool Blocked(const glm::dvec3& point, const HomogeneousPoint& light, double margin = 0.0,
    const Predicate& skip = {}) const;

  // Part of a ray from which a triangle hides the light.
  struct Shadow
  {
    double From, To;
    int Triangle;
  };

  // Every triangle's shadow on the ray between t0 and t1, cut to them, in no order that means
  // anything, but always the same one. t1 may be infinite.
  void FindShadows(const HomogeneousPoint& light, const glm::dvec3& origin,
    const glm::dvec3& unitDirection, double t0, double t1, std::vector<Shadow>& shadows) const;

  // Part of a ray that is lit, with the triangles whose shadows end and begin there; -1 where
  // nothing but the ray begins or ends.
  struct Interval
  {
    double From, To;
    int StartTriangle, EndTriangle;
  };

  // What the shadows leave of [t0, t1]; sorts them. Lit parts not longer than `gap` are dark, as
  // there the shadows of neighbours touch but for rounding; shadows not longer than it are none.
  static void LitIntervals(std::vector<Shadow>& shadows, double t0, double t1,
    std::vector<Interval>& lit, double gap = 0.0);

  // The gap of rounding for a ray of this set: 1e-12 of the largest coordinates involved.
  double GetGap(const HomogeneousPoint& light, const glm::dvec3& origin) const;

private:
  struct Tree;
  std::vector<OccluderTriangle> Triangles;
  std::unique_ptr<Tree> Boxes;
  double Scale = 0.0;
};

// The shadow of one triangle on a ray, cut to [t0, t1]: behind the triangle's plane and inside the
// cone of the planes through the light and an edge. False where there is none; a triangle seen
// edge-on from the light has none.
VTKAIRLIGHT_EXPORT bool FindShadow(const OccluderTriangle& triangle, const HomogeneousPoint& light,
  const glm::dvec3& origin, const glm::dvec3& unitDirection, double t0, double t1, double& from,
  double& to);
}

#endif
