// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Random scenes, drawn by vtkAirlightPass and computed by vtkAirlightReference.
//
//   AirlightRandomScenes --scenes N --first SEED     N scenes from this seed on
//   --open FILE                                      scenes whose seeds are in the file are known to
//                                                    fail, in the number of pixels behind the seed. They may
//                                                    not fail in more. Without other seeds these are drawn
//   --each N                                         the first N of each 50 seeds, which are a group
//   --step K                                         every K-th seed of them: more kinds, as many scenes
//   AirlightRandomScenes --list FILE                 those whose seeds are in the file
//   --faults                                         spoils pixels of each scene that passes, and ends with
//                                                    1 unless nine of ten are reported
//   --verbose                                        says what each scene is
//   --parts MASK                                     draws those parts alone whose bits are 1: to find
//                                                    out which it takes
//   --triangles MASK                                 and of these those triangles alone
//   --print BUFFER                                   writes the pixels' values, and the reference's
//
// Ends with 1 where a scene fails; its seed and what it is are written.

#include "AirlightTestErrors.h"
#include "FaultInjection.h"
#include "RandomScene.h"
#include "RandomSeeds.h"
#include "SceneComparison.h"

#include "vtkActorCollection.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <map>

using namespace airlight_test;

namespace
{
constexpr int Width = 32;
constexpr int Height = 24;
constexpr std::uint64_t All = ~std::uint64_t(0);

struct Options
{
  std::vector<std::uint64_t> Seeds;
  std::map<std::uint64_t, size_t> Open; // how many pixels of a scene are wrong
  bool Verbose = false;
  bool Faults = false;
  std::uint64_t Parts = All;
  std::uint64_t Triangles = All;
  std::string Printed;
};

bool Parse(int argc, char* argv[], Options& options)
{
  std::uint64_t first = 0;
  std::uint64_t count = 0;
  std::uint64_t step = 1;
  std::uint64_t each = GroupSize;
  std::vector<std::uint64_t> openSeeds;
  for (int i = 1; i < argc; ++i)
  {
    const std::string name = argv[i];
    const bool hasValue = i + 1 < argc;
    if (name == "--verbose")
    {
      options.Verbose = true;
    }
    else if (name == "--faults")
    {
      options.Faults = true;
    }
    else if (name == "--scenes" && hasValue)
    {
      count = std::strtoull(argv[++i], nullptr, 10);
    }
    else if (name == "--first" && hasValue)
    {
      first = std::strtoull(argv[++i], nullptr, 10);
    }
    else if (name == "--step" && hasValue)
    {
      step = std::strtoull(argv[++i], nullptr, 10);
    }
    else if (name == "--each" && hasValue)
    {
      each = std::strtoull(argv[++i], nullptr, 10);
    }
    else if (name == "--open" && hasValue)
    {
      if (!ReadOpen(argv[++i], options.Open) || options.Open.empty())
      {
        return false;
      }
    }
    else if (name == "--print" && hasValue)
    {
      options.Printed = argv[++i];
    }
    else if (name == "--triangles" && hasValue)
    {
      options.Triangles = std::strtoull(argv[++i], nullptr, 0);
    }
    else if (name == "--parts" && hasValue)
    {
      options.Parts = std::strtoull(argv[++i], nullptr, 0);
    }
    else if (name != "--list" || !hasValue || !ReadSeeds(argv[++i], options.Seeds) ||
      options.Seeds.empty())
    {
      return false;
    }
  }
  for (std::uint64_t i = 0; i < count; ++i)
  {
    const std::uint64_t seed = first + i * step;
    if (seed % GroupSize < each)
    {
      options.Seeds.push_back(seed);
    }
  }
  for (auto it = options.Open.begin(); options.Seeds.empty() && it != options.Open.end(); ++it)
  {
    openSeeds.push_back(it->first);
  }
  options.Seeds.insert(options.Seeds.end(), openSeeds.begin(), openSeeds.end());
  return !options.Seeds.empty();
}

void HideOthers(vtkRenderer* renderer, std::uint64_t parts)
{
  vtkCollectionSimpleIterator it = nullptr;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    prop->SetVisibility((parts & 1) != 0);
    parts >>= 1;
  }
}

// Of each part the first 64, if its bit is 1.
void HideTriangles(vtkRenderer* renderer, std::uint64_t triangles)
{
  if (triangles == All)
  {
    return;
  }
  vtkCollectionSimpleIterator it = nullptr;
  vtkActorCollection* actors = renderer->GetActors();
  actors->InitTraversal(it);
  while (vtkActor* actor = actors->GetNextActor(it))
  {
    auto* mesh = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
    mesh->BuildCells();
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      if (cell >= 64 || !(triangles >> cell & 1))
      {
        mesh->DeleteCell(cell);
      }
    }
    mesh->RemoveDeletedCells();
  }
}

struct Totals
{
  bool Pass() const { return this->Failed.empty() && this->Wrong <= 0.01 * this->Pixels; }

  std::vector<double> Medians;
  long Pixels = 0;
  long Wrong = 0;
  long Rounded = 0;
  long Outlines = 0;
  long Borders = 0;
  double P99 = 0.0;
  double Largest = 0.0;
  double Leak = 0.0;
  std::vector<std::uint64_t> Failed;

  void Add(std::uint64_t seed, const SceneFigures& figures, bool passes)
  {
    this->Medians.push_back(figures.Median);
    this->Pixels += figures.Pixels;
    this->Wrong += figures.Wrong;
    this->Rounded += figures.Rounded;
    this->Outlines += figures.Outlines;
    this->Borders += figures.Borders;
    this->P99 = std::max(this->P99, figures.P99);
    this->Largest = std::max(this->Largest, figures.Largest);
    this->Leak = std::max(this->Leak, figures.Leak);
    if (!passes)
    {
      this->Failed.push_back(seed);
    }
  }

  void Report()
  {
    if (this->Medians.empty())
    {
      std::cout << "only scenes that are known to fail\n";
      return;
    }
    std::sort(this->Medians.begin(), this->Medians.end());
    std::cout << this->Medians.size() << " scenes, " << this->Pixels << " pixels, " << this->Wrong
              << " at edges or wrong, " << this->Rounded << " of them by rounding, "
              << this->Outlines << " on outlines, " << this->Borders
              << " at borders; scenes' medians: half below "
              << this->Medians[this->Medians.size() / 2] << ", largest " << this->Medians.back()
              << "; 99 % of a scene's pixels below " << this->P99 << ", but for edges all below "
              << this->Largest << "; dark pixels below " << this->Leak << " of the bright ones\n"
              << this->Failed.size() << " scenes fail:";
    for (std::uint64_t seed : this->Failed)
    {
      std::cout << " " << seed;
    }
    std::cout << "\n";
  }
};
}

int main(int argc, char* argv[])
{
  Options options;
  if (!Parse(argc, argv, options))
  {
    std::cerr
      << "usage: " << argv[0]
      << " [--verbose] [--faults] [--scenes N] [--first SEED] [--step K] [--each N] [--parts MASK] "
         "[--triangles MASK] [--print BUFFER] [--list FILE] [--open FILE]\n";
    return EXIT_FAILURE;
  }
  airlight_test::Scene scene(Width, Height);
  scene.Pass->SetShadowTechniqueToShadowPlanes();
  ErrorListener errors(scene.Pass);
  Totals totals;
  FaultInjection faults;
  for (std::uint64_t seed : options.Seeds)
  {
    const std::clock_t start = std::clock();
    const RandomScene random(seed, scene);
    if (options.Verbose)
    {
      std::cout << random.Describe() << "\n" << std::flush;
    }
    HideOthers(scene.Renderer, options.Parts);
    HideTriangles(scene.Renderer, options.Triangles);
    scene.Window->Render();
    const std::clock_t drawn = std::clock();
    SceneComparison comparison(scene, random.GetMedia(), random.HasImage());
    comparison.Print(options.Printed, std::cout);
    const std::clock_t end = std::clock();
    const SceneFigures& figures = comparison.GetFigures();
    const bool quiet = errors.Take() == 0;
    const bool passes = figures.Passes() && quiet;
    const auto known = options.Open.find(seed);
    const bool open = known != options.Open.end() && figures.Improper == 0 && quiet &&
      static_cast<size_t>(figures.Unexplained) <= known->second;
    if (passes && options.Faults)
    {
      faults.Add(comparison, seed);
    }
    if (passes || !open)
    {
      totals.Add(seed, figures, passes);
    }
    if (!passes || options.Verbose)
    {
      std::cout << (passes    ? "ok      "
                       : open ? "open    "
                              : "FAILED  ")
                << "scene " << seed << ": median " << figures.Median << ", p99 " << figures.P99
                << ", largest " << figures.Largest << ", leak " << figures.Leak << ", wrong "
                << figures.Wrong << ", by rounding " << figures.Rounded << ", on outlines "
                << figures.Outlines << ", at borders " << figures.Borders << ", unexplained "
                << figures.Unexplained << ", improper " << figures.Improper << "; drawn in "
                << static_cast<double>(drawn - start) / CLOCKS_PER_SEC << " s, computed in "
                << static_cast<double>(end - drawn) / CLOCKS_PER_SEC << " s\n"
                << figures.Worst << (quiet ? "" : errors.GetText() + "\n");
      if (!passes && !options.Verbose)
      {
        std::cout << random.Describe() << "\n";
      }
      std::cout << std::flush;
    }
  }
  totals.Report();
  scene.Pass->ReleaseGraphicsResources(scene.Window);
  const bool reported = !options.Faults || faults.Report();
  return totals.Pass() && reported ? EXIT_SUCCESS : EXIT_FAILURE;
}
