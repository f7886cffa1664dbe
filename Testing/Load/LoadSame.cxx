// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The same scene gives the same bytes: drawn again, with its actors in another order, on more
// threads, in another process.

#include "LoadTools.h"

#include "AirlightTestBodies.h"

#include "vtkActorCollection.h"
#include "vtkSMPTools.h"

#include <cstdio>
#include <cstdlib>
#include <map>
#include <thread>

using namespace airlight_test;

namespace airlightload
{
namespace
{
const char* const Names[] = { "point", "spot", "sun", "lights", "glass", "comb", "cloud" };

void Aim(vtkLight* light)
{
  light->SetPositional(true);
  light->SetFocalPoint(0.0, -0.5, 0.0);
  light->SetConeAngle(30.0);
}

// Sheets one behind the other: lists longer than a pixel's slots.
void AddComb(Scene& scene)
{
  for (int i = 0; i < 24; ++i)
  {
    const double z = 0.2 * i - 3.0;
    scene.Add(MakeSheet({ -0.5, 1.3, z }, { 1.0, 0.1, 0.05 }, { 0.0, 1.0, 0.02 }));
  }
}

// Glass of three thicknesses before and behind each other, none of which touch.
void AddPanes(Scene& scene)
{
  for (int i = 0; i < 3; ++i)
  {
    const double z = 1.0 + 0.6 * i;
    AddGlass(scene, MakeSheet({ -1.0, -1.5, z }, { 2.0, 0.2, 0.1 }, { 0.1, 2.0, 0.1 }),
      glm::dvec3(0.2 + 0.2 * i, 0.5, 0.7));
  }
}

// An image of density, whose light is found on the processor, by threads.
void AddCloud(Scene& scene)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(24, 20, 16);
  image->SetSpacing(0.3, 0.3, 0.3);
  image->SetOrigin(-3.5, -2.0, -2.4);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  for (int i = 0; i < 24 * 20 * 16; ++i)
  {
    values[i] = static_cast<float>(0.5 + 0.5 * std::sin(0.7 * i) * std::cos(0.03 * i));
  }
  scene.Medium->SetDensityToImage();
  scene.Medium->SetDensityImage(image);
}

void Fill(WindowScene& scene, const std::string& name)
{
  if (name == "spot")
  {
    Aim(scene.Lights[0]);
  }
  else if (name == "sun")
  {
    scene.Renderer->RemoveAllLights();
    scene.AddDirectionalLight({ 2.0, 3.0, 1.0 });
  }
  else if (name == "lights")
  {
    for (int k = 0; k < 10; ++k)
    {
      vtkLight* light =
        scene.AddPointLight({ 4.0 * std::sin(k), 3.0 + 0.1 * k, 4.0 * std::cos(k) }, { 3, 5, 7 });
      if (k % 3 == 0)
      {
        Aim(light);
      }
    }
  }
  else if (name == "glass")
  {
    AddPanes(scene);
  }
  else if (name == "comb")
  {
    AddComb(scene);
  }
  else if (name == "cloud")
  {
    AddCloud(scene);
  }
}

// Of all buffers and of the picture, with buffers and without: the latter is drawn by other
// shaders.
std::string TakeDigest(WindowScene& scene)
{
  Digest digest;
  scene.Pass->RecordBuffersOn();
  digest.Add(Capture(scene.Window));
  for (const auto& buffer : scene.CopyBuffers())
  {
    digest.Add(buffer.second);
  }
  scene.Pass->RecordBuffersOff();
  const Picture picture = Capture(scene.Window);
  Check(ShowsScene(picture), "something is seen");
  digest.Add(picture);
  return digest.GetText();
}

// In reverse. Glass stays in its order, which is that of blending.
void ReorderActors(WindowScene& scene)
{
  std::vector<vtkSmartPointer<vtkActor>> solid;
  std::vector<vtkSmartPointer<vtkActor>> glass;
  vtkActorCollection* actors = scene.Renderer->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor())
  {
    if (actor->GetProperty()->GetOpacity() < 1.0)
    {
      glass.emplace_back(actor);
    }
    else
    {
      solid.emplace_back(actor);
    }
  }
  scene.Renderer->RemoveAllViewProps();
  for (const auto& actor : glass)
  {
    scene.Renderer->AddActor(actor);
  }
  std::for_each(solid.rbegin(), solid.rend(), [&](vtkActor* a) { scene.Renderer->AddActor(a); });
}

void CheckEqual(const std::string& expected, const std::string& found, const std::string& what)
{
  Check(expected == found, what + ": " + found + ", not " + expected);
}

void CheckScene(const std::string& name)
{
  WindowScene scene(96, 72, 1);
  Fill(scene, name);
  if (name == "comb")
  {
    scene.Window->Render();
    Check(scene.GetBuffer("BoundaryCount")->GetScalarRange()[1] > 32.0, "there are long lists");
  }
  const std::string digest = TakeDigest(scene);
  CheckEqual(digest, TakeDigest(scene), name + ", once more");
  scene.Pass->ReleaseGraphicsResources(scene.Window);
  CheckEqual(digest, TakeDigest(scene), name + ", everything made again");
  ReorderActors(scene);
  CheckEqual(digest, TakeDigest(scene), name + ", actors in another order");
  std::cout << name << " " << digest << std::endl;
}
}

//------------------------------------------------------------------------------
void RunDigests(const Options& options)
{
  const char* threads = std::getenv("VTK_SMP_MAX_THREADS");
  std::cerr << "vtkSMPTools: " << vtkSMPTools::GetBackend() << ", "
            << vtkSMPTools::GetEstimatedNumberOfThreads() << " threads\n";
  const int cores = static_cast<int>(std::thread::hardware_concurrency());
  Check(
    !threads || std::min(std::atoi(threads), cores) == vtkSMPTools::GetEstimatedNumberOfThreads(),
    "as many threads as were requested");
  for (const char* name : Names)
  {
    if (options.Scene.empty() || options.Scene == name)
    {
      CheckScene(name);
    }
  }
}

//------------------------------------------------------------------------------
namespace
{
using Digests = std::map<std::string, std::string>;

// In another process, with these variables of its environment.
Digests Call(const std::string& program, const std::string& variables, const std::string& scene)
{
  const std::string command =
    variables + " '" + program + "' digests" + (scene.empty() ? "" : " --scene " + scene);
  Digests digests;
  FILE* pipe = popen(command.c_str(), "r");
  if (!Check(pipe != nullptr, "a process begins: " + command))
  {
    return digests;
  }
  char name[64];
  char digest[64];
  while (std::fscanf(pipe, "%63s %63s", name, digest) == 2)
  {
    digests[name] = digest;
  }
  Check(pclose(pipe) == 0, command + " finds the same bytes in its own process");
  return digests;
}
}

//------------------------------------------------------------------------------
// LP_NUM_THREADS is that of Mesa's software renderer, VTK_SMP_MAX_THREADS that of VTK's filters,
// which takes no more than there are processors.
void RunProcesses(const Options& options, const std::string& program)
{
  const char* const runs[] = { "LP_NUM_THREADS=0 VTK_SMP_BACKEND_IN_USE=Sequential",
    "LP_NUM_THREADS=1 VTK_SMP_BACKEND_IN_USE=STDThread VTK_SMP_MAX_THREADS=1",
    "LP_NUM_THREADS=5 VTK_SMP_BACKEND_IN_USE=STDThread VTK_SMP_MAX_THREADS=99" };
  const Digests first = Call(program, runs[0], options.Scene);
  const size_t expected = options.Scene.empty() ? std::size(Names) : 1;
  Check(first.size() == expected, "all scenes are there");
  for (const char* run : runs)
  {
    const Digests digests = run == runs[0] ? first : Call(program, run, options.Scene);
    std::cout << run << ":\n";
    for (const auto& [name, digest] : first)
    {
      const auto it = digests.find(name);
      const std::string found = it == digests.end() ? "nothing" : it->second;
      std::cout << "  " << name << " " << found << "\n";
      CheckEqual(digest, found, std::string(run) + ", " + name);
    }
  }
}
}
