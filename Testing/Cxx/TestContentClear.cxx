// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Every kind of content through vtkAirlightPass with a clear medium: VTK's own picture.

#include "AirlightTestContentOthers.h"
#include "AirlightTestContentSurfaces.h"

#include "vtkSSAOPass.h"

#include <cstdlib>

using namespace airlighttest;

namespace
{
struct Content
{
  const char* Name;
  std::function<void(Theatre&)> Add;
  int Limit = 1; // of the difference, in steps of 1/255
};

// VTK blends splats and volumes into 8 bits: each of the layers, or the one colour and opacity that
// they add up to, is rounded, and so is what it is blended with. The pass blends in single precision
// and rounds once. Measured: 3 for splats that lie over each other, 2 for the others.
constexpr int ManyLayers = 3;
constexpr int OneLayer = 2;

const std::vector<Content> Contents = {
  { "shadings and representations", AddShadings },
  { "vertices and edges", AddVertices },
  { "lines and tubes", AddLines },
  { "points", [](Theatre& t) { AddPoints(t, false); } },
  { "points as spheres", [](Theatre& t) { AddPoints(t, true); } },
  { "clipping, culling, back faces", AddBackfaces },
  { "unlit", AddUnlit },
  { "physically based", [](Theatre& t) { AddPhysical(t, false); } },
  { "physically based, environment", [](Theatre& t) { AddPhysical(t, true); } },
  { "texture", [](Theatre& t) { AddTexture(t, 3); } },
  { "translucent texture", [](Theatre& t) { AddTexture(t, 4); } },
  { "scalars", AddScalars },
  { "translucent", AddTranslucent },
  { "translucent, peeled",
    [](Theatre& t) {
      AddTranslucent(t);
      t.Renderer->UseDepthPeelingOn();
    } },
  { "composite", AddComposite },
  { "glyphs", [](Theatre& t) { AddGlyphs(t, 1.0); } },
  { "translucent glyphs", [](Theatre& t) { AddGlyphs(t, 0.5); } },
  { "point gaussians", [](Theatre& t) { AddGaussians(t, false, 1.0); }, ManyLayers },
  { "translucent point gaussians", [](Theatre& t) { AddGaussians(t, false, 0.5); }, OneLayer },
  { "emissive point gaussians", [](Theatre& t) { AddGaussians(t, true, 1.0); }, ManyLayers },
  // Order-independent translucency makes emissive splats of less than full opacity disappear, in
  // VTK itself; so they are peeled.
  { "emissive point gaussians, peeled",
    [](Theatre& t) {
      AddGaussians(t, true, 0.5);
      t.Renderer->UseDepthPeelingOn();
    } },
  { "volume, smart", [](Theatre& t) { AddVolume<vtkSmartVolumeMapper>(t, false); }, OneLayer },
  { "volume, graphics card", [](Theatre& t) { AddVolume<vtkGPUVolumeRayCastMapper>(t, true); },
    OneLayer },
  { "volume, fixed point", [](Theatre& t) { AddVolume<vtkFixedPointVolumeRayCastMapper>(t, true); },
    OneLayer },
  { "volume and translucent surfaces, peeled",
    [](Theatre& t) {
      AddVolume<vtkGPUVolumeRayCastMapper>(t, false);
      AddTranslucent(t);
      t.Renderer->UseDepthPeelingOn();
      t.Renderer->UseDepthPeelingForVolumesOn();
    } },
  { "assemblies", AddAssemblies },
  { "followers, billboards", AddFollowers },
  { "annotations", AddAnnotations },
  { "axes", AddAxes },
  { "skybox", AddSkybox },
  { "gradient background", AddGradient },
  { "textured background", AddTexturedBackground },
  { "parallel projection",
    [](Theatre& t) {
      AddTranslucent(t);
      t.Renderer->GetActiveCamera()->ParallelProjectionOn();
      t.Renderer->GetActiveCamera()->SetParallelScale(2.0);
    } },
  { "antialiasing",
    [](Theatre& t) {
      AddTranslucent(t);
      t.Renderer->UseFXAAOn();
    } },
  { "ambient occlusion",
    [](Theatre& t) {
      AddShadings(t);
      t.Renderer->UseSSAOOn();
      t.Renderer->SetSSAORadius(0.5);
    } },
  { "hidden lines removed",
    [](Theatre& t) {
      AddShadings(t);
      t.Add(MakeSphere(1.2), 0.0, 0.0, -2.0)->GetProperty()->SetRepresentationToWireframe();
      t.Renderer->UseHiddenLineRemovalOn();
    } },
};

// Pixels whose difference is above this many steps of 1/255.
int CountAbove(const Picture& a, const Picture& b, int limit)
{
  int count = 0;
  for (size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    count += std::abs(a[i] - b[i]) > limit ? 1 : 0;
  }
  return count;
}

bool ShowsSomething(Theatre& theatre, const Picture& picture)
{
  vtkPropCollection* props = theatre.Renderer->GetViewProps();
  vtkCollectionSimpleIterator it = nullptr;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    prop->VisibilityOff();
  }
  return CountAbove(picture, Capture(theatre.Window), 10) > 100;
}

void CheckClear(Theatre& theatre, const Content& content)
{
  theatre.Open();
  theatre.AddLamp();
  theatre.Pass->SurfaceShadowsOff();
  content.Add(theatre);
  const Picture plain = Capture(theatre.Window);
  theatre.Renderer->SetPass(theatre.Pass);
  const Picture clear = Capture(theatre.Window);
  const int difference = Compare(plain, clear);
  std::cout << content.Name << ": differs by " << difference << " in "
            << CountAbove(plain, clear, 1) << " values\n";
  Check(difference <= content.Limit, std::string(content.Name) + ": the picture is VTK's");
  Check(
    ShowsSomething(theatre, plain), std::string(content.Name) + ": the picture shows something");
}
}

//------------------------------------------------------------------------------
int TestContentClear(int, char*[])
{
  Theatre theatre;
  theatre.Medium->SetScattering(0.0, 0.0, 0.0);
  theatre.Medium->SetAbsorption(0.0, 0.0, 0.0);
  for (const Content& content : Contents)
  {
    CheckClear(theatre, content);
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
