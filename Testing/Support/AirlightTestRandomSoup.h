// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Random triangles, as data and for AirlightTestBruteForce.h, and lights of all kinds among them.
 */

#ifndef AirlightTestRandomSoup_h
#define AirlightTestRandomSoup_h

#include "AirlightTestBruteForce.h"
#include "AirlightTestTools.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <utility>
#include <vector>

namespace airlight_test
{

// Triangles of all sizes in [-1, 1]^3, each with its own points.
vtkSmartPointer<vtkPolyData> MakeRandomSoup(
  Random& random, int count, std::vector<Triangle>& triangles);

// A light of each kind, with its name.
std::vector<std::pair<std::string, vtkSmartPointer<vtkLight>>> MakeLights();
}

#endif
