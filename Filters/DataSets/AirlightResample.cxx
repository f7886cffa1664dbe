// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "DataSets/AirlightResample.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkCharArray.h"
#include "vtkDataSet.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkProbeFilter.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace airlight
{
namespace
{
constexpr const char* DensityName = "Density";

// The block's geometry with the densities as its only array, of points: those of cells are averaged
// at the points that the cells share.
vtkSmartPointer<vtkDataSet> MakeSource(const DensityBlock& block, double factor)
{
  const auto source = vtkSmartPointer<vtkDataSet>::Take(block.Data->NewInstance());
  source->CopyStructure(block.Data);
  // Hidden cells stay hidden.
  source->GetCellData()->AddArray(block.Data->GetCellGhostArray());
  source->GetPointData()->AddArray(block.Data->GetPointGhostArray());
  const vtkSmartPointer<vtkDataArray> density = ExtractDensity(block, factor, DensityName);
  if (!block.OfCells)
  {
    source->GetPointData()->SetScalars(density);
    return source;
  }
  source->GetCellData()->SetScalars(density);
  vtkNew<vtkCellDataToPointData> points;
  points->SetInputData(source);
  points->Update();
  return vtkDataSet::SafeDownCast(points->GetOutput());
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
void CopyImage(const DensityBlock& block, double factor, vtkImageData* output)
{
  auto* image = vtkImageData::SafeDownCast(block.Data);
  const bool shared = !block.OfCells && factor == 1.0 && block.Array->GetNumberOfComponents() == 1;
  output->CopyStructure(image);
  // Arrays of colours are for the medium, too.
  output->GetPointData()->PassData(image->GetPointData());
  output->GetPointData()->SetScalars(
    shared ? block.Array : MakeSource(block, factor)->GetPointData()->GetScalars());
}

//------------------------------------------------------------------------------
void ResampleBlocks(const std::vector<DensityBlock>& blocks, double factor, const int dimensions[3],
  vtkImageData* output)
{
  PlaceGrid(blocks, dimensions, output);
  vtkNew<vtkFloatArray> density;
  density->SetName(DensityName);
  density->SetNumberOfValues(output->GetNumberOfPoints());
  density->FillValue(0.0f);
  vtkNew<vtkImageData> grid;
  grid->CopyStructure(output);
  vtkNew<vtkProbeFilter> probe;
  probe->SetInputData(grid);
  for (const DensityBlock& block : blocks)
  {
    probe->SetSourceData(MakeSource(block, factor));
    probe->Update();
    vtkPointData* found = probe->GetOutput()->GetPointData();
    auto* valid = vtkCharArray::SafeDownCast(found->GetArray(probe->GetValidPointMaskArrayName()));
    vtkDataArray* values = found->GetArray(DensityName);
    for (vtkIdType i = 0; i < density->GetNumberOfValues(); ++i)
    {
      if (valid->GetValue(i))
      {
        // Interpolation in curved cells may overshoot.
        density->SetValue(i, std::max(static_cast<float>(values->GetComponent(i, 0)), 0.0f));
      }
    }
  }
  output->GetPointData()->SetScalars(density);
}
}
