// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// VTK's passes as the delegate: in clear air their own picture, in fog what they do to surfaces
// fades with the transmittance, and shadows stay where they are.

#include "AirlightTestComposition.h"

#include "vtkDepthOfFieldPass.h"
#include "vtkEDLShading.h"
#include "vtkGaussianBlurPass.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAAPass.h"
#include "vtkSSAOPass.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
template <typename Inside>
void Drop(Composition& scene, Inside* inside)
{
  scene.Pass->SetDelegatePass(nullptr);
  inside->ReleaseGraphicsResources(scene.Window);
}

//------------------------------------------------------------------------------
// What the pass shows of the scene with this inside it, and without.
void CheckClear(Composition& scene, vtkImageProcessingPass* inside, const std::string& name)
{
  scene.SetClear();
  vtkNew<vtkRenderStepsPass> steps;
  const Picture bare = scene.Show(steps);
  inside->SetDelegatePass(steps);
  const Picture own = scene.Show(inside);
  scene.Pass->SetDelegatePass(inside);
  const int difference = Compare(scene.Show(scene.Pass), own);
  const int effect = CountApart(own, bare, 8);
  std::cout << name << ": differs by " << difference << ", effect in " << effect << " values\n";
  Check(difference <= 1, name + ": in clear air VTK's picture");
  Check(effect > 500, name + ": there is an effect");
  Drop(scene, inside);
}

//------------------------------------------------------------------------------
// The sun alone, which reaches surfaces unattenuated, and ambient light for the fog: what the pass
// inside takes from a surface's radiance is multiplied by the transmittance. Buffers are of single
// precision, and differences of values of about 1 are within 1e-6.
void CheckFades(Composition& scene, vtkImageProcessingPass* inside, const std::string& name)
{
  vtkNew<vtkRenderStepsPass> steps;
  inside->SetDelegatePass(steps);
  scene.Lamp->SwitchOff();
  scene.Medium->SetAmbientRadiance(0.3, 0.4, 0.5);
  Buffers frames[2][2];
  for (const int foggy : { 0, 1 })
  {
    foggy ? scene.SetFoggy() : scene.SetClear();
    for (const int used : { 0, 1 })
    {
      scene.Pass->SetDelegatePass(used ? static_cast<vtkRenderPass*>(inside) : steps);
      scene.Show(scene.Pass);
      frames[foggy][used] = scene.CopyBuffers();
    }
  }
  double largest = 0.0;
  int changed = 0;
  int faded = 0;
  for (int i = 0; i < 3 * scene.Width * scene.Height; ++i)
  {
    const int x = i / 3 % scene.Width;
    const int y = i / 3 / scene.Width;
    const auto get = [&](int foggy, int used, const char* buffer) {
      return GetValue(frames[foggy][used][buffer], x, y, i % 3);
    };
    // Shadows of the surfaces are there in fog alone.
    const double passes = get(1, 0, "Transmittance");
    if (std::abs(get(1, 0, "Surface") - passes * get(0, 0, "Surface")) > 1e-6)
    {
      continue;
    }
    const double own = get(0, 0, "Radiance") - get(0, 1, "Radiance");
    const double error = std::abs(get(1, 0, "Radiance") - get(1, 1, "Radiance") - passes * own);
    largest = error <= largest ? largest : error;
    changed += std::abs(own) > 0.02 ? 1 : 0;
    faded += std::abs(own) > 0.02 && passes < 0.5 ? 1 : 0;
  }
  std::cout << name << ": fades within " << largest << ", " << changed << " values change, "
            << faded << " of them behind much fog\n";
  Check(largest <= 2e-6, name + ": in fog the effect fades with the transmittance");
  Check(changed > 500 && faded > 50, name + ": there is an effect to fade");
  scene.Medium->SetAmbientRadiance(0.0, 0.0, 0.0);
  scene.Lamp->SwitchOn();
  Drop(scene, inside);
}

//------------------------------------------------------------------------------
// A delegate may draw in another size. Shadows on surfaces then move by less than a pixel or are
// blurred: few values change much. Read from the wrong place they would be
// elsewhere altogether.
template <typename Inside>
void CheckShadows(Composition& scene, Inside* inside, const std::string& name)
{
  scene.SetFoggy();
  const Picture own = scene.Show(scene.Pass);
  vtkNew<vtkRenderStepsPass> steps;
  inside->SetDelegatePass(steps);
  scene.Pass->SetDelegatePass(inside);
  const double share = static_cast<double>(CountApart(scene.Show(scene.Pass), own, 24)) /
    static_cast<double>(own.size());
  std::cout << name << ": " << 100.0 * share << " % differ\n";
  Check(share < 0.03, name + ": the shadows stay");
  Drop(scene, inside);
}

//------------------------------------------------------------------------------
// The renderer's own SSAO and that of a delegate.
void CheckOcclusion(Composition& scene, vtkSSAOPass* occlusion)
{
  scene.SetFoggy();
  scene.Renderer->UseSSAOOn();
  scene.Renderer->SetSSAORadius(occlusion->GetRadius());
  scene.Renderer->SetSSAOBias(occlusion->GetBias());
  scene.Renderer->SetSSAOKernelSize(occlusion->GetKernelSize());
  const Picture own = scene.Show(scene.Pass);
  scene.Renderer->UseSSAOOff();
  vtkNew<vtkRenderStepsPass> steps;
  occlusion->SetDelegatePass(steps);
  scene.Pass->SetDelegatePass(occlusion);
  Check(Compare(scene.Show(scene.Pass), own) <= 1, "SSAO of the renderer and of a delegate");
  Drop(scene, occlusion);
}
}

//------------------------------------------------------------------------------
int TestCompositionDelegatePasses(int, char*[])
{
  Composition scene;
  vtkNew<vtkSSAOPass> occlusion;
  occlusion->SetRadius(0.6);
  occlusion->SetBias(0.01);
  occlusion->SetKernelSize(32);
  CheckClear(scene, occlusion, "SSAO");
  CheckFades(scene, occlusion, "SSAO");
  CheckOcclusion(scene, occlusion);
  vtkNew<vtkEDLShading> dome;
  CheckClear(scene, dome, "EDL");
  CheckFades(scene, dome, "EDL");
  CheckShadows(scene, vtkNew<vtkSSAAPass>().Get(), "SSAA");
  CheckShadows(scene, vtkNew<vtkGaussianBlurPass>().Get(), "blur");
  vtkNew<vtkDepthOfFieldPass> field;
  scene.Renderer->GetActiveCamera()->SetFocalDisk(0.01);
  CheckShadows(scene, field.Get(), "depth of field");
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
