// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameErrors.h"

#include "vtkAirlightReference.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <cmath>

namespace benchmarks
{
namespace
{
constexpr int Width = 160;
constexpr int Height = 120;
constexpr int MostSteps = 2048; // of vtkAirlightPass

constexpr double SameDepth = 1e-3;

// Whether both see the same surface, or none: -1 stands for none.
bool IsSame(double depth, double expected)
{
  return std::abs(depth - expected) <= SameDepth * std::abs(expected);
}

vtkDataArray* GetScalars(vtkAirlightPass* pass, const char* buffer)
{
  return pass->GetBuffer(buffer)->GetPointData()->GetScalars();
}

vtkSmartPointer<vtkDataArray> Copy(vtkDataArray* array)
{
  auto copy = vtkSmartPointer<vtkDataArray>::Take(array->NewInstance());
  copy->DeepCopy(array);
  return copy;
}
}

//------------------------------------------------------------------------------
FrameErrors::FrameErrors(FrameScene& scene, Exact exact)
  : Scene(scene)
{
  const int* size = scene.Window->GetSize();
  this->Size[0] = size[0];
  this->Size[1] = size[1];
  if (exact == Exact::Planes)
  {
    vtkAirlightPass* pass = scene.Record(MakePlanes());
    this->Airlight = Copy(GetScalars(pass, "Airlight"));
    this->Depth = Copy(GetScalars(pass, "Depth"));
    return;
  }
  vtkNew<vtkAirlightReference> reference;
  reference->SetRenderer(scene.Renderer);
  reference->SetMedium(scene.Medium);
  reference->SetSize(Width, Height);
  reference->Update();
  this->Airlight = reference->GetOutput()->GetPointData()->GetArray("Airlight");
  this->Depth = reference->GetOutput()->GetPointData()->GetArray("Depth");
  scene.Window->SetSize(Width, Height);
}

//------------------------------------------------------------------------------
FrameErrors::~FrameErrors() { this->Scene.Window->SetSize(this->Size[0], this->Size[1]); }

//------------------------------------------------------------------------------
double FrameErrors::Measure(const Way& way)
{
  vtkAirlightPass* pass = this->Scene.Record(way);
  vtkDataArray* airlight = GetScalars(pass, "Airlight");
  vtkDataArray* depth = GetScalars(pass, "Depth");
  double squares = 0.0;
  double sum = 0.0;
  double count = 0.0;
  for (vtkIdType i = 0; i < this->Airlight->GetNumberOfTuples(); ++i)
  {
    for (int j = 0; j < 3 && IsSame(depth->GetTuple1(i), this->Depth->GetTuple1(i)); ++j)
    {
      const double value = this->Airlight->GetComponent(i, j);
      squares += std::pow(airlight->GetComponent(i, j) - value, 2);
      sum += value;
      ++count;
    }
  }
  return std::sqrt(squares / count) / (sum / count);
}

//------------------------------------------------------------------------------
int FrameErrors::FindSteps(double error)
{
  const auto reaches = [&](int steps) { return this->Measure(MakeRayMarch(steps)) <= error; };
  int few = 0; // never enough
  int enough = 1;
  while (!reaches(enough))
  {
    if (enough == MostSteps)
    {
      return 0;
    }
    few = enough;
    enough *= 2;
  }
  while (enough - few > 1)
  {
    const int middle = (few + enough) / 2;
    (reaches(middle) ? enough : few) = middle;
  }
  return enough;
}
}
