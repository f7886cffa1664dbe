// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkSilhouetteEdgesFilter and vtkShadowPlanesFilter in a pipeline: progress, abort and composite
// data.

#include "AirlightTestCheck.h"
#include "AirlightTestSoup.h"

#include "vtkCallbackCommand.h"
#include "vtkCubeSource.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkShadowPlanesFilter.h"
#include "vtkSphereSource.h"

#include <array>
#include <cstdlib>
#include <vector>

using namespace airlight_test;

namespace
{
using FilterPair = std::array<vtkSmartPointer<vtkSilhouetteEdgesFilter>, 2>;

FilterPair MakeFilters()
{
  return { vtkSmartPointer<vtkSilhouetteEdgesFilter>::New(),
    vtkSmartPointer<vtkShadowPlanesFilter>::New() };
}

//------------------------------------------------------------------------------
void TestProgressAndAbort()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(100);
  sphere->SetPhiResolution(100);
  sphere->Update();
  const FilterPair filters = MakeFilters();
  for (vtkSilhouetteEdgesFilter* f : filters)
  {
    f->SetInputData(sphere->GetOutput());
    f->SetLightPosition(3, 4, 5);
    struct State
    {
      std::vector<double> Values;
      int AbortAt = -1;
    } state;
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(&state);
    command->SetCallback([](vtkObject* caller, unsigned long, void* data, void* progress) {
      State& s = *static_cast<State*>(data);
      s.Values.push_back(*static_cast<double*>(progress));
      if (static_cast<int>(s.Values.size()) == s.AbortAt)
      {
        static_cast<vtkAlgorithm*>(caller)->AbortExecuteOn();
      }
    });
    f->AddObserver(vtkCommand::ProgressEvent, command);
    f->Update();
    const std::vector<double> values = state.Values;
    bool rising = values.size() > 5;
    for (size_t i = 1; i < values.size(); ++i)
    {
      rising = rising && values[i] >= values[i - 1];
    }
    Check(rising && values.front() >= 0.0 && values.back() == 1.0, "progress rises to 1");
    const vtkIdType cells = f->GetOutput()->GetNumberOfCells();
    Check(cells > 100, "a sphere has a silhouette");
    // The first call is the pipeline's, before it starts; the last one, after the end.
    for (int at = 2; at < static_cast<int>(values.size()); ++at)
    {
      vtkNew<vtkPolyData> copy; // nothing is prepared for it
      copy->DeepCopy(sphere->GetOutput());
      f->SetInputData(copy);
      state.Values.clear();
      state.AbortAt = at;
      f->Update();
      Check(f->GetOutput()->GetNumberOfCells() == 0,
        Text("an abort at progress ", values[at - 1], " leaves an empty output"));
      state.AbortAt = -1;
      f->AbortExecuteOff(); // which VTK up to 9.1 does by itself
      f->Modified();
      f->Update();
      Check(f->GetOutput()->GetNumberOfCells() == cells, "after an abort, all as before");
    }
  }
}

//------------------------------------------------------------------------------
void TestComposite()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkNew<vtkMultiBlockDataSet> inner;
  vtkNew<vtkCubeSource> cube;
  cube->Update();
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(3, 0, 0);
  sphere->Update();
  inner->SetBlock(0, sphere->GetOutput());
  inner->SetBlock(1, nullptr);
  blocks->SetBlock(0, cube->GetOutput());
  blocks->SetBlock(1, inner);
  const FilterPair composite = MakeFilters();
  const FilterPair single = MakeFilters();
  for (int i = 0; i < 2; ++i)
  {
    for (const double x : { 9.0, -7.0 }) // the second time the blocks are known
    {
      vtkSilhouetteEdgesFilter* f = composite[i];
      f->SetInputDataObject(blocks);
      f->SetLightPosition(x, 4, 5);
      f->Update();
      auto* output = vtkMultiBlockDataSet::SafeDownCast(f->GetOutputDataObject(0));
      auto* nested = output ? vtkMultiBlockDataSet::SafeDownCast(output->GetBlock(1)) : nullptr;
      vtkPolyData* found[2] = { output ? vtkPolyData::SafeDownCast(output->GetBlock(0)) : nullptr,
        nested ? vtkPolyData::SafeDownCast(nested->GetBlock(0)) : nullptr };
      vtkPolyData* inputs[2] = { vtkPolyData::SafeDownCast(blocks->GetBlock(0)),
        sphere->GetOutput() };
      for (int k = 0; k < 2; ++k)
      {
        single[i]->SetInputData(inputs[k]);
        single[i]->SetLightPosition(x, 4, 5);
        single[i]->Update();
        vtkPolyData* expected = single[i]->GetOutput();
        bool same = found[k] && expected->GetNumberOfCells() > 0 &&
          found[k]->GetNumberOfCells() == expected->GetNumberOfCells() &&
          found[k]->GetNumberOfPoints() == expected->GetNumberOfPoints();
        for (vtkIdType p = 0; same && p < expected->GetNumberOfPoints(); ++p)
        {
          Position a;
          Position b;
          found[k]->GetPoint(p, a.data());
          expected->GetPoint(p, b.data());
          same = a == b;
        }
        Check(same, Text("block ", k, " as alone, light at ", x));
      }
    }
  }
}
}

//------------------------------------------------------------------------------
int TestSilhouetteEdgesPipeline(int, char*[])
{
  TestProgressAndAbort();
  TestComposite();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
