// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * When each part of a mesh's geometry was last modified. Geometry prepared from a mesh is up to
 * date while all three times are the same. Their maximum does not suffice: points that are swapped
 * for older ones leave it as it is.
 *
 * No two objects have the same time, so equal times also mean the same objects.
 */

#ifndef AirlightGeometryTimes_h
#define AirlightGeometryTimes_h

#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <array>

namespace airlight
{
// 0 of none.
inline vtkMTimeType GetTime(vtkObject* object) { return object ? object->GetMTime() : 0; }

using GeometryTimes = std::array<vtkMTimeType, 3>; // of points, polygons, strips

inline GeometryTimes GetGeometryTimes(vtkPolyData* data)
{
  return { data->GetPoints() ? data->GetPoints()->GetMTime() : 0, data->GetPolys()->GetMTime(),
    data->GetStrips()->GetMTime() };
}
}

#endif
