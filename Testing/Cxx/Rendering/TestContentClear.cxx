// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Opaque contents, volumes, annotations and backgrounds, and the renderer's options, in clear air.

#include "AirlightTestContentClear.h"

using namespace airlighttest;

namespace
{
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
  { "scalars", AddScalars },
  { "glyphs", [](Theatre& t) { AddGlyphs(t, 1.0); } },
  { "volume, smart", [](Theatre& t) { AddVolume<vtkSmartVolumeMapper>(t, false); }, OneLayer },
  { "volume, graphics card", [](Theatre& t) { AddVolume<vtkGPUVolumeRayCastMapper>(t, true); },
    OneLayer },
  { "volume, fixed point", [](Theatre& t) { AddVolume<vtkFixedPointVolumeRayCastMapper>(t, true); },
    OneLayer },
  { "annotations", AddAnnotations },
  { "axes", AddAxes },
  { "skybox", AddSkybox },
  { "gradient background", AddGradient },
  { "textured background", AddTexturedBackground },
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
  { "follower", AddFollower },
};
}

//------------------------------------------------------------------------------
int TestContentClear(int, char*[]) { return CheckAllClear(Contents); }
