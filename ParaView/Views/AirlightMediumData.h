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

// Names of point arrays of an image. Density, empty: the active scalars, or else the first array.
// Colours, empty: none.
struct MediumArrays
{
  std::string Density;
  std::string Albedo;
  std::string Emission;
};

// The image with the densities as its scalars, and with the arrays of colours that it has. Without
// scalars if there is no such array, and without points if the data are no image.
vtkSmartPointer<vtkImageData> MakeMediumImage(vtkDataObject* data, const MediumArrays& arrays);
}

#endif
