// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The source function of a medium's multiply scattered light, made when it is first needed and
 * again after a change of what it depends on: the phase function and the albedo.
 */

#ifndef AirlightMediumSource_h
#define AirlightMediumSource_h

#include "MultipleScattering/AirlightSourceFit.h"
#include "vtkType.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace airlight
{
class MediumSource
{
public:
  // `phaseTime` grows with every change of the phase function. Null with an error where it has too
  // narrow a peak; the error is given once for each change.
  std::shared_ptr<const SourceFit> Update(const glm::dvec3& albedo, vtkMTimeType phaseTime,
    const std::function<double(double)>& phaseFunction, std::string& error);

private:
  std::shared_ptr<const SourceFit> Made;
  std::vector<double> Legendre;
  glm::dvec3 Albedo{ -1.0 };
  vtkMTimeType PhaseTime = 0;
};
}

#endif
