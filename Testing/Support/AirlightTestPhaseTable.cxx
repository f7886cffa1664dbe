// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestPhaseTable.h"

namespace airlight_test
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkTable> SampleTable(
  double first, double last, double step, const std::function<double(double)>& function)
{
  vtkNew<vtkDoubleArray> angles;
  vtkNew<vtkDoubleArray> values;
  angles->SetName("angle");
  values->SetName("value");
  for (int i = 0; first + i * step <= last; ++i)
  {
    angles->InsertNextValue(first + i * step);
    values->InsertNextValue(function((first + i * step) * Pi / 180.0));
  }
  auto table = vtkSmartPointer<vtkTable>::New();
  table->AddColumn(angles);
  table->AddColumn(values);
  return table;
}

//------------------------------------------------------------------------------
const char* TestTableName(int kind)
{
  static const char* const names[] = { "smooth table", "10 to 170 degrees", "two rows",
    "contrast of 1e6", "rainbow" };
  return names[kind];
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTable> MakeTable(int kind, double scale)
{
  const auto lobes = [scale](double angle) {
    const double mu = std::cos(angle);
    return scale *
      (0.8 * HenyeyGreensteinPhase{ 0.7 }(1.0 - mu, 1.0 + mu) +
        0.2 * HenyeyGreensteinPhase{ -0.3 }(1.0 - mu, 1.0 + mu));
  };
  switch (kind)
  {
    case TABLE_SMOOTH:
      return SampleTable(0.0, 180.0, 2.0, lobes);
    case TABLE_PARTIAL:
      return SampleTable(10.0, 170.0, 5.0, lobes);
    case TABLE_TWO_ROWS:
      return SampleTable(
        0.0, 180.0, 180.0, [scale](double angle) { return scale * (angle < 1.0 ? 40.0 : 0.4); });
    case TABLE_CONTRAST:
      return SampleTable(0.0, 180.0, 5.0,
        [scale](double angle) { return scale * std::pow(10.0, 3.0 + 3.0 * std::cos(angle)); });
    default:
      return SampleTable(0.0, 180.0, 1.0, [&](double angle) {
        const double distance = (angle * 180.0 / Pi - 138.0) / 3.0;
        return lobes(angle) + 0.1 * scale * std::exp(-distance * distance);
      });
  }
}
}
