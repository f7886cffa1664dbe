// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Polygons that cast, as the numbers that ranks send each other.
 */

#ifndef AirlightCasterNumbers_h
#define AirlightCasterNumbers_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <vector>

class vtkActor;
class vtkPolyData;

namespace airlight
{
struct CasterNumbers
{
  std::vector<double> Points; // in world coordinates, which single precision need not hold
  std::vector<int> Polygons;  // of each the number of its points, and these
};

// Adds an actor's data in its place.
void AppendCaster(vtkActor* actor, vtkPolyData* data, CasterNumbers& mesh);

// Back from parts of gathered numbers.
vtkSmartPointer<vtkPolyData> MakePolyData(
  const double* points, vtkIdType pointCount, const int* polygons, vtkIdType polygonsLength);
}

#endif
