// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPolyDataMapper from frame to frame: what changes shows, shaders are rebuilt only
// where their text changes, a vtkAirlightPass wins and shows the same, and windows and picking do
// no harm.

#include "AirlightTestMapper.h"
#include "AirlightTestSurfaces.h"

#include "vtkHardwareSelector.h"
#include "vtkObjectFactory.h"
#include "vtkSelection.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
// Counts how often shaders are made.
class CountingMapper : public vtkAirlightPolyDataMapper
{
public:
  static CountingMapper* New();
  vtkTypeMacro(CountingMapper, vtkAirlightPolyDataMapper);
  int Builds = 0;

protected:
  void ReplaceShaderRenderPass(std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer,
    vtkActor* actor, bool prePass) override
  {
    this->Builds += prePass ? 0 : 1;
    this->Superclass::ReplaceShaderRenderPass(shaders, renderer, actor, prePass);
  }
};
vtkStandardNewMacro(CountingMapper);

//------------------------------------------------------------------------------
struct Step
{
  std::string What;
  bool Builds; // rebuilds shaders
  std::function<void(MapperScene&)> Do;
};

void TestRebuilds(Comparison& comparison)
{
  MapperScene scene;
  vtkLight* light = scene.AddPointLight({ 1.0, 0.5, 1.0 }, { 40.0, 30.0, 20.0 });
  scene.Add(MakePlane(1));
  vtkNew<CountingMapper> mapper;
  mapper->SetInputData(vtkPolyData::SafeDownCast(scene.Mapper->GetInput()));
  mapper->SetMedium(scene.Medium);
  scene.Actor->SetMapper(mapper);
  scene.Mapper = mapper;

  const Step steps[] = {
    { "first frame", true, [](MapperScene&) {} },
    { "nothing", false, [](MapperScene&) {} },
    { "denser", false, [](MapperScene& s) { s.Medium->SetScattering(0.1, 0.1, 0.1); } },
    { "ambient", false, [](MapperScene& s) { s.Medium->SetAmbientRadiance(0.5, 0.4, 0.1); } },
    { "sky", true, [](MapperScene& s) { s.Medium->SetSkyRadiance(0.3, 0.6, 0.9); } },
    { "ground", false, [](MapperScene& s) { s.Medium->SetGroundRadiance(0.2, 0.1, 0.0); } },
    { "light moves", false, [&](MapperScene&) { light->SetPosition(-1.0, 0.4, 0.9); } },
    { "light dims", false, [&](MapperScene&) { light->SetIntensity(0.3); } },
    { "camera", false, [](MapperScene& s) { s.Renderer->GetActiveCamera()->Azimuth(10.0); } },
    { "actor", false,
      [](MapperScene& s) {
        s.Actor->SetPosition(0.1, 0.2, 0.3);
        s.Triangles =
          GetTriangles(vtkPolyData::SafeDownCast(s.Mapper->GetInput()), s.Actor->GetMatrix());
      } },
    { "second light", false,
      [](MapperScene& s) {
        s.AddPointLight({ 0.0, 2.0, 2.0 }, glm::dvec3(9.0));
      } },
    { "phase function of another number of poles", true,
      [](MapperScene& s) {
        s.Medium->SetPhaseFunctionToSchlick();
        s.Medium->SetAnisotropy(0.5);
      } },
    { "anisotropy", false, [](MapperScene& s) { s.Medium->SetAnisotropy(0.4); } },
    { "box around the lights: another kind of region", true,
      [](MapperScene& s) {
        s.Medium->SetBounds(-6, 6, -6, 6, -6, 6);
        s.Medium->SetRegionToBox();
      } },
    { "box beside the lights: quadrature", true,
      [](MapperScene& s) { s.Medium->SetBounds(-6, 6, -6, 0, -6, 6); } },
    { "another such box", false,
      [](MapperScene& s) { s.Medium->SetBounds(-6, 6, -5, 0.1, -6, 6); } },
    { "lights of two kinds", true,
      [&](MapperScene& s) {
        s.Medium->SetRegionToUnbounded();
        light->SetAttenuationValues(1.0, 0.1, 0.02);
      } },
    { "nine lights", true,
      [](MapperScene& s) {
        for (int k = 0; k < 7; ++k)
        {
          s.AddPointLight({ k - 3.0, 1.0, 1.5 }, glm::dvec3(1.0 + k));
        }
      } },
    { "no light", true, [](MapperScene& s) { s.Renderer->RemoveAllLights(); } },
    { "no medium and back", true,
      [](MapperScene& s) {
        s.Mapper->RemoveAllMedia();
        s.Render();
        s.Mapper->SetMedium(s.Medium);
      } },
  };
  for (const Step& step : steps)
  {
    step.Do(scene);
    const int before = mapper->Builds;
    scene.Compare(step.What, scene.GetSamples(), 1e-3, comparison);
    std::cout << step.What << ": " << mapper->Builds - before << " builds\n";
    Check((mapper->Builds > before) == step.Builds,
      step.What + (step.Builds ? ": shaders are rebuilt" : ": shaders stay"));
  }
}

//------------------------------------------------------------------------------
// Two media in one place and one twice as dense; none and VTK's own mapper.
void TestMedia(Comparison& comparison)
{
  MapperScene scene;
  scene.AddPointLight({ 1.0, 0.5, 1.0 }, { 40.0, 30.0, 20.0 });
  scene.Add(MakePlane(1));
  vtkNew<vtkParticipatingMedium> half;
  half->SetScattering(0.05, 0.07, 0.1);
  half->SetAbsorption(0.02, 0.02, 0.01);
  half->SetAmbientRadiance(0.1, 0.2, 0.3);
  scene.Mapper->SetMedium(half);
  scene.Mapper->AddMedium(half);
  Check(scene.Mapper->GetNumberOfMedia() == 1, "a medium is taken once");
  vtkNew<vtkParticipatingMedium> other;
  other->SetScattering(0.05, 0.07, 0.1);
  other->SetAbsorption(0.02, 0.02, 0.01);
  other->SetAmbientRadiance(0.1, 0.2, 0.3);
  scene.Mapper->AddMedium(other);
  scene.Medium->SetScattering(0.1, 0.14, 0.2); // what the comparison expects
  scene.Medium->SetAbsorption(0.04, 0.04, 0.02);
  scene.Compare("two media", scene.GetSamples(), 1e-3, comparison);

  scene.Mapper->RemoveMedium(half);
  scene.Mapper->SetMedium(nullptr);
  Check(scene.Mapper->GetNumberOfMedia() == 0, "SetMedium(nullptr) removes all");
  const FloatPicture without = scene.Render();
  vtkNew<vtkPolyDataMapper> plain;
  plain->SetInputData(vtkPolyData::SafeDownCast(scene.Mapper->GetInput()));
  vtkSmartPointer<vtkMapper> mapper = scene.Mapper;
  scene.Actor->SetMapper(plain);
  Check(scene.Render() == without, "without media the surface is VTK's own");
}

//------------------------------------------------------------------------------
// A lit sphere alone: the pass without shadows shows the same, and the mapper adds nothing to it.
void TestPass(Comparison& comparison)
{
  MapperScene scene;
  scene.AddPointLight({ 3.0, 3.0, 4.0 }, { 40.0, 30.0, 20.0 });
  scene.AddPointLight({ -3.0, 1.0, 4.0 }, { 10.0, 20.0, 20.0 })->SetAttenuationValues(0.5, 0, 0.1);
  scene.Medium->SetPhaseFunctionToHenyeyGreenstein();
  scene.Medium->SetAnisotropy(0.5);
  vtkNew<vtkParticipatingMedium> ball;
  ball->SetRegionToSphere();
  ball->SetCenter(1.0, 0.0, 2.0);
  ball->SetRadius(1.5);
  scene.Add(MakeSphere(2.0))->GetProperty()->LightingOn();
  scene.Mapper->AddMedium(ball);
  scene.Pass->AddMedium(ball);
  scene.Pass->SetShadowTechniqueToNone();
  scene.Steps->SetTranslucentPass(nullptr);
  const FloatPicture own = scene.Render();

  scene.Renderer->SetPass(scene.Pass);
  scene.Window->Render();
  for (const MapperSample& sample : scene.GetSamples())
  {
    const float* rgb = scene.GetPixel("Radiance", sample.I, sample.J);
    MapperScene::CompareColour(
      "pass and mapper", sample, own, glm::dvec3(rgb[0], rgb[1], rgb[2]), 1e-3, comparison);
  }
  const Picture both = Capture(scene.Window);
  vtkSmartPointer<vtkMapper> mapper = scene.Mapper;
  vtkNew<vtkPolyDataMapper> plain;
  plain->SetInputData(vtkPolyData::SafeDownCast(scene.Mapper->GetInput()));
  scene.Actor->SetMapper(plain);
  Check(Capture(scene.Window) == both, "under a pass nothing is fogged twice");
  scene.Actor->SetMapper(mapper);
  scene.Renderer->SetPass(scene.Framebuffer);
  Check(scene.Render() == own, "without the pass the mapper does it again");
}

//------------------------------------------------------------------------------
// A medium whose surface lies on the graphics card, in two windows by turns; picking; a copy.
void TestWindows()
{
  MapperScene scene;
  MapperScene other;
  scene.AddPointLight({ 0.0, 0.5, 1.0 }, { 40.0, 30.0, 20.0 });
  other.AddPointLight({ 0.0, 0.5, 1.0 }, { 40.0, 30.0, 20.0 });
  scene.Medium->SetSurface(MakeBoxMesh({ -3.0, 3.0, -2.0, 2.0, -2.0, 3.0 }));
  scene.Medium->SetRegionToSurface();
  scene.Add(MakePlane(1));
  other.Renderer->AddActor(scene.Actor);
  const FloatPicture first = scene.Render();
  for (int turn = 0; turn < 2; ++turn)
  {
    Check(other.Render() == first, "the same in another window");
    Check(scene.Render() == first, "the same in the first one again");
  }

  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(scene.Renderer);
  selector->SetArea(32, 24, 32, 24);
  scene.Renderer->SetPass(nullptr);
  auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  Check(selection && selection->GetNumberOfNodes() == 1, "the actor is picked");
  scene.Renderer->SetPass(scene.Framebuffer);
  Check(scene.Render() == first, "the same after picking");

  vtkNew<vtkAirlightPolyDataMapper> copy;
  copy->ShallowCopy(scene.Mapper);
  vtkSmartPointer<vtkMapper> mapper = scene.Mapper;
  scene.Actor->SetMapper(copy);
  Check(scene.Render() == first, "a shallow copy draws the same");
  other.Renderer->RemoveActor(scene.Actor);
}
}

//------------------------------------------------------------------------------
int TestAirlightPolyDataMapperUpdates(int, char*[])
{
  Comparison rebuilds("what changes shows");
  Comparison media("two media");
  Comparison pass("the pass and the mapper, relative");
  TestRebuilds(rebuilds);
  TestMedia(media);
  TestPass(pass);
  TestWindows();
  const bool ok = AllOk({ &rebuilds, &media, &pass });
  return ok && Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
