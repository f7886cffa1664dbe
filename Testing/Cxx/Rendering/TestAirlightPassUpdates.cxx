// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPass from frame to frame: whatever changes in the scene, the next frame is the one
// that a fresh pass draws, to the last bit. Also several viewports, and picking through the pass.

#include "AirlightTestScene.h"

#include "vtkCellPicker.h"
#include "vtkCubeSource.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkPropPicker.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"
#include "vtkSphereSource.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
// A triangle strip of four points in a row.
vtkSmartPointer<vtkCellArray> MakeStrip(vtkIdType first)
{
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  const vtkIdType ids[4] = { first, first + 1, first + 2, first + 3 };
  cells->InsertNextCell(4, ids);
  return cells;
}

// Upright, 0.4 wide for each two of six points.
vtkSmartPointer<vtkPolyData> MakeBand()
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 6; ++i)
  {
    points->InsertNextPoint(0.4 * (i / 2), i % 2, 0.0);
  }
  auto band = vtkSmartPointer<vtkPolyData>::New();
  band->SetPoints(points);
  band->SetStrips(MakeStrip(0));
  return band;
}

// A scene whose parts can be changed.
struct Stage : Scene
{
  explicit Stage(int width = 120, int height = 90)
    : Scene(width, height)
  {
    vtkNew<vtkCubeSource> floor;
    floor->SetBounds(-6, 6, -2.1, -2, -6, 6);
    this->Floor = this->Add(floor);
    this->Source->SetRadius(1.0);
    this->Data = Make(this->Source);
    this->Body = this->Add(this->Data);
    this->Add(this->Band, [](vtkActor* actor) { actor->SetPosition(-2.6, 0.5, 1.0); });
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(this->Source->GetOutputPort());
    this->Piped = MakeActor(mapper);
    this->Piped->SetPosition(2.2, 0, 0);
    this->Renderer->AddActor(this->Piped);
    this->Light = this->AddPointLight({ 3, 4, 2 });
    this->SecondLight = this->AddPointLight({ -3, 3, 1 }, { 5, 10, 20 });
  }

  vtkNew<vtkSphereSource> Source;
  vtkSmartPointer<vtkPolyData> Data;
  vtkSmartPointer<vtkPolyData> Band = MakeBand();
  vtkActor* Floor;
  vtkActor* Body;
  vtkSmartPointer<vtkActor> Piped;
  vtkLight* Light;
  vtkLight* SecondLight;
};

//------------------------------------------------------------------------------
// A light that was of each other type is again what it was.
void TestLightTypes()
{
  Stage stage;
  const Buffers before = stage.Render();
  stage.Light->SetConeAngle(25.0);
  const Buffers spot = stage.Render();
  stage.Light->PositionalOff();
  const Buffers sun = stage.Render();
  stage.Light->PositionalOn();
  stage.Light->SetConeAngle(90.0);
  CheckSame(before, stage.Render(), "a light through all types");
  Check(!AreSame(before.at("Surface"), spot.at("Surface")) &&
      !AreSame(spot.at("Surface"), sun.at("Surface")),
    "types of light differ");
}

//------------------------------------------------------------------------------
// Draws, changes, draws; and changes before the first frame.
void CheckUpdate(const std::string& name, const std::function<void(Stage&)>& change)
{
  Stage changed;
  const Buffers before = changed.Render();
  change(changed);
  const Buffers after = changed.Render();
  Stage fresh;
  change(fresh);
  CheckSame(fresh.Render(), after, name);
  Check(!AreSame(before.at("Radiance"), after.at("Radiance")), name + ": the picture changes");
}

void EditPoints(Stage& stage)
{
  vtkPoints* points = stage.Data->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double p[3];
    points->GetPoint(i, p);
    points->SetPoint(i, 0.5 * p[0] - 1.5, 1.5 * p[1], p[2]);
  }
  points->Modified();
  stage.Data->Modified();
}

void TestScene()
{
  CheckUpdate("light moved", [](Stage& s) { s.Light->SetPosition(-1, 5, 1); });
  CheckUpdate("light dimmed", [](Stage& s) { s.Light->SetIntensity(0.5); });
  CheckUpdate(
    "light fades otherwise", [](Stage& s) { s.Light->SetAttenuationValues(1.0, 0.0, 0.01); });
  CheckUpdate("light switched off", [](Stage& s) { s.Light->SwitchOff(); });
  CheckUpdate("light removed", [](Stage& s) { s.Renderer->RemoveLight(s.Light); });
  CheckUpdate("light added", [](Stage& s) { s.AddPointLight({ 0, 3, 3 }, { 5, 5, 5 }); });
  CheckUpdate("light made directional", [](Stage& s) { s.Light->PositionalOff(); });
  CheckUpdate("light made a spot", [](Stage& s) { s.Light->SetConeAngle(25.0); });
  CheckUpdate("lights in another order", [](Stage& s) {
    const vtkSmartPointer<vtkLight> first = s.Light;
    first->PositionalOff();
    s.Renderer->RemoveLight(first);
    s.Renderer->AddLight(first);
  });
  CheckUpdate("actor moved", [](Stage& s) { s.Body->SetPosition(-2, 0.5, 0); });
  CheckUpdate("actor mirrored", [](Stage& s) { s.Body->SetScale(-1, 2, 1); });
  CheckUpdate("actor hidden", [](Stage& s) { s.Body->VisibilityOff(); });
  CheckUpdate("actor removed", [](Stage& s) { s.Renderer->RemoveActor(s.Body); });
  CheckUpdate("actor made translucent", [](Stage& s) { s.Body->GetProperty()->SetOpacity(0.5); });
  CheckUpdate("points edited", EditPoints);
  CheckUpdate("input replaced", [](Stage& s) {
    vtkNew<vtkCubeSource> cube;
    vtkPolyDataMapper::SafeDownCast(s.Body->GetMapper())->SetInputData(Make(cube));
  });
  CheckUpdate("polygons replaced", [](Stage& s) {
    vtkNew<vtkCellArray> cells;
    const vtkIdType ids[3] = { 0, 1, 20 };
    cells->InsertNextCell(3, ids);
    s.Data->SetPolys(cells);
  });
  CheckUpdate("strips replaced", [](Stage& s) { s.Band->SetStrips(MakeStrip(2)); });
  CheckUpdate("source changed", [](Stage& s) { s.Source->SetRadius(0.6); });
  CheckUpdate("camera moved", [](Stage& s) { s.Look({ 3, 2, 9 }, { 0, 0, 0 }); });
  CheckUpdate("camera made parallel", [](Stage& s) {
    s.Renderer->GetActiveCamera()->ParallelProjectionOn();
    s.Renderer->GetActiveCamera()->SetParallelScale(4.0);
  });
}

void TestPassItself()
{
  CheckUpdate("medium changed", [](Stage& s) { s.Medium->SetScattering(0.2, 0.1, 0.1); });
  CheckUpdate("medium removed", [](Stage& s) { s.Pass->RemoveAllMedia(); });
  CheckUpdate("phase function changed", [](Stage& s) {
    s.Medium->SetPhaseFunctionToHenyeyGreenstein();
    s.Medium->SetAnisotropy(0.8);
  });
  CheckUpdate("technique changed", [](Stage& s) { s.Pass->SetShadowTechniqueToNone(); });
  CheckUpdate("light radius changed", [](Stage& s) { s.Pass->SetLightRadius(2.0); });
  CheckUpdate("caster excluded", [](Stage& s) {
    vtkNew<vtkInformation> keys;
    keys->Set(vtkAirlightPass::CASTS_SHADOW(), 0);
    s.Body->SetPropertyKeys(keys);
  });
}

//------------------------------------------------------------------------------
// Changes that are taken back.
void TestThereAndBack()
{
  Stage stage;
  const Buffers first = stage.Render();
  const Picture picture = Capture(stage.Window);
  stage.Renderer->SetPass(nullptr);
  Check(Compare(picture, Capture(stage.Window)) > 10, "without the pass there is no fog");
  stage.Renderer->SetPass(stage.Pass);
  CheckSame(first, stage.Render(), "pass taken away and given back");
  Check(Compare(picture, Capture(stage.Window)) == 0, "pass given back: the same picture");
  stage.Pass->ReleaseGraphicsResources(stage.Window);
  CheckSame(first, stage.Render(), "after ReleaseGraphicsResources()");
  stage.Window->SetSize(77, 130);
  stage.Render();
  stage.Window->SetSize(120, 90);
  CheckSame(first, stage.Render(), "after a change of size");
  stage.Pass->SetShadowTechniqueToNone();
  stage.Light->SetPosition(0, 5, 0);
  stage.Render();
  stage.Pass->SetShadowTechniqueToAutomatic();
  stage.Light->SetPosition(3, 4, 2);
  CheckSame(first, stage.Render(), "shadows switched off and on");
  stage.Light->SwitchOff();
  stage.Render();
  stage.Light->SwitchOn();
  CheckSame(first, stage.Render(), "light switched off and on");
  vtkNew<vtkRenderWindow> other;
  other->SetOffScreenRendering(1);
  other->SetMultiSamples(0);
  other->SetSize(120, 90);
  stage.Window->RemoveRenderer(stage.Renderer);
  other->AddRenderer(stage.Renderer);
  other->Render();
  CheckSame(first, stage.CopyBuffers(), "renderer moved to another window");
}

//------------------------------------------------------------------------------
// Two renderers side by side are two windows; one of them is not at the origin.
void TestViewports()
{
  Stage left;
  Stage right;
  right.Light->SetPosition(-2, 5, 3);
  const Buffers leftBuffers = left.Render();
  const Buffers rightBuffers = right.Render();
  const Picture leftPicture = Capture(left.Window);
  const Picture rightPicture = Capture(right.Window);

  Stage a;
  Stage b;
  b.Light->SetPosition(-2, 5, 3);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(240, 180);
  a.Window->RemoveRenderer(a.Renderer);
  b.Window->RemoveRenderer(b.Renderer);
  window->AddRenderer(a.Renderer);
  window->AddRenderer(b.Renderer);
  a.Renderer->SetViewport(0.0, 0.0, 0.5, 0.5);
  b.Renderer->SetViewport(0.5, 0.5, 1.0, 1.0);
  const Picture both = Capture(window);
  CheckSame(leftBuffers, a.CopyBuffers(), "lower left viewport");
  CheckSame(rightBuffers, b.CopyBuffers(), "upper right viewport");
  const auto cut = [&](int x0, int y0) {
    Picture part;
    for (int y = y0; y < y0 + 90; ++y)
    {
      const auto row = both.begin() + 3 * (240 * y + x0);
      part.insert(part.end(), row, row + 3 * 120);
    }
    return part;
  };
  Check(Compare(cut(0, 0), leftPicture) == 0, "lower left viewport: the same picture");
  Check(Compare(cut(120, 90), rightPicture) == 0, "upper right viewport: the same picture");
}

//------------------------------------------------------------------------------
vtkProp* SelectByHardware(vtkRenderer* renderer, unsigned int x, unsigned int y)
{
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(renderer);
  selector->SetArea(x, y, x, y);
  auto selection = vtk::TakeSmartPointer(selector->Select());
  return selection && selection->GetNumberOfNodes() > 0
    ? vtkProp::SafeDownCast(selection->GetNode(0)->GetProperties()->Get(vtkSelectionNode::PROP()))
    : nullptr;
}

void TestPicking()
{
  Stage stage;
  stage.Window->Render();
  const struct
  {
    int X, Y;
    vtkProp* Expected;
  } spots[] = { { 60, 40, stage.Body }, { 60, 15, stage.Floor }, { 81, 42, stage.Piped },
    { 5, 85, nullptr } };
  for (const auto& spot : spots)
  {
    const std::string at = " at " + std::to_string(spot.X) + ", " + std::to_string(spot.Y);
    for (vtkRenderPass* pass :
      { static_cast<vtkRenderPass*>(nullptr), static_cast<vtkRenderPass*>(stage.Pass) })
    {
      stage.Renderer->SetPass(pass);
      const std::string with = (pass ? " with the pass" : " without the pass") + at;
      Check(SelectByHardware(stage.Renderer, spot.X, spot.Y) == spot.Expected,
        "vtkHardwareSelector" + with);
      vtkNew<vtkPropPicker> props;
      props->Pick(spot.X, spot.Y, 0, stage.Renderer);
      Check(props->GetViewProp() == spot.Expected, "vtkPropPicker" + with);
      vtkNew<vtkCellPicker> cells;
      cells->Pick(spot.X, spot.Y, 0, stage.Renderer);
      Check(cells->GetViewProp() == spot.Expected, "vtkCellPicker" + with);
    }
  }
  const Buffers before = stage.Render();
  SelectByHardware(stage.Renderer, 60, 40);
  CheckSame(before, stage.Render(), "frame after a selection");
}
}

//------------------------------------------------------------------------------
int TestAirlightPassUpdates(int, char*[])
{
  TestScene();
  TestPassItself();
  TestThereAndBack();
  TestLightTypes();
  TestViewports();
  TestPicking();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
