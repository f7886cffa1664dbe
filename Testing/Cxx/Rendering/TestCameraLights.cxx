// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Lights that are fixed to the camera light surfaces only, until they are switched on: in the pass,
// in vtkAirlightReference and in vtkAirlightPolyDataMapper.

#include "AirlightTestCompareScene.h"
#include "AirlightTestDensity.h"
#include "AirlightTestErrors.h"
#include "AirlightTestMapper.h"
#include "AirlightTestWindowScene.h"

#include "vtkAirlightReference.h"
#include "vtkLightCollection.h"
#include "vtkLightKit.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <numeric>

using namespace airlight_test;

namespace
{
// Two bodies over a floor, without lights yet.
class Stage : public WindowScene
{
public:
  Stage()
    : WindowScene(60, 45, 0)
  {
    this->Renderer->RemoveAllLights();
    this->Lights.clear();
    this->Reference->SetRenderer(this->Renderer);
    this->Reference->SetSize(60, 45);
    this->Reference->SetMedium(this->Medium);
  }

  std::vector<vtkLight*> GetLights()
  {
    std::vector<vtkLight*> lights;
    for (int k = 0; k < this->Renderer->GetLights()->GetNumberOfItems(); ++k)
    {
      lights.push_back(vtkLight::SafeDownCast(this->Renderer->GetLights()->GetItemAsObject(k)));
    }
    return lights;
  }

  void Switch(bool on)
  {
    for (vtkLight* light : this->GetLights())
    {
      this->Pass->SetLightScatters(light, on);
      this->Reference->SetLightScatters(light, on);
    }
  }

  double GetSum(const char* name)
  {
    vtkImageData* image = this->GetBuffer(name);
    auto* values = static_cast<float*>(image->GetScalarPointer());
    return std::accumulate(
      values, values + image->GetNumberOfPoints() * image->GetNumberOfScalarComponents(), 0.0);
  }

  // Of the reference's array from that of the pass, over the largest value; edges of surfaces,
  // which rasterisation rounds, apart.
  double CompareReference(const char* name)
  {
    this->Reference->Modified();
    this->Reference->Update();
    return CompareWithReference(*this, this->Reference, name);
  }

  vtkNew<vtkAirlightReference> Reference;
};

// A way to get lights that are fixed to the camera.
struct Kind
{
  const char* Name;
  int Count;
  std::function<void(Stage&)> Add;
};

std::vector<Kind> GetKinds()
{
  return { { "the light that a renderer creates", 1,
             [](Stage& stage) { stage.Renderer->AutomaticLightCreationOn(); } },
    { "a positional headlight", 1,
      [](Stage& stage) {
        vtkNew<vtkLight> light;
        light->SetLightTypeToHeadlight();
        light->PositionalOn();
        stage.AddLight(light);
      } },
    { "a camera light", 1,
      [](Stage& stage) {
        vtkNew<vtkLight> light;
        light->SetLightTypeToCameraLight();
        light->SetPosition(0.5, 0.6, 1.0);
        stage.AddLight(light);
      } },
    { "a light kit", 5, [](Stage& stage) {
       vtkNew<vtkLightKit> kit;
       kit->AddLightsToRenderer(stage.Renderer);
       for (vtkLight* light : stage.GetLights())
       {
         stage.Lights.push_back(light); // the kit goes, its lights stay
       }
     } } };
}

//------------------------------------------------------------------------------
// Neither airlight nor shadows, surfaces dimmed by the medium, and one warning.
void TestLeftOut(const Kind& kind)
{
  const std::string name = kind.Name;
  Stage stage;
  kind.Add(stage);
  ErrorListener warnings(stage.Pass, vtkCommand::WarningEvent);
  const Buffers planes = stage.Render();
  Check(warnings.Take() == 1, name + ": one warning");
  Check(warnings.GetText().find(Text(kind.Count, kind.Count == 1 ? " light is" : " lights are",
          " fixed to the camera")) != std::string::npos,
    name + ": the warning counts them");
  Check(warnings.GetText().find("SetScatters(light, true)") != std::string::npos &&
      warnings.GetText().find("add a vtkLight") != std::string::npos,
    name + ": the warning says what to do");
  Check(static_cast<int>(stage.GetLights().size()) == kind.Count, name + ": all are there");
  Check(!stage.Pass->GetLightScatters(stage.GetLights()[0]), name + ": the switch is off");
  Check(stage.GetSum("Airlight") == 0.0, name + ": no airlight");
  Check(stage.GetSum("Surface") > 1.0, name + ": surfaces are lit");
  Check(stage.GetSum("BoundaryCount") == 0.0, name + ": no shadows");
  Check(stage.CompareReference("Surface") < 1e-4, name + ": the reference's surfaces");
  Check(stage.CompareReference("Airlight") == 0.0, name + ": the reference's airlight");

  // As without shadows, whatever scatters.
  stage.Pass->SetShadowTechniqueToNone();
  const Buffers none = stage.Render();
  Check(AreSame(planes.at("Surface"), none.at("Surface")), name + ": no shadows on surfaces");
  stage.Switch(true);
  stage.Window->Render();
  Check(stage.GetSum("Airlight") > 1.0, name + ": airlight when switched on");
  Check(CompareBuffers(none.at("Surface"), stage.GetBuffer("Surface")) < 1e-6,
    name + ": the same surfaces when switched on");
  Check(warnings.Take() == 0, name + ": said once");
}

//------------------------------------------------------------------------------
// Those that are switched on scatter and, but for headlights, cast.
void TestSwitchedOn(const Kind& kind)
{
  const std::string name = kind.Name;
  Stage stage;
  kind.Add(stage);
  if (stage.GetLights().empty())
  {
    stage.Renderer->CreateLight();
  }
  ErrorListener warnings(stage.Pass, vtkCommand::WarningEvent);
  ErrorListener referenceWarnings(stage.Reference, vtkCommand::WarningEvent);
  stage.Switch(true);
  stage.Window->Render();
  Check(stage.GetSum("Airlight") > 1.0, name + ": airlight");
  const auto lights = stage.GetLights();
  const bool casts = std::any_of(
    lights.begin(), lights.end(), [](vtkLight* light) { return light->LightTypeIsCameraLight(); });
  Check((stage.GetSum("BoundaryCount") > 0.0) == casts, name + ": camera lights cast");
  Check(stage.CompareReference("Airlight") < 1e-3, name + ": the reference's airlight");
  Check(stage.CompareReference("Surface") < 1e-3, name + ": the reference's surfaces");
  stage.Switch(false);
  stage.Window->Render();
  Check(stage.GetSum("Airlight") == 0.0, name + ": no airlight when switched off");
  Check(stage.GetSum("BoundaryCount") == 0.0, name + ": no shadows when switched off");
  Check(stage.CompareReference("Surface") < 1e-4, name + ": no shadows in the reference");
  Check(warnings.Take() == 0 && referenceWarnings.Take() == 0, name + ": nothing to say");
}

//------------------------------------------------------------------------------
// Beside lamps: the picture is that which is drawn with records, where each light has its step.
void TestBesideLamps(const std::string& name, int lamps, const std::function<void(Stage&)>& change)
{
  Stage stage;
  for (int k = 0; k < lamps; ++k)
  {
    stage.AddPointLight({ k == 0 ? 3.0 : -3.0, 4.0, 2.0 });
  }
  stage.Pass->RecordBuffersOff();
  change(stage);
  const Picture alone = stage.Show(stage.Pass);
  GetKinds()[3].Add(stage);
  const Picture picture = stage.Show(stage.Pass);
  stage.Pass->RecordBuffersOn();
  const Picture recorded = stage.Show(stage.Pass);
  Check(Compare(picture, alone) > 20, name + ": the kit lights surfaces");
  Check(Compare(picture, recorded) <= 1, name + ": the same picture with records");
}

void TestBesideLamps()
{
  const auto addImage = [](Stage& stage) {
    stage.Medium->SetDensityImage(MakeDensity({ 5, 6, 7 }, { -3, -2, -3 }, { 3, 2, 3 }));
    stage.Medium->SetDensityToImage();
  };
  const auto nothing = [](Stage&) {};
  for (int lamps = 0; lamps < 3; ++lamps)
  {
    TestBesideLamps(Text(lamps, " lamps"), lamps, nothing);
    TestBesideLamps(Text(lamps, " lamps, unbounded"), lamps,
      [](Stage& stage) { stage.Medium->SetRegionToUnbounded(); });
    TestBesideLamps(Text(lamps, " lamps in an image"), lamps, addImage);
  }
  TestBesideLamps("a map", 2, [](Stage& stage) { stage.Pass->SetShadowTechniqueToShadowMap(); });
  TestBesideLamps("no shadows", 2, [](Stage& stage) { stage.Pass->SetShadowTechniqueToNone(); });
  TestBesideLamps("an image without shadows", 1, [&](Stage& stage) {
    addImage(stage);
    stage.Pass->SetShadowTechniqueToNone();
  });
  TestBesideLamps(
    "a translucent ball", 2, [](Stage& stage) { stage.Ball->GetProperty()->SetOpacity(0.5); });
}

//------------------------------------------------------------------------------
void TestMessages()
{
  Stage stage;
  GetKinds()[1].Add(stage);
  vtkLight* lamp = stage.AddPointLight({ 3, 4, 2 });
  ErrorListener warnings(stage.Pass, vtkCommand::WarningEvent);
  ErrorListener referenceWarnings(stage.Reference, vtkCommand::WarningEvent);
  stage.Medium->SetScattering(0.0, 0.0, 0.0);
  stage.Window->Render();
  Check(warnings.Take() == 0, "a medium that only absorbs scatters nothing anyway");
  stage.Medium->SetScattering(0.1, 0.1, 0.1);
  stage.Window->Render();
  Check(warnings.Take() == 1, "one warning");
  Check(warnings.GetText().find("add a vtkLight") == std::string::npos, "there is a light");
  Check(stage.CompareReference("Airlight") < 1e-3, "the lamp's airlight");
  Check(referenceWarnings.Take() == 1 &&
      referenceWarnings.GetText().find("1 light is fixed to the camera") != std::string::npos,
    "the reference says the same");
  stage.CompareReference("Airlight");
  Check(referenceWarnings.Take() == 0, "the reference says it once");

  // The rule follows the light's type as long as nobody sets the light.
  Check(stage.Pass->GetLightScatters(lamp), "a lamp scatters");
  lamp->SetLightTypeToCameraLight();
  Check(!stage.Pass->GetLightScatters(lamp), "a camera light does not");
  stage.Pass->SetLightScatters(lamp, false);
  lamp->SetLightTypeToSceneLight();
  Check(!stage.Pass->GetLightScatters(lamp), "what is set stays");
  // A lamp that is switched off still casts shadows on surfaces.
  stage.Window->Render();
  Check(stage.GetSum("BoundaryCount") > 0.0, "a lamp casts in any case");
}

//------------------------------------------------------------------------------
// An unlit surface of a known colour: it shows C T and ambient light.
void TestMapper()
{
  MapperScene scene;
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-6.0, -6.0, 0.0);
  plane->SetPoint1(6.0, -6.0, 0.0);
  plane->SetPoint2(-6.0, 6.0, 0.0);
  scene.Add(Make(plane));
  vtkNew<vtkLight> light;
  light->SetLightTypeToHeadlight();
  scene.Renderer->AddLight(light);
  ErrorListener warnings(scene.Mapper, vtkCommand::WarningEvent);
  const auto getError = [&](bool scatters) {
    const FloatPicture picture = scene.Render();
    double worst = 0.0;
    for (const MapperSample& sample : scene.GetSamples())
    {
      glm::dvec3 ambient;
      glm::dvec3 transmittance;
      glm::dvec3 airlight(0.0);
      const glm::dvec3 end = sample.Ray.Origin + sample.Depth * sample.Ray.Direction;
      vtkAirlight::Ambient(
        scene.Medium, &sample.Ray.Origin.x, &sample.Ray.Direction.x, sample.Depth, &ambient.x);
      vtkAirlight::Transmittance(scene.Medium, &sample.Ray.Origin.x, &end.x, &transmittance.x);
      if (scatters)
      {
        vtkAirlight::Inscatter(scene.Medium, light, &sample.Ray.Origin.x, &sample.Ray.Direction.x,
          0.0, sample.Depth, &airlight.x);
      }
      const glm::dvec3 expected = scene.Colour * transmittance + ambient + airlight;
      for (int c = 0; c < 3; ++c)
      {
        const float value = picture[4 * (sample.J * MapperScene::Width + sample.I) + c];
        worst = std::max(worst, std::abs(value - expected[c]) / expected[c]);
      }
    }
    return worst;
  };
  Check(getError(false) < 1e-4, Text("mapper, headlight: error ", getError(false)));
  Check(warnings.Take() == 1 &&
      warnings.GetText().find("1 light is fixed to the camera") != std::string::npos,
    "the mapper says so once");
  scene.Mapper->SetLightScatters(light, true);
  Check(getError(true) < 1e-3, Text("mapper, headlight switched on: error ", getError(true)));
  Check(getError(false) > 0.01, "the headlight's airlight is seen");
  vtkNew<vtkAirlightPolyDataMapper> copy;
  copy->ShallowCopy(scene.Mapper);
  Check(copy->GetLightScatters(light), "a copy scatters the light, too");
  ErrorListener errors(scene.Mapper);
  scene.Mapper->SetLightScatters(nullptr, true);
  Check(errors.Take() == 1, "no light is an error");
}
}

//------------------------------------------------------------------------------
int TestCameraLights(int, char*[])
{
  for (const Kind& kind : GetKinds())
  {
    TestLeftOut(kind);
    TestSwitchedOn(kind);
  }
  TestBesideLamps();
  TestMessages();
  TestMapper();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
