// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RayProbes/AirlightProbeArrays.h"

#include "RayProbes/AirlightFilterInput.h"

#include "vtkDataSet.h"
#include "vtkPointData.h"

#include <cmath>

namespace airlight
{
namespace
{
// The unit normal of a point; 0 where that is none.
glm::dvec3 GetNormal(vtkDataArray* normals, vtkIdType i)
{
  glm::dvec3 n;
  normals->GetTuple(i, &n.x);
  const double length = glm::length(n);
  return std::isfinite(length) && length > 0.0 ? n / length : glm::dvec3(0.0);
}
}

//------------------------------------------------------------------------------
ProbeArrays::ProbeArrays(const Probe& probe, vtkDataSet* points)
  : Source(probe)
  , Points(points)
  , Normals(points->GetPointData()->GetNormals())
  , Radiance(this->Add("Radiance", 3))
  , Transmittance(this->Add("Transmittance", 3))
  , Direct(this->Add("DirectIrradiance", 3))
{
  if (points->GetNumberOfPoints() > 0)
  {
    double first[3]; // lets the data prepare what it prepares on first use
    points->GetPoint(0, first);
  }
}

//------------------------------------------------------------------------------
vtkDoubleArray* ProbeArrays::Add(const char* name, int components)
{
  this->All.emplace_back();
  vtkDoubleArray* array = this->All.back();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(this->Points->GetNumberOfPoints());
  array->Fill(0.0);
  return array;
}

//------------------------------------------------------------------------------
void ProbeArrays::AddScattered() { this->Scattered = this->Add("ScatteredIrradiance", 3); }

//------------------------------------------------------------------------------
void ProbeArrays::AddSightLines(const SightLineSettings& settings)
{
  this->Settings = settings;
  this->Extinction = this->Add("MeanExtinction", 1);
  this->Reflecting = this->Add("ReflectingSignVisibility", 1);
  this->Emitting = this->Add("EmittingSignVisibility", 1);
  this->Seen = this->Add("SignContrast", 1);
  this->WithoutAirlight = this->Add("SignContrastWithoutAirlight", 1);
}

//------------------------------------------------------------------------------
void ProbeArrays::Measure(vtkIdType i)
{
  glm::dvec3 p;
  this->Points->GetPoint(i, &p.x);
  if (!IsUsable(p))
  {
    ++this->Bad;
    return;
  }
  const glm::dvec3 radiance = this->Source.FindRadiance(this->Eye, p);
  const glm::dvec3 transmittance = this->Source.FindTransmittance(this->Eye, p);
  const glm::dvec3 normal = this->Normals ? GetNormal(this->Normals, i) : glm::dvec3(0.0);
  const glm::dvec3 direct =
    this->Source.FindDirect(p, this->Normals ? &normal : nullptr, this->Margin);
  this->Radiance->SetTypedTuple(i, &radiance.x);
  this->Transmittance->SetTypedTuple(i, &transmittance.x);
  this->Direct->SetTypedTuple(i, &direct.x);
  if (this->Scattered && normal != glm::dvec3(0.0))
  {
    const glm::dvec3 scattered = this->Source.FindScattered(p, normal);
    this->Scattered->SetTypedTuple(i, &scattered.x);
  }
  if (this->Extinction)
  {
    this->MeasureSightLine(i, p, direct, radiance, transmittance);
  }
}

//------------------------------------------------------------------------------
void ProbeArrays::MeasureSightLine(vtkIdType i, const glm::dvec3& point,
  const glm::dvec3& irradiance, const glm::dvec3& airlight, const glm::dvec3& transmittance)
{
  const SightLineSettings& s = this->Settings;
  const double extinction = FindMeanExtinction(this->Source, this->Eye, point);
  const SignContrast contrast = FindContrast(s.Sign, irradiance, airlight, transmittance);
  this->Extinction->SetValue(i, extinction);
  this->Reflecting->SetValue(
    i, GetVisibility(s.ReflectingConstant, extinction, s.MaximumVisibility));
  this->Emitting->SetValue(i, GetVisibility(s.EmittingConstant, extinction, s.MaximumVisibility));
  this->Seen->SetValue(i, contrast.Seen);
  this->WithoutAirlight->SetValue(i, contrast.WithoutAirlight);
}

//------------------------------------------------------------------------------
void ProbeArrays::AddTo(vtkDataSet* output) const
{
  for (const vtkNew<vtkDoubleArray>& array : this->All)
  {
    output->GetPointData()->AddArray(array);
  }
}
}
