// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The lit parts of straight segments: where a light reaches them, through a medium and past
 * occluders, and what the medium scatters there. Behind vtkLitIntervalsFilter.
 */

#ifndef AirlightLitLines_h
#define AirlightLitLines_h

#include "Occlusion/AirlightOccluders.h"

#include "vtkType.h"

#include <glm/glm.hpp>

#include <vector>

class vtkLight;
class vtkParticipatingMedium;
class vtkPolyData;

namespace airlight
{
struct LineSegment
{
  glm::dvec3 Start;
  glm::dvec3 Direction; // of unit length
  double Length;
  double Before;          // length of the line before it
  glm::dvec3 DepthBefore; // optical depth of the line before it
  vtkIdType Cell;
};

// Why a lit part begins or ends: vtkLitIntervalsFilter::CauseType.
struct LitEnd
{
  double T; // along the segment
  int Cause;
  int Triangle; // of the occluders, where the cause is a shadow; else -1
};

struct LitPart
{
  LitEnd Start;
  LitEnd End;
  glm::dvec3 Airlight;   // towards the segment's start, from there
  glm::dvec3 Depth;      // of the part
  glm::dvec3 DepthToEnd; // from the segment's start to the part's end
};

// The segments of all lines, without those of length 0; their depths are for the caller to fill in.
// Lines with points that are not usable (see IsUsable()) are left out: the first such point and
// the number of lines are returned in `badPoint` and `badLines`.
std::vector<LineSegment> CollectSegments(
  vtkPolyData* lines, vtkIdType& badPoint, vtkIdType& badLines);

// Optical depth of the whole segment.
glm::dvec3 FindDepth(vtkParticipatingMedium* medium, const LineSegment& segment);

// In order along the segment. Thread safe after CheckSceneLight().
std::vector<LitPart> FindLitParts(vtkParticipatingMedium* medium, vtkLight* light,
  const Occluders& occluders, const LineSegment& segment);
}

#endif
