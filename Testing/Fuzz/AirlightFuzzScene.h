// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Media, lights and meshes by random calls, good ones and bad ones.
 */

#ifndef AirlightFuzzScene_h
#define AirlightFuzzScene_h

#include "AirlightFuzz.h"

#include "vtkSmartPointer.h"

class vtkActor;
class vtkAirlightPass;
class vtkDataSet;
class vtkImageData;
class vtkLight;
class vtkParticipatingMedium;
class vtkPolyData;
class vtkTable;

namespace airlight_fuzz
{
// One call of one of the setters.
void ChangeMedium(Input& input, vtkParticipatingMedium* medium);
void ChangeLight(Input& input, vtkLight* light);
void ChangePass(
  Input& input, vtkAirlightPass* pass, vtkParticipatingMedium* medium, vtkLight* light);

// Triangles, polygons, strips, lines and vertices over a few points, which often coincide; and,
// every fourth time, a closed box.
vtkSmartPointer<vtkPolyData> MakeMesh(Input& input);

// Lines over a few points.
vtkSmartPointer<vtkPolyData> MakeLines(Input& input);

// A table of two columns, more or less: angles and values.
vtkSmartPointer<vtkTable> MakeTable(Input& input);

// A few points of one component, more or less.
vtkSmartPointer<vtkImageData> MakeImage(Input& input);

// A mesh that is placed, coloured and shown in one way or another.
vtkSmartPointer<vtkActor> MakeActor(Input& input);

// That arrays of single and double precision, of points and of cells, hold finite numbers.
void RequireFinite(vtkDataSet* data, const char* name);
}

#endif
