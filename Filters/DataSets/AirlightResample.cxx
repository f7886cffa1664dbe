// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DataSets/AirlightResample.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkCharArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkProbeFilter.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>

namespace airlight
{
namespace
{
constexpr const char* DensityName = "Density";

// Arrays of numbers, but for the densities, which have a name of their own, and for those that
// `others` have. Without their part as scalars: SetScalars() would remove the array that has it.
void AddArrays(vtkDataSetAttributes* from, const char* densities, vtkDataSetAttributes* others,
  vtkDataSetAttributes* to)
{
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = from->GetArray(i);
    const std::string name = array && array->GetName() ? array->GetName() : "";
    if (!name.empty() && name != DensityName && name != (densities ? densities : "") &&
      !(others && others->HasArray(name.c_str())))
    {
      to->AddArray(array);
    }
  }
}

// The block's geometry with the densities as its only array, or with all arrays, of points: those
// of cells are averaged at the points that the cells share.
vtkSmartPointer<vtkDataSet> MakeSource(const DensityBlock& block, double factor, bool all)
{
  const auto source = vtkSmartPointer<vtkDataSet>::Take(block.Data->NewInstance());
  source->CopyStructure(block.Data);
  if (all)
  {
    const char* densities = block.Array->GetName();
    AddArrays(block.Data->GetPointData(), densities, nullptr, source->GetPointData());
    AddArrays(block.Data->GetCellData(), densities, source->GetPointData(), source->GetCellData());
  }
  // Hidden cells stay hidden.
  source->GetCellData()->AddArray(block.Data->GetCellGhostArray());
  source->GetPointData()->AddArray(block.Data->GetPointGhostArray());
  const vtkSmartPointer<vtkDataArray> density = ExtractDensity(block, factor, DensityName);
  if (!block.OfCells)
  {
    source->GetPointData()->SetScalars(density);
  }
  else
  {
    source->GetCellData()->SetScalars(density);
  }
  if (!block.OfCells && !all)
  {
    return source;
  }
  vtkNew<vtkCellDataToPointData> points;
  points->SetInputData(source);
  points->Update();
  const vtkSmartPointer<vtkDataSet> result = vtkDataSet::SafeDownCast(points->GetOutput());
  result->GetCellData()->AddArray(block.Data->GetCellGhostArray());
  result->GetPointData()->SetActiveScalars(DensityName);
  return result;
}

// What a probe found of an array at the points that are `valid`, into the output's array of its
// name. Such an array is 0 elsewhere.
void AddSamples(
  vtkDataArray* found, vtkDataArray* source, vtkCharArray* valid, vtkPointData* output)
{
  vtkSmartPointer<vtkDataArray> samples = output->GetArray(found->GetName());
  if (!samples)
  {
    samples = vtkSmartPointer<vtkDataArray>::Take(found->NewInstance());
    samples->SetName(found->GetName());
    samples->SetNumberOfComponents(found->GetNumberOfComponents());
    samples->CopyComponentNames(found);
    samples->SetNumberOfTuples(found->GetNumberOfTuples());
    samples->Fill(0.0);
    output->AddArray(samples);
  }
  if (samples->GetDataType() != found->GetDataType() ||
    samples->GetNumberOfComponents() != found->GetNumberOfComponents())
  {
    throw std::runtime_error(std::string("has arrays '") + found->GetName() +
      "' of several types or numbers of components in its blocks; rename one of them");
  }
  for (int c = 0; c < samples->GetNumberOfComponents(); ++c)
  {
    // Interpolation in curved cells, and a little outside of all cells, may overshoot.
    double range[2];
    source->GetRange(range, c);
    for (vtkIdType i = 0; i < samples->GetNumberOfTuples(); ++i)
    {
      if (valid->GetValue(i))
      {
        samples->SetComponent(
          i, c, std::min(std::max(found->GetComponent(i, c), range[0]), range[1]));
      }
    }
  }
}

// Of all arrays but those that the probe adds, and ghosts. What the source lacks is 0 in its cells.
void AddAllSamples(
  vtkPointData* found, vtkPointData* source, vtkCharArray* valid, vtkPointData* output)
{
  for (int i = 0; i < found->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = found->GetArray(i);
    vtkDataArray* from = array && array->GetName() ? source->GetArray(array->GetName()) : nullptr;
    if (from && std::string(array->GetName()) != vtkDataSetAttributes::GhostArrayName())
    {
      AddSamples(array, from, valid, output);
    }
  }
  for (int i = 0; i < output->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = output->GetArray(i);
    const vtkIdType count = found->HasArray(array->GetName()) ? 0 : array->GetNumberOfTuples();
    for (vtkIdType k = 0; k < count; ++k)
    {
      for (int c = 0; valid->GetValue(k) && c < array->GetNumberOfComponents(); ++c)
      {
        array->SetComponent(k, c, 0.0);
      }
    }
  }
}

void PlaceGrid(const std::vector<DensityBlock>& blocks, const int dimensions[3], vtkImageData* grid)
{
  vtkBoundingBox box;
  for (const DensityBlock& block : blocks)
  {
    box.AddBounds(block.Data->GetBounds());
  }
  double lengths[3];
  box.GetLengths(lengths);
  if (!(lengths[0] > 0.0 && lengths[1] > 0.0 && lengths[2] > 0.0))
  {
    std::ostringstream text;
    text << "is " << lengths[0] << " x " << lengths[1] << " x " << lengths[2]
         << " large: a density needs a volume; extrude a flat data set";
    throw std::runtime_error(text.str());
  }
  grid->SetDimensions(dimensions);
  grid->SetOrigin(box.GetMinPoint());
  grid->SetSpacing(lengths[0] / (dimensions[0] - 1), lengths[1] / (dimensions[1] - 1),
    lengths[2] / (dimensions[2] - 1));
}
}

//------------------------------------------------------------------------------
bool IsWholeImage(const DensityBlock& block)
{
  auto* image = vtkImageData::SafeDownCast(block.Data);
  return image && !image->HasAnyBlankCells() && !image->HasAnyBlankPoints();
}

//------------------------------------------------------------------------------
void CopyImage(const DensityBlock& block, double factor, bool cells, vtkImageData* output)
{
  auto* image = vtkImageData::SafeDownCast(block.Data);
  const bool shared = !block.OfCells && factor == 1.0 && block.Array->GetNumberOfComponents() == 1;
  output->CopyStructure(image);
  // Arrays of colours are for the medium, too; SetScalars() would remove one that is the scalars.
  vtkPointData* arrays = output->GetPointData();
  arrays->PassData(image->GetPointData());
  arrays->SetActiveAttribute(-1, vtkDataSetAttributes::SCALARS);
  vtkSmartPointer<vtkDataSet> source; // a copy of the densities, where it is needed
  if (cells || !shared)
  {
    source = MakeSource(block, factor, cells);
  }
  if (cells)
  {
    AddArrays(source->GetPointData(), nullptr, image->GetPointData(), arrays);
  }
  arrays->SetScalars(shared ? block.Array : source->GetPointData()->GetScalars());
}

//------------------------------------------------------------------------------
void ResampleBlocks(const std::vector<DensityBlock>& blocks, double factor, bool all,
  const int dimensions[3], vtkImageData* output)
{
  PlaceGrid(blocks, dimensions, output);
  vtkNew<vtkImageData> grid;
  grid->CopyStructure(output);
  vtkNew<vtkProbeFilter> probe;
  probe->SetInputData(grid);
  for (const DensityBlock& block : blocks)
  {
    const vtkSmartPointer<vtkDataSet> source = MakeSource(block, factor, all);
    probe->SetSourceData(source);
    probe->Update();
    vtkPointData* found = probe->GetOutput()->GetPointData();
    auto* valid = vtkCharArray::SafeDownCast(found->GetArray(probe->GetValidPointMaskArrayName()));
    AddAllSamples(found, source->GetPointData(), valid, output->GetPointData());
  }
  output->GetPointData()->SetActiveScalars(DensityName);
}
}
