// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RayProbes/AirlightLitLines.h"

#include "RayProbes/AirlightFilterInput.h"
#include "vtkAirlight.h"
#include "vtkLitIntervalsFilter.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPolyData.h"

namespace airlight
{
namespace
{
// A part of a segment, before anything is known of its light.
struct Part
{
  LitEnd Start;
  LitEnd End;
};

// What the two have in common, with the cause of whichever begins last and ends first.
Part Intersect(const Part& a, const Part& b)
{
  return { b.Start.T > a.Start.T ? b.Start : a.Start, b.End.T < a.End.T ? b.End : a.End };
}

Part MakePart(double from, double to, int cause)
{
  return { { from, cause, -1 }, { to, cause, -1 } };
}

// The parts of the segment inside the medium, of a spot in its cone, too.
std::vector<Part> FindReach(
  vtkParticipatingMedium* medium, vtkLight* light, const LineSegment& segment)
{
  std::vector<Part> parts;
  const f64::AirlightMedia media = ConvertMedia({ medium }, segment.Start);
  f64::AirlightLight sceneLight;
  if (ConvertSceneLight(media, light, segment.Start, sceneLight) != LightSupport::Scatters)
  {
    return parts;
  }
  const glm::dvec3 origin(0.0);
  const double length = segment.Length;
  const f64::AirlightRay ray =
    f64::airlightRay(media, sceneLight, origin, segment.Direction, length);
  const Part cone = MakePart(ray.lit.x > ray.range.x ? ray.lit.x : -1.0,
    ray.lit.y < ray.range.y ? ray.lit.y : 2.0 * length, vtkLitIntervalsFilter::CONE);
  const Part whole = MakePart(0.0, length, vtkLitIntervalsFilter::LINE_END);
  for (double t = 0.0; t < length;)
  {
    const f64::AirlightPiece piece =
      f64::airlightPieceAt(media, origin, segment.Direction, t, length);
    if (piece.inside != 0)
    {
      const Part inside = MakePart(piece.from, piece.to, vtkLitIntervalsFilter::MEDIUM);
      const Part part = Intersect(Intersect(whole, inside), cone);
      if (part.Start.T < part.End.T)
      {
        parts.push_back(part);
      }
    }
    t = piece.to;
  }
  return parts;
}

// The parts that no triangle shades.
std::vector<Part> FindUnshaded(
  const Occluders& occluders, const HomogeneousPoint& light, const LineSegment& segment)
{
  std::vector<Occluders::Shadow> shadows;
  std::vector<Occluders::Interval> lit;
  occluders.FindShadows(light, segment.Start, segment.Direction, 0.0, segment.Length, shadows);
  Occluders::LitIntervals(
    shadows, 0.0, segment.Length, lit, occluders.GetGap(light, segment.Start));
  std::vector<Part> parts;
  parts.reserve(lit.size());
  for (const Occluders::Interval& i : lit)
  {
    parts.push_back({ { i.From, vtkLitIntervalsFilter::SHADOW, i.StartTriangle },
      { i.To, vtkLitIntervalsFilter::SHADOW, i.EndTriangle } });
  }
  return parts;
}

glm::dvec3 FindDepthTo(vtkParticipatingMedium* medium, const LineSegment& segment, double t)
{
  return f64::airlightDepth(
    ConvertMedia({ medium }, segment.Start), glm::dvec3(0.0), segment.Direction, t);
}

// What the medium scatters in the part, and how much of it there is.
LitPart Measure(
  vtkParticipatingMedium* medium, vtkLight* light, const LineSegment& segment, const Part& part)
{
  LitPart result{ part.Start, part.End, glm::dvec3(0.0), glm::dvec3(0.0), glm::dvec3(0.0) };
  vtkAirlight::Inscatter(medium, light, &segment.Start.x, &segment.Direction.x, part.Start.T,
    part.End.T, &result.Airlight.x);
  result.DepthToEnd = FindDepthTo(medium, segment, part.End.T);
  LineSegment rest = segment; // not a difference of depths, which would cancel
  rest.Start += part.Start.T * segment.Direction;
  result.Depth = FindDepthTo(medium, rest, part.End.T - part.Start.T);
  return result;
}
}

//------------------------------------------------------------------------------
std::vector<LineSegment> CollectSegments(
  vtkPolyData* lines, vtkIdType& badPoint, vtkIdType& badLines)
{
  std::vector<LineSegment> segments;
  badPoint = -1;
  badLines = 0;
  vtkIdType cell = lines->GetNumberOfVerts(); // cells are counted from these
  auto line = vtk::TakeSmartPointer(lines->GetLines()->NewIterator());
  for (line->GoToFirstCell(); !line->IsDoneWithTraversal(); line->GoToNextCell(), ++cell)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    line->GetCurrentCell(size, ids);
    const size_t first = segments.size();
    double length = 0.0;
    glm::dvec3 last(0.0);
    for (vtkIdType i = 0; i < size; ++i)
    {
      glm::dvec3 p;
      lines->GetPoint(ids[i], &p.x);
      if (!IsUsable(p))
      {
        badPoint = badLines++ == 0 ? ids[i] : badPoint;
        segments.resize(first);
        break;
      }
      const double step = i > 0 ? glm::distance(last, p) : 0.0;
      if (step > 0.0)
      {
        segments.push_back({ last, (p - last) / step, step, length, glm::dvec3(0.0), cell });
        length += step;
      }
      last = p;
    }
  }
  return segments;
}

//------------------------------------------------------------------------------
glm::dvec3 FindDepth(vtkParticipatingMedium* medium, const LineSegment& segment)
{
  return FindDepthTo(medium, segment, segment.Length);
}

//------------------------------------------------------------------------------
std::vector<LitPart> FindLitParts(vtkParticipatingMedium* medium, vtkLight* light,
  const Occluders& occluders, const LineSegment& segment)
{
  std::vector<LitPart> result;
  const std::vector<Part> reach = FindReach(medium, light, segment);
  if (reach.empty())
  {
    return result;
  }
  for (const Part& lit : FindUnshaded(occluders, GetHomogeneousPosition(light), segment))
  {
    for (const Part& inside : reach)
    {
      const Part part = Intersect(inside, lit);
      if (part.Start.T < part.End.T)
      {
        result.push_back(Measure(medium, light, segment, part));
      }
    }
  }
  return result;
}
}
