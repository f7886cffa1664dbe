// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a medium takes of the data of a pipeline source, and nothing else, since it may be sent to
 * other processes.
 */

#ifndef AirlightMediumData_h
#define AirlightMediumData_h

#include "vtkSmartPointer.h"

#include <string>

class vtkDataObject;
class vtkImageData;
class vtkPolyData;

namespace airlight
{
// The polygons of the surfaces of all data sets; empty without any.
vtkSmartPointer<vtkPolyData> MakeMediumSurface(vtkDataObject* data);

// The image with one point array as its scalars: of this name or, if it is empty, the active
// scalars or else the first array. Without scalars if there is none, and without points if the data
// are no image.
vtkSmartPointer<vtkImageData> MakeMediumImage(vtkDataObject* data, const std::string& array);
}

#endif
