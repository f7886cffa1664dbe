// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestCompareScene.h"

#include "vtkAirlightReference.h"
#include "vtkDoubleArray.h"

#include <random>

namespace airlight_test
{
//------------------------------------------------------------------------------
bool Differ(double a, double b, double floor)
{
  return a != b && std::abs(a - b) > 0.01 * std::max(std::abs(a), floor);
}

//------------------------------------------------------------------------------
bool IsUnstable(Scene& scene, double px, double py, const Answer& answer, double floor)
{
  for (int i = 0; i < 4; ++i)
  {
    const Answer other =
      scene.GetAnswer(px + (i % 2 == 0 ? -0.02 : 0.02), py + (i < 2 ? -0.02 : 0.02));
    for (int k = 0; k < 3; ++k)
    {
      if (Differ(answer.Airlight[k], other.Airlight[k], floor) ||
        Differ(answer.Surface[k], other.Surface[k], 1e-3))
      {
        return true;
      }
    }
    if (Differ(answer.Depth, other.Depth, 0.0) || Differ(answer.LitLength, other.LitLength, 1e-2))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
// Whether light on the surface changes, by more than half, at most so many pixels away.
static bool IsAtEdge(Scene& scene, double px, double py, const Answer& answer, double pixels)
{
  for (int i = 0; i < 4 && pixels > 0.0; ++i)
  {
    const Answer other =
      scene.GetAnswer(px + (i % 2 == 0 ? -pixels : pixels), py + (i < 2 ? -pixels : pixels));
    const double low = std::min(answer.Surface.y, other.Surface.y);
    if (low < 0.5 * std::max(answer.Surface.y, other.Surface.y))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void CompareScene(const std::string& name, Scene& scene, int rays, const Limits& limits)
{
  scene.Window->Render();
  Check(scene.Pass->GetEffectiveShadowTechnique() == limits.Technique,
    name + ": drawn with the requested technique");
  if (!Check(scene.GetBuffer("Airlight") != nullptr, name + ": buffers are recorded"))
  {
    return;
  }
  std::mt19937 random(20060130);
  std::uniform_int_distribution<int> columns(0, scene.Width - 1);
  std::uniform_int_distribution<int> rows(0, scene.Height - 1);
  Errors airlight, litLength, depth, surface;
  int excluded = 0;
  int shadowed = 0;
  int dark = 0;
  for (int i = 0; i < rays; ++i)
  {
    const int x = columns(random);
    const int y = rows(random);
    const Answer answer = scene.GetAnswer(x + 0.5, y + 0.5);
    if (IsUnstable(scene, x + 0.5, y + 0.5, answer, 1e-3 * answer.Unshadowed.x))
    {
      ++excluded;
      continue;
    }
    shadowed += answer.Airlight.x < 0.99 * answer.Unshadowed.x;
    airlight.Add(GetColour(scene.GetBuffer("Airlight"), x, y), answer.Airlight);
    depth.Add(glm::dvec3(GetValue(scene.GetBuffer("Depth"), x, y)), glm::dvec3(answer.Depth));
    if (!limits.Spot && answer.LitLength < Infinity &&
      (answer.Depth >= 0.0 || answer.LitLength > 0.0))
    {
      litLength.Add(
        glm::dvec3(GetValue(scene.GetBuffer("LitLength"), x, y)), glm::dvec3(answer.LitLength));
    }
    if (!limits.Spot && answer.Depth >= 0.0 &&
      !IsAtEdge(scene, x + 0.5, y + 0.5, answer, limits.EdgePixels))
    {
      dark += answer.Surface == glm::dvec3(0.0);
      surface.Add(GetColour(scene.GetBuffer("Surface"), x, y), answer.Surface);
    }
  }
  std::cout << name << ": excluded " << 100.0 * excluded / rays << " %, shadowed air on "
            << 100.0 * shadowed / rays << " %, dark surface on " << 100.0 * dark / rays << " % of "
            << rays << " rays\n";
  Check(excluded < MostExcluded * rays, name + ": too many rays are excluded");
  Check(shadowed > rays / 100, name + ": the scene has shadows in the air");
  airlight.Report(name, "Airlight", limits.Median, limits.P99, limits.Wrong);
  litLength.Report(name, "LitLength", limits.Median, limits.P99, limits.Wrong);
  depth.Report(name, "Depth", 2.5e-7 + 2.0 * limits.Rounding, 5e-6 + 4.0 * limits.Rounding);
  surface.Report(name, "Surface", limits.SurfaceMedian + 4.0 * limits.Rounding,
    limits.SurfaceP99 + 40.0 * limits.Rounding);
}

//------------------------------------------------------------------------------
double CompareWithReference(Scene& scene, vtkAirlightReference* reference, const char* name)
{
  auto* expected =
    vtkDoubleArray::SafeDownCast(reference->GetOutput()->GetPointData()->GetArray(name));
  auto* values = static_cast<float*>(scene.GetBuffer(name)->GetScalarPointer());
  std::vector<double> errors;
  double largest = 1e-30;
  for (vtkIdType i = 0; i < expected->GetNumberOfValues(); ++i)
  {
    largest = std::max(largest, expected->GetValue(i));
    errors.push_back(std::abs(values[i] - expected->GetValue(i)));
  }
  std::sort(errors.begin(), errors.end());
  return errors[static_cast<size_t>(0.98 * static_cast<double>(errors.size()))] / largest;
}
}
