// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightMediumData.h"

#include "vtkAppendPolyData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

namespace airlight
{
namespace
{
//------------------------------------------------------------------------------
void AddSurface(vtkDataObject* data, vtkAppendPolyData* all)
{
  auto* set = vtkDataSet::SafeDownCast(data);
  if (!set || set->GetNumberOfCells() == 0)
  {
    return;
  }
  auto* mesh = vtkPolyData::SafeDownCast(set);
  vtkNew<vtkDataSetSurfaceFilter> outside;
  if (!mesh)
  {
    outside->SetInputData(set);
    outside->Update();
    mesh = outside->GetOutput();
  }
  vtkNew<vtkPolyData> polygons;
  polygons->SetPoints(mesh->GetPoints());
  polygons->SetPolys(mesh->GetPolys());
  polygons->SetStrips(mesh->GetStrips());
  all->AddInputData(polygons);
}

//------------------------------------------------------------------------------
vtkDataArray* FindDensity(vtkPointData* arrays, const std::string& name)
{
  if (!name.empty())
  {
    return arrays->GetArray(name.c_str());
  }
  return arrays->GetScalars() ? arrays->GetScalars() : arrays->GetArray(0);
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeMediumSurface(vtkDataObject* data)
{
  vtkNew<vtkAppendPolyData> all;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto leaf = vtk::TakeSmartPointer(composite->NewIterator());
    for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
    {
      AddSurface(leaf->GetCurrentDataObject(), all);
    }
  }
  else
  {
    AddSurface(data, all);
  }
  if (all->GetNumberOfInputConnections(0) == 0)
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  all->Update();
  return all->GetOutput();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeMediumImage(vtkDataObject* data, const MediumArrays& arrays)
{
  const auto density = vtkSmartPointer<vtkImageData>::New();
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    density->CopyStructure(image);
    density->GetPointData()->SetScalars(FindDensity(image->GetPointData(), arrays.Density));
    for (const std::string& name : { arrays.Albedo, arrays.Emission })
    {
      density->GetPointData()->AddArray(
        name.empty() ? nullptr : image->GetPointData()->GetArray(name.c_str()));
    }
  }
  return density;
}
}
