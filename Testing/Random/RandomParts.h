// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the surfaces of a random scene are made of: tidy bodies and untidy soups.
 */

#ifndef RandomParts_h
#define RandomParts_h

#include "AirlightTestSoup.h"
#include "AirlightTestTools.h"

namespace airlight_test
{
enum PartKind
{
  PART_SPHERE,
  PART_BOX,
  PART_SHEET,         // open, of many quads, bent
  PART_OPEN_CYLINDER, // a body with two holes
  PART_SLIVERS,       // triangles up to a million times as long as wide
  PART_COPLANAR,      // overlapping triangles in one plane
  PART_COINCIDENT,    // the same triangles several times, wound in both ways
  PART_DEGENERATE,    // points and lines given as triangles, among proper ones
  PART_FAN,           // more than two triangles on each edge
  PART_LATTICE,       // triangles between the points of a coarse lattice
  PART_SOUP,          // triangles of all sizes
  PART_STACK,         // sheets that touch one behind the other
  PART_FLOOR,         // two large triangles
  PART_KINDS
};

const char* GetPartName(int kind);

// In [-1, 1]^3 or about there.
TriangleList MakePart(int kind, Random& random);

// With a normal for each triangle, to its front (1) or its back (-1). `shared`: points at one place
// are one point. `single`: coordinates in single precision.
vtkSmartPointer<vtkPolyData> MakeMesh(
  const TriangleList& triangles, double normals, bool shared, bool single);
}

#endif
