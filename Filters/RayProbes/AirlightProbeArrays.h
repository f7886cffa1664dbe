// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The arrays of vtkAirlightProbeFilter, filled point by point.
 */

#ifndef AirlightProbeArrays_h
#define AirlightProbeArrays_h

#include "RayProbes/AirlightProbe.h"
#include "RayProbes/AirlightSightLine.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"

#include <atomic>
#include <deque>

class vtkDataArray;
class vtkDataSet;

namespace airlight
{
// What vtkAirlightProbeFilter::SetSightLines() depends on.
struct SightLineSettings
{
  double ReflectingConstant;
  double EmittingConstant;
  double MaximumVisibility;
  airlight::Sign Sign;
};

class ProbeArrays
{
public:
  ProbeArrays(const Probe& probe, vtkDataSet* points);

  // Before the first point.
  void AddScattered();
  void AddSightLines(const SightLineSettings& settings);

  // Thread safe for different points. Points that are not usable (see IsUsable()) get zeros.
  void Measure(vtkIdType i);

  void AddTo(vtkDataSet* output) const;

  glm::dvec3 Eye{ 0.0 };
  double Margin = 0.0;             // of shadows, see Probe::FindDirect()
  std::atomic<vtkIdType> Bad{ 0 }; // points that are not usable

private:
  vtkDoubleArray* Add(const char* name, int components);
  void MeasureSightLine(vtkIdType i, const glm::dvec3& point, const glm::dvec3& irradiance,
    const glm::dvec3& airlight, const glm::dvec3& transmittance);

  const Probe& Source;
  vtkDataSet* Points;
  vtkDataArray* Normals;
  SightLineSettings Settings{};
  std::deque<vtkNew<vtkDoubleArray>> All;
  vtkDoubleArray* Radiance;
  vtkDoubleArray* Transmittance;
  vtkDoubleArray* Direct;
  vtkDoubleArray* Scattered = nullptr;
  vtkDoubleArray* Extinction = nullptr; // null without lines of sight, the next four, too
  vtkDoubleArray* Reflecting = nullptr;
  vtkDoubleArray* Emitting = nullptr;
  vtkDoubleArray* Seen = nullptr;
  vtkDoubleArray* WithoutAirlight = nullptr;
};
}

#endif
