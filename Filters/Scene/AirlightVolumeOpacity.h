// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A volume's extinction, as VTK's ray casting has it: on a way of length l passes exp(-sigma l),
 *
 *   sigma(s) = -ln(1 - alpha(s)) / ScalarOpacityUnitDistance,
 *
 * alpha the scalar opacity function and s the scalar, interpolated between the image's points. The
 * unit distance is a length of the data's coordinates: a matrix that scales these divides sigma by
 * the mean of its three scales. What VTK draws as opaque has a depth of 12 between two samples.
 *
 * Scalars are interpolated linearly, also where the vtkVolumeProperty asks for the nearest. Not
 * installed.
 */

#ifndef AirlightVolumeOpacity_h
#define AirlightVolumeOpacity_h

#include "Scene/AirlightVolumeCheck.h"

#include "vtkSmartPointer.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <vector>

class vtkMatrix4x4;

namespace airlight
{
// Keeps the volume's scalars; many threads may use it at once.
class VolumeOpacity
{
public:
  // Of scalars that FindVolumeScalars() has found.
  VolumeOpacity(
    vtkVolume* volume, const VolumeScalars& scalars, vtkMatrix4x4* toWorld, bool colours = false);

  // Numbers of the volume's points.
  const glm::ivec3& GetSize() const { return this->Size; }

  // From places counted in points.
  const glm::dmat4& GetToWorld() const { return this->ToWorld; }

  // The extinction, 1/world, at a place counted in points, which is moved into the volume.
  double GetExtinction(const glm::dvec3& place) const
  {
    return Classify(this->Table, this->GetEntry(place));
  }

  // What the volume's colour function says there, from 0 to 1, if made with colours.
  glm::dvec3 GetColour(const glm::dvec3& place) const
  {
    return Classify(this->Colours, this->GetEntry(place));
  }

private:
  double GetEntry(const glm::dvec3& place) const;
  template <typename Value>
  static Value Classify(const std::vector<Value>& table, double entry)
  {
    const size_t i = std::min(static_cast<size_t>(entry), table.size() - 2);
    return glm::mix(table[i], table[i + 1], entry - static_cast<double>(i));
  }

  vtkSmartPointer<vtkDataArray> Values;
  glm::ivec3 Size{ 0 };
  glm::dmat4 ToWorld{ 1.0 };
  std::vector<double> Table;       // extinctions of equally spaced scalars
  std::vector<glm::dvec3> Colours; // likewise
  double Lowest = 0.0;             // scalar
  double PerScalar = 0.0;          // entries
};
}

#endif
