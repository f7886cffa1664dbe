// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The data sets of a data object that hold densities, and the array of each. Behind
 * vtkAirlightDensityImage.
 */

#ifndef AirlightDensityBlocks_h
#define AirlightDensityBlocks_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkDataObject;
class vtkDataSet;

namespace airlight
{
// Which array, and which of its numbers, is the density.
struct DensityChoice
{
  std::string Array;         // empty: the active scalars, or the only array
  int Component = -1;        // -1: the only one
  std::string ComponentName; // not empty: instead of the number
  double Factor = 1.0;
};

struct DensityBlock
{
  vtkDataSet* Data;
  vtkDataArray* Array;
  int Component;
  bool OfCells;
};

// In the order in which they cover each other: of AMR, fine levels come after coarse ones. Throws
// std::runtime_error that continues "The input ..." where there are none, or one of them lacks the
// array, or a value of it is no density.
std::vector<DensityBlock> FindDensityBlocks(vtkDataObject* input, const DensityChoice& choice);

// The densities alone, times the factor, as a float array of the name.
vtkSmartPointer<vtkDataArray> ExtractDensity(
  const DensityBlock& block, double factor, const char* name);
}

#endif
