// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RayProbes/AirlightLitLinesOutput.h"

#include "vtkLitIntervalsFilter.h"

#include "vtkCellData.h"
#include "vtkPolyData.h"

namespace airlight
{
//------------------------------------------------------------------------------
LitLinesOutput::LitLinesOutput(const Occluders& occluders)
  : Triangles(occluders.GetTriangles())
{
  this->Points->SetDataTypeToDouble();
  for (vtkDoubleArray* rgb :
    { this->Airlight.Get(), this->OpticalDepth.Get(), this->Transmittance.Get() })
  {
    rgb->SetNumberOfComponents(3);
  }
}

//------------------------------------------------------------------------------
void LitLinesOutput::Add(const LineSegment& segment, const std::vector<LitPart>& parts)
{
  const bool newLine = segment.Cell != this->LastCell;
  this->LastCell = segment.Cell;
  const bool goesOn =
    !newLine && !parts.empty() && parts.front().Start.Cause == vtkLitIntervalsFilter::LINE_END;
  if (this->Open && !goesOn)
  {
    this->Close(newLine);
  }
  for (const LitPart& part : parts)
  {
    if (this->Open)
    {
      this->Extend(segment, part);
    }
    else
    {
      this->Begin(segment, part);
      if (!newLine && part.Start.Cause == vtkLitIntervalsFilter::LINE_END)
      {
        this->Current.Start.Cause = vtkLitIntervalsFilter::BEND;
      }
    }
    this->Open = true;
    if (part.End.Cause != vtkLitIntervalsFilter::LINE_END)
    {
      this->Close(true);
    }
  }
}

//------------------------------------------------------------------------------
void LitLinesOutput::Begin(const LineSegment& segment, const LitPart& part)
{
  const glm::dvec3 start = segment.Start + part.Start.T * segment.Direction;
  this->Ids.assign(1, this->Points->InsertNextPoint(&start.x));
  this->CurrentCell = segment.Cell;
  this->CurrentStart = segment.Before + part.Start.T;
  this->Current = { part.Start, part.End, glm::dvec3(0.0), glm::dvec3(0.0), glm::dvec3(0.0) };
  this->Extend(segment, part);
}

//------------------------------------------------------------------------------
void LitLinesOutput::Extend(const LineSegment& segment, const LitPart& part)
{
  const glm::dvec3 end = segment.Start + part.End.T * segment.Direction;
  this->Ids.push_back(this->Points->InsertNextPoint(&end.x));
  this->Current.End = part.End;
  this->Current.Airlight += glm::exp(-segment.DepthBefore) * part.Airlight;
  this->Current.Depth += part.Depth;
  this->CurrentEnd = segment.Before + part.End.T;
  this->CurrentTransmittance = glm::exp(-(segment.DepthBefore + part.DepthToEnd));
}

//------------------------------------------------------------------------------
void LitLinesOutput::Close(bool lineEnds)
{
  if (!lineEnds)
  {
    this->Current.End.Cause = vtkLitIntervalsFilter::BEND;
  }
  this->Lines->InsertNextCell(static_cast<vtkIdType>(this->Ids.size()), this->Ids.data());
  this->Length->InsertNextValue(this->CurrentEnd - this->CurrentStart);
  this->Airlight->InsertNextTuple(&this->Current.Airlight.x);
  this->OpticalDepth->InsertNextTuple(&this->Current.Depth.x);
  this->Transmittance->InsertNextTuple(&this->CurrentTransmittance.x);
  this->SourceCell->InsertNextValue(this->CurrentCell);
  this->AddEnd(this->Starts, this->Current.Start, this->CurrentStart);
  this->AddEnd(this->Ends, this->Current.End, this->CurrentEnd);
  this->Open = false;
}

//------------------------------------------------------------------------------
void LitLinesOutput::AddEnd(EndArrays& arrays, const LitEnd& end, double where)
{
  arrays.Where->InsertNextValue(where);
  arrays.Cause->InsertNextValue(static_cast<unsigned char>(end.Cause));
  const bool known = end.Cause == vtkLitIntervalsFilter::SHADOW && end.Triangle >= 0;
  arrays.Occluder->InsertNextValue(known ? this->Triangles[end.Triangle].Caster : -1);
  arrays.OccluderCell->InsertNextValue(known ? this->Triangles[end.Triangle].Cell : -1);
}

//------------------------------------------------------------------------------
void LitLinesOutput::Finish(vtkPolyData* output)
{
  if (this->Open)
  {
    this->Close(true);
  }
  output->SetPoints(this->Points);
  output->SetLines(this->Lines);
  const auto add = [&](vtkDataArray* array, const char* name) {
    array->SetName(name);
    output->GetCellData()->AddArray(array);
  };
  add(this->Length, "Length");
  add(this->Starts.Where, "Start");
  add(this->Ends.Where, "End");
  add(this->Airlight, "Airlight");
  add(this->OpticalDepth, "OpticalDepth");
  add(this->Transmittance, "Transmittance");
  add(this->Starts.Cause, "StartCause");
  add(this->Ends.Cause, "EndCause");
  add(this->Starts.Occluder, "StartOccluder");
  add(this->Ends.Occluder, "EndOccluder");
  add(this->Starts.OccluderCell, "StartOccluderCell");
  add(this->Ends.OccluderCell, "EndOccluderCell");
  add(this->SourceCell, "SourceCell");
}
}
