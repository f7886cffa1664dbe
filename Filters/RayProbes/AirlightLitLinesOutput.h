// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The output of vtkLitIntervalsFilter, part by part.
 */

#ifndef AirlightLitLinesOutput_h
#define AirlightLitLinesOutput_h

#include "RayProbes/AirlightLitLines.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

namespace airlight
{
class LitLinesOutput
{
public:
  explicit LitLinesOutput(const Occluders& occluders);

  // Segments in order, also those without parts. Joins parts that meet at a bend.
  void Add(const LineSegment& segment, const std::vector<LitPart>& parts);

  // After the last segment.
  void Finish(vtkPolyData* output);

private:
  struct EndArrays
  {
    vtkNew<vtkDoubleArray> Where;
    vtkNew<vtkUnsignedCharArray> Cause;
    vtkNew<vtkIntArray> Occluder;
    vtkNew<vtkIdTypeArray> OccluderCell;
  };

  void Begin(const LineSegment& segment, const LitPart& part);
  void Extend(const LineSegment& segment, const LitPart& part);
  void Close(bool lineEnds);
  void AddEnd(EndArrays& arrays, const LitEnd& end, double where);

  const std::vector<OccluderTriangle>& Triangles;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkDoubleArray> Length;
  vtkNew<vtkDoubleArray> Airlight;
  vtkNew<vtkDoubleArray> OpticalDepth;
  vtkNew<vtkDoubleArray> Transmittance;
  vtkNew<vtkIdTypeArray> SourceCell;
  EndArrays Starts;
  EndArrays Ends;

  vtkIdType LastCell = -1; // of the last segment
  bool Open = false;       // the current part ends with the segment: the next one may go on
  vtkIdType CurrentCell = -1;
  std::vector<vtkIdType> Ids;
  LitPart Current{};
  double CurrentStart = 0.0; // from the line's first point
  double CurrentEnd = 0.0;
  glm::dvec3 CurrentTransmittance{ 1.0 };
};
}

#endif
