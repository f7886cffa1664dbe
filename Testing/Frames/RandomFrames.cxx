// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Frames of random scenes that change.
//
//   AirlightRandomFrames --frames N --first SEED     as many scenes, from this seed on, as have N frames
//   --step K                                         every K-th seed: more kinds, as many frames
//   --list FILE                                      the scenes whose seeds are in the file
//   --open FILE                                      scenes that are known to fail, each with the
//                                                    number of its problems: no more of them
//   --verbose                                        describes each scene
//
// Ends with 1 if a scene fails, and writes its seed and what it is.

#include "FrameChecks.h"
#include "FrameMessages.h"

#include "vtkLogger.h"

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>

using namespace airlight_test;

namespace
{
struct Options
{
  std::vector<std::uint64_t> Seeds;
  std::map<std::uint64_t, size_t> Open;
  std::string Photometry = AIRLIGHT_PHOTOMETRY;
  std::uint64_t First = 0;
  std::uint64_t Step = 1;
  long Frames = 0;
  bool Verbose = false;
};

bool Parse(int argc, char* argv[], Options& options)
{
  for (int i = 1; i < argc; ++i)
  {
    const std::string name = argv[i];
    const char* value = i + 1 < argc ? argv[i + 1] : nullptr;
    if (name == "--verbose")
    {
      options.Verbose = true;
      continue;
    }
    if (!value)
    {
      return false;
    }
    ++i;
    const std::uint64_t number = std::strtoull(value, nullptr, 10);
    if (name == "--frames")
    {
      options.Frames = static_cast<long>(number);
    }
    else if (name == "--first")
    {
      options.First = number;
    }
    else if (name == "--step")
    {
      options.Step = number;
    }
    else if (!(name == "--list" && ReadSeeds(value, options.Seeds)) &&
      !(name == "--open" && ReadOpen(value, options.Open)))
    {
      return false;
    }
  }
  return options.Frames > 0 || !options.Seeds.empty();
}

//------------------------------------------------------------------------------
class Run
{
public:
  explicit Run(const Options& options)
    : Settings(options)
  {
    vtkOutputWindow::SetInstance(this->Messages);
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF); // which would print them, too
  }
  ~Run() { vtkOutputWindow::SetInstance(nullptr); }
  Run(const Run&) = delete;
  void operator=(const Run&) = delete;

  void DrawSeed(std::uint64_t seed);
  void DrawAll();
  bool Report() const;

private:
  FrameRecord DrawHistory(FrameScene& scene, Problems& problems);
  void DrawFresh(std::uint64_t seed, const FrameRecord& expected, Problems& problems);
  FrameRecord DrawLastStep(FrameScene& scene);
  bool DiffersWithoutPass(std::uint64_t seed);
  void AddMessages(const std::string& when, Problems& problems);

  const Options& Settings;
  vtkNew<FrameMessages> Messages;
  FrameStage Stage;
  std::uint64_t Group = ~std::uint64_t(0);
  long Scenes = 0;
  long Frames = 0;
  long Redrawn = 0;
  std::vector<std::uint64_t> Failed;
  std::vector<std::uint64_t> StillOpen;
  std::vector<std::uint64_t> DifferInVTK;
};

//------------------------------------------------------------------------------
void Run::AddMessages(const std::string& when, Problems& problems)
{
  for (const std::string& text : this->Messages->TakeUnexpected())
  {
    problems.push_back(when + ": " + text.substr(0, 600));
  }
}

//------------------------------------------------------------------------------
// All steps, with one pass. Of those before the last one some are not recorded.
FrameRecord Run::DrawHistory(FrameScene& scene, Problems& problems)
{
  this->Stage.Enter(scene);
  FrameRecord frame;
  const int last = scene.GetNumberOfSteps() - 1;
  for (int step = 0; step <= last; ++step)
  {
    if (step > 0)
    {
      this->Stage.Apply(scene, scene.Change(step));
    }
    const bool record = step == last || (scene.GetNumberOfSteps() + step) % 2 == 0;
    frame = this->Stage.Draw(scene, record);
    ++this->Frames;
    Problems found;
    if (record)
    {
      CheckFrame(scene, frame, found);
    }
    this->AddMessages("message", found);
    for (const std::string& problem : found)
    {
      problems.push_back(Text("step ", step, ": ", problem));
    }
  }
  CheckSameFrame("drawn again", frame, this->Stage.Draw(scene, true), FrameRounding(), problems);
  ++this->Redrawn;
  this->Stage.Leave(scene);
  this->AddMessages("afterwards", problems);
  return frame;
}

//------------------------------------------------------------------------------
// The last step alone.
FrameRecord Run::DrawLastStep(FrameScene& scene)
{
  for (int step = 1; step < scene.GetNumberOfSteps(); ++step)
  {
    scene.Change(step);
  }
  this->Stage.Enter(scene);
  ++this->Redrawn;
  return this->Stage.Draw(scene, true);
}

//------------------------------------------------------------------------------
// Whether the picture shows its history where VTK draws it without the pass, too. VTK 9.1's glyphs
// keep colours that their property no longer has, for example; volumes, texts and axes the place
// where they stood.
bool Run::DiffersWithoutPass(std::uint64_t seed)
{
  this->Stage.SetUsesPass(false);
  FrameScene scene(seed, this->Settings.Photometry);
  FrameScene newScene(seed, this->Settings.Photometry);
  this->Stage.Enter(scene);
  FrameRecord old = this->Stage.Draw(scene, false);
  for (int step = 1; step < scene.GetNumberOfSteps(); ++step)
  {
    this->Stage.Apply(scene, scene.Change(step));
    old = this->Stage.Draw(scene, false);
  }
  this->Stage.Leave(scene);
  Problems differences;
  FrameRounding rounding;
  rounding.Levels = 1;
  CheckSameFrame("VTK alone", old, this->DrawLastStep(newScene), rounding, differences);
  this->Stage.Leave(newScene);
  this->Stage.SetUsesPass(true);
  this->Messages->TakeUnexpected(); // they are VTK's own
  return !differences.empty();
}

//------------------------------------------------------------------------------
// The last step alone, with all objects new. Shaders may be those of an earlier step, with more in
// them than this one needs, and vertex buffers scaled by earlier coordinates: so numbers may be
// rounded differently.
void Run::DrawFresh(std::uint64_t seed, const FrameRecord& expected, Problems& problems)
{
  FrameScene scene(seed, this->Settings.Photometry);
  const FrameRecord fresh = this->DrawLastStep(scene);
  FrameRounding rounding;
  rounding.Relative = 1e-6;
  rounding.Blends = scene.MayBlend();
  rounding.Levels = 1;
  Problems differences;
  CheckSameFrame("without history", expected, fresh, rounding, differences);
  const int technique = scene.Pass->GetEffectiveShadowTechnique();
  if (seed % 3 == 0 && technique != vtkAirlightPass::RAY_MARCH)
  {
    scene.Pass->SetShadowTechniqueToNone();
    const FrameRecord lit = this->Stage.Draw(scene, true);
    CheckNotBrighter("than without shadows", fresh, lit, problems);
    scene.Renderer->RemoveAllViewProps();
    CheckNotBrighter("than without surfaces", lit, this->Stage.Draw(scene, true), problems);
    this->Redrawn += 2;
  }
  this->Stage.Leave(scene);
  this->AddMessages("afresh", problems);
  if (!differences.empty() && this->DiffersWithoutPass(seed))
  {
    this->DifferInVTK.push_back(seed);
    return;
  }
  problems.insert(problems.end(), differences.begin(), differences.end());
}

//------------------------------------------------------------------------------
void Run::DrawSeed(std::uint64_t seed)
{
  const auto start = std::chrono::steady_clock::now();
  if (seed / FrameGroupSize != this->Group)
  {
    this->Group = seed / FrameGroupSize;
    this->Stage.Clear();
  }
  Problems problems;
  FrameScene scene(seed, this->Settings.Photometry);
  if (this->Settings.Verbose)
  {
    std::cout << scene.Describe() << "\n" << std::flush;
  }
  const FrameRecord frame = this->DrawHistory(scene, problems);
  this->DrawFresh(seed, frame, problems);
  ++this->Scenes;
  const auto open = this->Settings.Open.find(seed);
  const bool known = open != this->Settings.Open.end() && problems.size() <= open->second;
  if (!problems.empty())
  {
    (known ? this->StillOpen : this->Failed).push_back(seed);
    std::cout << (known ? "open   " : "FAILED ") << scene.Describe() << "\n";
    for (const std::string& problem : problems)
    {
      std::cout << "  " << problem << "\n";
    }
  }
  if (this->Settings.Verbose)
  {
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    std::cout << "  " << (problems.empty() ? "ok" : "not ok") << ", " << time.count() << " s\n";
  }
  std::cout << std::flush;
}

//------------------------------------------------------------------------------
void Run::DrawAll()
{
  for (std::uint64_t seed : this->Settings.Seeds)
  {
    this->DrawSeed(seed);
  }
  for (std::uint64_t seed = this->Settings.First; this->Frames < this->Settings.Frames;
       seed += this->Settings.Step)
  {
    this->DrawSeed(seed);
  }
}

//------------------------------------------------------------------------------
bool Run::Report() const
{
  std::cout << this->Scenes << " scenes, " << this->Frames << " frames, and " << this->Redrawn
            << " drawn again; " << this->DifferInVTK.size()
            << " scenes show their history in VTK alone, too:";
  for (std::uint64_t seed : this->DifferInVTK)
  {
    std::cout << " " << seed;
  }
  std::cout << "; " << this->StillOpen.size() << " scenes are open, " << this->Failed.size()
            << " fail:";
  for (std::uint64_t seed : this->Failed)
  {
    std::cout << " " << seed;
  }
  std::cout << "\n";
  return this->Failed.empty();
}
}

int main(int argc, char* argv[])
{
  Options options;
  if (!Parse(argc, argv, options))
  {
    std::cerr
      << "usage: " << argv[0]
      << " [--verbose] [--frames N] [--first SEED] [--step K] [--list FILE] [--open FILE]\n";
    return EXIT_FAILURE;
  }
  Run run(options);
  run.DrawAll();
  return run.Report() ? EXIT_SUCCESS : EXIT_FAILURE;
}
