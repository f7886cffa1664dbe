// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// How long shadows of a mesh of a million triangles take to prepare, beside vtkFeatureEdges, which
// also has to find every edge's triangles (to tell boundary, non-manifold and feature edges).
//
// One iteration runs everything once, in turn, so that whatever else the machine does meets all of
// them alike; the reported time is that of the whole round. The counters are medians over the
// rounds, in milliseconds, and ratios of these medians:
//   topology     the mesh's edges, once per change of the mesh
//   silhouette   the silhouette of a light that has moved
//   filter       vtkSilhouetteEdgesFilter's update for a light that has moved
//   planes       vtkShadowPlanesFilter's, without caps
//   features     vtkFeatureEdges
// "cpu" counters are medians of the processor's time, of all threads, which other programs on the
// machine disturb less: without threads (Sequential) they are what a quiet machine would take.

#include "Silhouette/AirlightSilhouette.h"
#include "vtkCellArray.h"
#include "vtkFeatureEdges.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"
#include "vtkShadowPlanesFilter.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <memory>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace
{
constexpr int Rounds = 9;
constexpr int Resolution = 708; // 2 * 708 * 707 triangles

// A ball with bumps, whose silhouette is not just one circle.
vtkSmartPointer<vtkPolyData> MakeMesh()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(Resolution);
  sphere->SetPhiResolution(Resolution + 1);
  sphere->SetRadius(1.0);
  sphere->Update();
  vtkSmartPointer<vtkPolyData> mesh = sphere->GetOutput();
  mesh->GetPointData()->Initialize();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    const double scale =
      1.0 + 0.03 * std::sin(25.0 * p[0]) * std::sin(23.0 * p[1]) * std::sin(27.0 * p[2]);
    mesh->GetPoints()->SetPoint(i, scale * p[0], scale * p[1], scale * p[2]);
  }
  return mesh;
}

// The same triangles in a new order; each with points of its own, or with the points in a new
// order, too.
vtkSmartPointer<vtkPolyData> Reorder(vtkPolyData* mesh, bool soup)
{
  std::mt19937_64 random(1);
  std::vector<vtkIdType> newIds(mesh->GetNumberOfPoints());
  std::vector<vtkIdType> order(mesh->GetNumberOfCells());
  std::iota(newIds.begin(), newIds.end(), 0);
  std::iota(order.begin(), order.end(), 0);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  if (!soup)
  {
    std::shuffle(newIds.begin(), newIds.end(), random);
    std::shuffle(order.begin(), order.end(), random);
    points->SetNumberOfPoints(mesh->GetNumberOfPoints());
  }
  for (const vtkIdType cell : order)
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    mesh->GetCellPoints(cell, size, ids);
    vtkIdType turned[3];
    for (int k = 0; k < 3; ++k)
    {
      turned[k] = soup ? points->InsertNextPoint(mesh->GetPoint(ids[k])) : newIds[ids[k]];
      if (!soup)
      {
        points->SetPoint(turned[k], mesh->GetPoint(ids[k]));
      }
    }
    cells->InsertNextCell(3, turned);
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetPolys(cells);
  return result;
}

class Stopwatch
{
public:
  template <typename Function>
  void Measure(const Function& function)
  {
    const std::clock_t cpuStart = std::clock();
    const auto start = std::chrono::steady_clock::now();
    function();
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    this->Times.push_back(time.count());
    this->CpuTimes.push_back(1e3 * static_cast<double>(std::clock() - cpuStart) / CLOCKS_PER_SEC);
  }
  double GetMedian() const { return GetMedianOf(this->Times); }
  double GetCpuMedian() const { return GetMedianOf(this->CpuTimes); }

private:
  static double GetMedianOf(std::vector<double> times)
  {
    const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
    std::nth_element(times.begin(), middle, times.end());
    return *middle;
  }

  std::vector<double> Times;
  std::vector<double> CpuTimes;
};

// vtkFeatureEdges cannot do without common points: it finds no neighbours and, in VTK 9.1, reserves
// memory for the square of the number of points.
void RunRounds(benchmark::State& state, vtkPolyData* mesh, bool withFeatures)
{
  Stopwatch topology;
  Stopwatch silhouette;
  Stopwatch filter;
  Stopwatch planes;
  Stopwatch features;
  vtkNew<vtkSilhouetteEdgesFilter> edgesFilter;
  vtkNew<vtkShadowPlanesFilter> planesFilter;
  edgesFilter->SetInputData(mesh);
  edgesFilter->Update();
  planesFilter->SetInputData(mesh);
  planesFilter->Update();
  vtkIdType edgeCount = 0;
  double angle = 0.0;
  while (state.KeepRunning())
  {
    angle += 0.3;
    const glm::dvec4 light(3.0 * std::cos(angle), 1.5, 3.0 * std::sin(angle), 1.0);
    vtkNew<vtkFeatureEdges> featureEdges;
    featureEdges->SetInputData(mesh);
    if (withFeatures)
    {
      features.Measure([&] { featureEdges->Update(); });
    }
    std::unique_ptr<airlight::CasterMesh> caster;
    topology.Measure([&] { caster = std::make_unique<airlight::CasterMesh>(mesh); });
    silhouette.Measure([&] { edgeCount = airlight::FindSilhouette(*caster, light).size(); });
    edgesFilter->SetLightPosition(light.x, light.y, light.z);
    filter.Measure([&] { edgesFilter->Update(); });
    planesFilter->SetLightPosition(light.x, light.y, light.z);
    planes.Measure([&] { planesFilter->Update(); });
  }
  state.counters["triangles"] = static_cast<double>(mesh->GetNumberOfPolys());
  state.counters["edges"] = static_cast<double>(edgeCount);
  state.counters["topology"] = topology.GetMedian();
  state.counters["silhouette"] = silhouette.GetMedian();
  state.counters["filter"] = filter.GetMedian();
  state.counters["planes"] = planes.GetMedian();
  state.counters["cpu topology"] = topology.GetCpuMedian();
  state.counters["cpu silhouette"] = silhouette.GetCpuMedian();
  state.counters["cpu filter"] = filter.GetCpuMedian();
  state.counters["cpu planes"] = planes.GetCpuMedian();
  if (withFeatures)
  {
    state.counters["cpu features"] = features.GetCpuMedian();
    state.counters["features"] = features.GetMedian();
    state.counters["features/topology"] = features.GetMedian() / topology.GetMedian();
    state.counters["features/silhouette"] = features.GetMedian() / silhouette.GetMedian();
  }
}

void Register(const std::string& name, vtkPolyData* mesh, const std::string& backend)
{
  const vtkSmartPointer<vtkPolyData> kept = mesh;
  const bool withFeatures = name != "soup";
  benchmark::RegisterBenchmark((name + "/" + backend).c_str(),
    [kept, backend, withFeatures](benchmark::State& state) {
      vtkSMPTools::SetBackend(backend.c_str()); // the whole program is ours
      RunRounds(state, kept, withFeatures);
    })
    ->Iterations(Rounds)
    ->Unit(benchmark::kMillisecond);
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  benchmark::Initialize(&argc, argv);
  const std::string usual = vtkSMPTools::GetBackend();
  benchmark::AddCustomContext("vtkSMPTools",
    usual + ", " + std::to_string(vtkSMPTools::GetEstimatedNumberOfThreads()) + " threads");
  const vtkSmartPointer<vtkPolyData> mesh = MakeMesh();
  const vtkSmartPointer<vtkPolyData> shuffled = Reorder(mesh, false);
  const vtkSmartPointer<vtkPolyData> soup = Reorder(mesh, true);
  for (const std::string& backend : { usual, std::string("Sequential") })
  {
    Register("ordered", mesh, backend);
    Register("shuffled", shuffled, backend);
    Register("soup", soup, backend);
  }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
