// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Triangle soups and what follows for their shadows straight from the definitions, triangle by
 * triangle and point by point; random triangles for AirlightTestBruteForce.h, and lights among
 * them.
 */

#ifndef AirlightTestSoup_h
#define AirlightTestSoup_h

#include "AirlightTestBruteForce.h"
#include "AirlightTestTools.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <glm/glm.hpp>

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace airlight_test
{
using Position = std::array<double, 3>;
using TriangleList = std::vector<std::array<glm::dvec3, 3>>;
// Ends and weight: the shadow is to the left, seen from the light.
using EdgeWeights = std::map<std::pair<Position, Position>, int>;

Position ToPosition(const glm::dvec3& p);

// Each triangle with points of its own.
vtkSmartPointer<vtkPolyData> MakeSoup(const TriangleList& triangles);

// The polygons fanned out; fine for convex ones.
TriangleList GetFans(vtkPolyData* data, std::vector<vtkIdType>* cellsOf = nullptr);

// Triangles between points of a coarse lattice, so that many edges meet in all ways.
TriangleList MakeLatticeSoup(Random& random, int count);

// Above 0 where the light (w = 0: at infinity) sees the triangle's corners anticlockwise.
double Facing(const std::array<glm::dvec3, 3>& t, const glm::dvec4& light);

// The definition: the sum of the directions of all triangles, each turned to face the light.
EdgeWeights SumDirections(const TriangleList& triangles, const glm::dvec4& light);

// 1 where the way from p to q goes through the triangle from its front to its back, -1 the other
// way round, 0 where it does not. After T. Moeller and B. Trumbore.
int Crosses(const std::array<glm::dvec3, 3>& t, const glm::dvec3& p, const glm::dvec3& way);

// How many triangles are between the point and the light, which is `far` away if at infinity.
int CountShadows(
  const TriangleList& triangles, const glm::dvec4& light, const glm::dvec3& point, double far);

// Triangles of all sizes in [-1, 1]^3, each with its own points.
vtkSmartPointer<vtkPolyData> MakeRandomSoup(
  Random& random, int count, std::vector<Triangle>& triangles);

// A light of each kind, with its name.
std::vector<std::pair<std::string, vtkSmartPointer<vtkLight>>> MakeLights();
}

#endif
