// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What is blended with what lies behind, in clear air.

#include "AirlightTestContentClear.h"

using namespace airlighttest;

namespace
{
const std::vector<Content> Contents = {
  { "translucent texture", [](Theatre& t) { AddTexture(t, 4); } },
  { "translucent", AddTranslucent },
  { "translucent, peeled",
    [](Theatre& t) {
      AddTranslucent(t);
      t.Renderer->UseDepthPeelingOn();
    } },
  { "composite", AddComposite },
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
  { "volume and translucent surfaces, peeled",
    [](Theatre& t) {
      AddVolume<vtkGPUVolumeRayCastMapper>(t, false);
      AddTranslucent(t);
      t.Renderer->UseDepthPeelingOn();
      t.Renderer->UseDepthPeelingForVolumesOn();
    } },
  { "assemblies", AddAssemblies },
  { "billboard", AddBillboard },
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
};
}

//------------------------------------------------------------------------------
int TestContentClearTranslucent(int, char*[]) { return CheckAllClear(Contents); }
