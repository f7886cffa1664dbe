// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Contents through vtkAirlightPass with a clear medium: VTK's own picture. Opaque contents,
// volumes, annotations and backgrounds, and the renderer's options; or, with the argument
// "translucent", what is blended with what lies behind.

#include "AirlightTestContent.h"

#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkSmartVolumeMapper.h"

#include <cstdlib>
#include <string>

using namespace airlight_test;

namespace
{
struct Content
{
  const char* Name;
  std::function<void(Scene&)> Add;
  int Limit = 1; // of the difference, in steps of 1/255
};

// VTK blends splats and volumes into 8 bits: each of the layers, or the one colour and opacity that
// they add up to, is rounded, and so is what it is blended with. The pass blends in single
// precision and rounds once, where it does not leave the picture to VTK altogether. Measured: 3 for
// splats that lie over each other, 2 for the others.
constexpr int ManyLayers = 3;
constexpr int OneLayer = 2;

//------------------------------------------------------------------------------
bool ShowsSomething(Scene& scene, const Picture& picture)
{
  vtkPropCollection* props = scene.Renderer->GetViewProps();
  vtkCollectionSimpleIterator it = nullptr;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    prop->VisibilityOff();
  }
  return CountApart(picture, Capture(scene.Window), 10) > 100;
}

void CheckClear(Scene& scene, const Content& content)
{
  Open(scene);
  AddLamp(scene);
  scene.Pass->SurfaceShadowsOff();
  content.Add(scene);
  const Picture plain = Capture(scene.Window);
  scene.Renderer->SetPass(scene.Pass);
  const Picture clear = Capture(scene.Window);
  Check(Compare(plain, clear) == 0, std::string(content.Name) + ": VTK draws the picture");
  // All steps are taken where buffers are recorded.
  scene.Pass->RecordBuffersOn();
  const Picture recorded = Capture(scene.Window);
  const int difference = Compare(plain, recorded);
  std::cout << content.Name << ": differs by " << difference << " in "
            << CountApart(plain, recorded, 1) << " values\n";
  Check(difference <= content.Limit, std::string(content.Name) + ": the picture is VTK's");
  Check(ShowsSomething(scene, plain), std::string(content.Name) + ": the picture shows something");
}

//------------------------------------------------------------------------------
// The exit status.
int CheckAllClear(const std::vector<Content>& contents)
{
  Scene scene(120, 90);
  scene.Window->SetAlphaBitPlanes(1);
  scene.Medium->SetScattering(0.0, 0.0, 0.0);
  scene.Medium->SetAbsorption(0.0, 0.0, 0.0);
  for (const Content& content : contents)
  {
    CheckClear(scene, content);
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

//------------------------------------------------------------------------------
const std::vector<Content> Opaque = {
  { "shadings and representations", AddShadings },
  { "vertices and edges", AddVertices },
  { "lines and tubes", AddLines },
  { "points", [](Scene& t) { AddPoints(t, false); } },
  { "points as spheres", [](Scene& t) { AddPoints(t, true); } },
  { "clipping, culling, back faces", AddBackfaces },
  { "unlit", AddUnlit },
  { "physically based", [](Scene& t) { AddPhysical(t, false); } },
  { "physically based, environment", [](Scene& t) { AddPhysical(t, true); } },
  { "texture", [](Scene& t) { AddTexture(t, 3); } },
  { "scalars", AddScalars },
  { "glyphs", [](Scene& t) { AddGlyphs(t, 1.0); } },
  { "volume, smart", [](Scene& t) { AddVolume<vtkSmartVolumeMapper>(t, false); }, OneLayer },
  { "volume, graphics card", [](Scene& t) { AddVolume<vtkGPUVolumeRayCastMapper>(t, true); },
    OneLayer },
  { "volume, fixed point", [](Scene& t) { AddVolume<vtkFixedPointVolumeRayCastMapper>(t, true); },
    OneLayer },
  { "annotations", AddAnnotations },
  { "axes", AddAxes },
  { "skybox", AddSkybox },
  { "gradient background", AddGradient },
  { "textured background", AddTexturedBackground },
  { "ambient occlusion",
    [](Scene& t) {
      AddShadings(t);
      t.Renderer->UseSSAOOn();
      t.Renderer->SetSSAORadius(0.5);
    } },
  { "hidden lines removed",
    [](Scene& t) {
      AddShadings(t);
      AddActor(t, MakeSphere(1.2), { 0.0, 0.0, -2.0 })
        ->GetProperty()
        ->SetRepresentationToWireframe();
      t.Renderer->UseHiddenLineRemovalOn();
    } },
  { "follower", AddFollower },
};

const std::vector<Content> Translucent = {
  { "translucent texture", [](Scene& t) { AddTexture(t, 4); } },
  { "translucent", AddTranslucent },
  { "translucent, peeled",
    [](Scene& t) {
      AddTranslucent(t);
      t.Renderer->UseDepthPeelingOn();
    } },
  { "composite", AddComposite },
  { "translucent glyphs", [](Scene& t) { AddGlyphs(t, 0.5); } },
  { "point gaussians", [](Scene& t) { AddGaussians(t, false, 1.0); }, ManyLayers },
  { "translucent point gaussians", [](Scene& t) { AddGaussians(t, false, 0.5); }, OneLayer },
  { "emissive point gaussians", [](Scene& t) { AddGaussians(t, true, 1.0); }, ManyLayers },
  // Order-independent translucency makes emissive splats of less than full opacity disappear, in
  // VTK itself; so they are peeled.
  { "emissive point gaussians, peeled",
    [](Scene& t) {
      AddGaussians(t, true, 0.5);
      t.Renderer->UseDepthPeelingOn();
    } },
  { "volume and translucent surfaces, peeled",
    [](Scene& t) {
      AddVolume<vtkGPUVolumeRayCastMapper>(t, false);
      AddTranslucent(t);
      t.Renderer->UseDepthPeelingOn();
      t.Renderer->UseDepthPeelingForVolumesOn();
    } },
  { "assemblies", AddAssemblies },
  { "billboard", AddBillboard },
  { "parallel projection",
    [](Scene& t) {
      AddTranslucent(t);
      t.Renderer->GetActiveCamera()->ParallelProjectionOn();
      t.Renderer->GetActiveCamera()->SetParallelScale(2.0);
    } },
  { "antialiasing",
    [](Scene& t) {
      AddTranslucent(t);
      t.Renderer->UseFXAAOn();
    } },
};
}

//------------------------------------------------------------------------------
int TestContentClear(int argc, char* argv[])
{
  const bool translucent = argc > 1 && std::string(argv[1]) == "translucent";
  return CheckAllClear(translucent ? Translucent : Opaque);
}
