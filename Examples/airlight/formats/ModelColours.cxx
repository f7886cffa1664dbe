// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "formats/ModelColours.h"

#include <vtkColorTransferFunction.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <array>
#include <cmath>

namespace airlight
{

namespace
{
// IEC 61966-2-1.
double Decode(double value)
{
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

std::array<unsigned char, 256> MakeTable()
{
  std::array<unsigned char, 256> table{};
  for (int i = 0; i < 256; ++i)
  {
    table[i] = static_cast<unsigned char>(std::lround(255.0 * Decode(i / 255.0)));
  }
  return table;
}

vtkUnsignedCharArray* GetColours(vtkPolyData* mesh)
{
  auto* colours = vtkUnsignedCharArray::SafeDownCast(mesh->GetPointData()->GetScalars());
  return colours && colours->GetNumberOfComponents() >= 3 ? colours : nullptr;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ColourByScalars(vtkPolyData* mesh)
{
  vtkDataArray* scalars = mesh->GetPointData()->GetScalars();
  if (!scalars || scalars->GetNumberOfComponents() != 1)
  {
    return mesh;
  }
  double range[2];
  scalars->GetFiniteRange(range, 0);
  if (!(range[0] < range[1]) || !std::isfinite(range[1] - range[0]))
  {
    return mesh;
  }
  vtkNew<vtkColorTransferFunction> map;
  map->SetColorSpaceToDiverging();
  map->AddRGBPoint(range[0], 0.230, 0.299, 0.754);
  map->AddRGBPoint(range[1], 0.706, 0.016, 0.150);
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  colours->SetNumberOfTuples(scalars->GetNumberOfTuples());
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    const unsigned char* colour = map->MapValue(scalars->GetTuple1(i));
    for (int c = 0; c < 3; ++c)
    {
      colours->SetTypedComponent(i, c, colour[c]);
    }
  }
  vtkNew<vtkPolyData> copy;
  copy->ShallowCopy(mesh);
  copy->GetPointData()->SetScalars(colours);
  return copy;
}

//------------------------------------------------------------------------------
Vector3 DecodeSRGB(const double colour[3])
{
  return { Decode(colour[0]), Decode(colour[1]), Decode(colour[2]) };
}

//------------------------------------------------------------------------------
bool HasColours(vtkPolyData* mesh) { return GetColours(mesh) != nullptr; }

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> DecodeColours(vtkPolyData* mesh)
{
  vtkUnsignedCharArray* colours = GetColours(mesh);
  if (!colours)
  {
    return mesh;
  }
  static const std::array<unsigned char, 256> table = MakeTable();
  vtkNew<vtkUnsignedCharArray> decoded;
  decoded->DeepCopy(colours);
  for (vtkIdType i = 0; i < decoded->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      decoded->SetTypedComponent(i, c, table[colours->GetTypedComponent(i, c)]);
    }
  }
  vtkNew<vtkPolyData> copy;
  copy->ShallowCopy(mesh);
  copy->GetPointData()->SetScalars(decoded);
  return copy;
}

}
