// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/MediumText.h"

#include "commands/OptionNumbers.h"
#include "scene/PhaseName.h"
#include "scene/Scene.h"

#include <vtkParticipatingMedium.h>
#include <vtkPhaseFunction.h>

#include <sstream>
#include <vector>

namespace airlight
{

//------------------------------------------------------------------------------
void ParsePhase(const std::string& option, const std::string& text, vtkParticipatingMedium* medium)
{
  const std::vector<std::string> parts = SplitText(text, ':');
  const vtkSmartPointer<vtkPhaseFunction> phase = MakePhaseFunction(parts[0]);
  if (!phase)
  {
    FailOption(option, text, "one of " + ListPhaseNames() + "; for a table, use --phase-table");
  }
  const int count = phase->GetNumberOfParameters();
  if (count == 0 && parts.size() != 1)
  {
    FailOption(option, text, parts[0] + " alone: it has no parameter");
  }
  bool valid = static_cast<int>(parts.size()) == count + 1;
  std::ostringstream form;
  form << GetPhaseForm(phase) << " with a number";
  for (int i = 0; i < count; ++i)
  {
    double range[2];
    double value = 0.0;
    phase->GetParameterRange(i, range);
    form << (i == 0 ? "" : " and") << " of " << range[0] << " to " << range[1] << " for "
         << phase->GetParameterName(i);
    valid = valid && GetNumber(parts[i + 1], value) && IsInRange({ value }, range[0], range[1]);
    if (valid)
    {
      phase->SetParameter(phase->GetParameterName(i), value);
    }
  }
  if (!valid)
  {
    FailOption(option, text, form.str());
  }
  medium->SetPhaseFunction(phase);
}

//------------------------------------------------------------------------------
void ParseBox(const std::string& option, const std::string& text, vtkParticipatingMedium* medium)
{
  const std::vector<double> bounds = GetNumbers(text);
  if (bounds.size() != 6 || !IsInRange(bounds, -LargestNumber, LargestNumber) ||
    bounds[0] > bounds[1] || bounds[2] > bounds[3] || bounds[4] > bounds[5])
  {
    FailOption(option, text,
      "xmin,xmax,ymin,ymax,zmin,zmax from -1e30 to 1e30, each minimum at most its maximum");
  }
  medium->SetRegionToBox();
  medium->SetBounds(bounds.data());
}

//------------------------------------------------------------------------------
void ParseSphere(const std::string& option, const std::string& text, vtkParticipatingMedium* medium)
{
  const std::vector<std::string> parts = SplitText(text, ':');
  Vector3 center;
  double radius = 0.0;
  if (parts.size() != 2 || !GetVector(parts[0], center) || !GetNumber(parts[1], radius) ||
    radius < 0.0 || radius > LargestNumber)
  {
    FailOption(option, text, "x,y,z:R with a radius of 0 to 1e30");
  }
  medium->SetRegionToSphere();
  medium->SetCenter(center.data());
  medium->SetRadius(radius);
}

//------------------------------------------------------------------------------
void ParseCylinder(
  const std::string& option, const std::string& text, vtkParticipatingMedium* medium)
{
  const std::vector<std::string> parts = SplitText(text, ':');
  Vector3 center;
  double radius = 0.0;
  double height = 0.0;
  Vector3 axis = { 0.0, 1.0, 0.0 };
  if (parts.size() < 3 || parts.size() > 4 || !GetVector(parts[0], center) ||
    !GetNumber(parts[1], radius) || !IsInRange({ radius }, 0.0, LargestNumber) ||
    !GetNumber(parts[2], height) || !IsInRange({ height }, SmallestHeight, LargestNumber) ||
    (parts.size() == 4 && !GetDirection(parts[3], axis)))
  {
    FailOption(option, text,
      "x,y,z:R:H or x,y,z:R:H:ax,ay,az with a radius of 0 to 1e30, a height of 1e-30 to 1e30 and "
      "an axis other than 0");
  }
  medium->SetRegionToCylinder();
  medium->SetCenter(center.data());
  medium->SetRadius(radius);
  medium->SetHeight(height);
  medium->SetAxis(axis.data());
}

//------------------------------------------------------------------------------
void ParseHeightFog(
  const std::string& option, const std::string& text, vtkParticipatingMedium* medium)
{
  const std::vector<std::string> parts = SplitText(text, ':');
  double reference = 0.0;
  double scale = 0.0;
  Vector3 up = { 0.0, 1.0, 0.0 };
  if (parts.size() < 2 || parts.size() > 3 || !GetNumber(parts[0], reference) ||
    !IsInRange({ reference }, -LargestNumber, LargestNumber) || !GetNumber(parts[1], scale) ||
    !IsInRange({ scale }, SmallestHeight, LargestNumber) ||
    (parts.size() == 3 && !GetDirection(parts[2], up)))
  {
    FailOption(option, text,
      "REFERENCE:SCALE or REFERENCE:SCALE:ux,uy,uz with a scale height of 1e-30 to 1e30 and a "
      "direction up "
      "other than 0");
  }
  medium->SetDensityToExponentialHeight();
  medium->SetReferenceHeight(reference);
  medium->SetScaleHeight(scale);
  medium->SetUp(up.data());
}

}
