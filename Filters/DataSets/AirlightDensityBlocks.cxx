// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DataSets/AirlightDensityBlocks.h"

#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace airlight
{
namespace
{
// Far below the largest float: products with coefficients and sums stay finite.
constexpr double LargestDensity = 1e30;

std::vector<vtkDataSet*> FindDataSets(vtkDataObject* input)
{
  std::vector<vtkDataSet*> found;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
  {
    const auto it = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      found.push_back(vtkDataSet::SafeDownCast(it->GetCurrentDataObject()));
    }
  }
  else
  {
    found.push_back(vtkDataSet::SafeDownCast(input));
  }
  std::vector<vtkDataSet*> filled;
  for (vtkDataSet* data : found)
  {
    if (data && data->GetNumberOfCells() > 0)
    {
      filled.push_back(data);
    }
  }
  return filled;
}

// "'soot' (points, 1 component), ..."
std::string ListArrays(vtkDataSet* data)
{
  std::ostringstream text;
  const auto list = [&text](vtkDataSetAttributes* attributes, const char* place) {
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      if (vtkDataArray* array = attributes->GetArray(i))
      {
        text << (text.tellp() > 0 ? ", " : "") << "'" << (array->GetName() ? array->GetName() : "")
             << "' (" << place << ", " << array->GetNumberOfComponents() << ")";
      }
    }
  };
  list(data->GetPointData(), "points");
  list(data->GetCellData(), "cells");
  return text.tellp() > 0 ? text.str() : "none";
}

vtkDataArray* FindArray(vtkDataSetAttributes* attributes, const std::string& name)
{
  return name.empty() ? attributes->GetScalars() : attributes->GetArray(name.c_str());
}

int FindComponent(vtkDataArray* array, const DensityChoice& choice)
{
  const int count = array->GetNumberOfComponents();
  std::ostringstream text;
  text << "has " << count << " components in its array '"
       << (array->GetName() ? array->GetName() : "") << "'";
  std::string names;
  for (int i = 0; i < count; ++i)
  {
    const char* name = array->GetComponentName(i);
    if (name && choice.ComponentName == name)
    {
      return i;
    }
    names += (i > 0 ? ", '" : "'") + std::string(name ? name : "") + "'";
  }
  if (!choice.ComponentName.empty())
  {
    text << " and none of them is named '" << choice.ComponentName << "': the names are " << names;
    throw std::runtime_error(text.str());
  }
  if (choice.Component < 0 && count != 1)
  {
    text << " and one is needed: choose it with SetComponent() or SetComponentName()";
    throw std::runtime_error(text.str());
  }
  if (choice.Component >= count)
  {
    text << " and component " << choice.Component << " was chosen, counted from 0";
    throw std::runtime_error(text.str());
  }
  return std::max(choice.Component, 0);
}

DensityBlock MakeBlock(vtkDataSet* data, const DensityChoice& choice)
{
  DensityBlock block{ data, FindArray(data->GetPointData(), choice.Array), 0, false };
  if (!block.Array)
  {
    block.Array = FindArray(data->GetCellData(), choice.Array);
    block.OfCells = true;
  }
  if (!block.Array)
  {
    throw std::runtime_error(
      (choice.Array.empty() ? std::string("has no active scalars: choose an array with "
                                          "SetArrayName()")
                            : "has no array '" + choice.Array + "' of points or cells") +
      "; there are " + ListArrays(data));
  }
  block.Component = FindComponent(block.Array, choice);
  return block;
}

// NaN is no density.
void CheckValues(const DensityBlock& block, double factor)
{
  for (vtkIdType i = 0; i < block.Array->GetNumberOfTuples(); ++i)
  {
    const double value = block.Array->GetComponent(i, block.Component);
    if (!(value >= 0.0 && factor * value <= LargestDensity))
    {
      std::ostringstream text;
      text << "has the value " << value << " at " << (block.OfCells ? "cell " : "point ") << i
           << " of its array '" << (block.Array->GetName() ? block.Array->GetName() : "")
           << "': densities must be numbers, at least 0 and times Factor at most "
           << LargestDensity;
      throw std::runtime_error(text.str());
    }
  }
}
}

//------------------------------------------------------------------------------
std::vector<DensityBlock> FindDensityBlocks(vtkDataObject* input, const DensityChoice& choice)
{
  const std::vector<vtkDataSet*> data = FindDataSets(input);
  if (data.empty())
  {
    throw std::runtime_error("has no cells: give it a data set with cells, which fill space");
  }
  std::vector<DensityBlock> blocks;
  for (vtkDataSet* each : data)
  {
    blocks.push_back(MakeBlock(each, choice));
    CheckValues(blocks.back(), choice.Factor);
  }
  return blocks;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataArray> ExtractDensity(
  const DensityBlock& block, double factor, const char* name)
{
  auto result = vtkSmartPointer<vtkFloatArray>::New();
  result->SetName(name);
  result->SetNumberOfValues(block.Array->GetNumberOfTuples());
  for (vtkIdType i = 0; i < result->GetNumberOfValues(); ++i)
  {
    result->SetValue(i, static_cast<float>(factor * block.Array->GetComponent(i, block.Component)));
  }
  return result;
}
}
