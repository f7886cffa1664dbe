// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Casters that a shadow map draws with their mappers, point Gaussians here: the map is drawn again
// when anything changes that they are drawn from, as a pass draws it that knows nothing of the
// frames before.

#include "AirlightTestScene.h"

#include "vtkAssembly.h"
#include "vtkCubeSource.h"
#include "vtkPointGaussianMapper.h"
#include "vtkShaderProperty.h"

#include <functional>
#include <iostream>

using namespace airlight_test;

namespace
{
// Two Gaussians above a floor, in an assembly.
struct GaussianScene : Scene
{
  GaussianScene()
    : Scene(120, 90)
  {
    this->Pass->SetShadowTechniqueToShadowMap();
    this->AddPointLight({ 0.5, 9.0, 0.5 }, glm::dvec3(90.0));
    vtkNew<vtkCubeSource> floor;
    floor->SetBounds(-6, 6, -2.1, -2, -6, 6);
    this->Add(floor);
    this->Points->InsertNextPoint(0.0, 0.0, 0.0);
    this->Points->InsertNextPoint(1.0, 0.3, 0.2);
    vtkNew<vtkPolyData> data;
    data->SetPoints(this->Points);
    this->Mapper->SetInputData(data);
    this->Mapper->SetScaleFactor(0.8);
    this->Actor->SetMapper(this->Mapper);
    this->Assembly->AddPart(this->Actor);
    this->Renderer->AddActor(this->Assembly);
  }

  vtkNew<vtkPoints> Points;
  vtkNew<vtkPointGaussianMapper> Mapper;
  vtkNew<vtkActor> Actor;
  vtkNew<vtkAssembly> Assembly;
};

void TestChange(
  GaussianScene& scene, const std::string& what, const std::function<void(GaussianScene&)>& change)
{
  const Buffers before = scene.Render();
  change(scene);
  const Buffers after = scene.Render();
  scene.Pass->ReleaseGraphicsResources(scene.Window); // which forgets all frames
  const Buffers fresh = scene.Render();
  const double changed = CompareBuffers(before.at("Airlight"), after.at("Airlight"));
  const double wrong = CompareBuffers(fresh, after);
  std::cout << what << ": changes airlight by " << changed << ", off by " << wrong << "\n";
  Check(changed > 1e-3, what + ": the shadow changes");
  Check(wrong == 0.0, what + ": the frame is that of a new pass");
}
}

//------------------------------------------------------------------------------
int TestShadowGaussianUpdates(int, char*[])
{
  GaussianScene scene;
  TestChange(scene, "scale", [](GaussianScene& s) { s.Mapper->SetScaleFactor(0.5); });
  TestChange(scene, "points", [](GaussianScene& s) {
    s.Points->SetPoint(1, -1.0, 0.5, 0.0);
    s.Points->Modified();
  });
  TestChange(scene, "part", [](GaussianScene& s) { s.Actor->AddPosition(0.5, 0.0, 0.0); });
  TestChange(scene, "assembly", [](GaussianScene& s) { s.Assembly->AddPosition(0.0, 0.0, 0.8); });
  TestChange(scene, "shape", [](GaussianScene& s) {
    s.Mapper->SetSplatShaderCode("//VTK::Color::Impl\n"
                                 "if (abs(offsetVCVSOutput.x) > 0.3) { discard; }\n");
  });
  TestChange(scene, "shader", [](GaussianScene& s) {
    s.Actor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Color::Impl", true,
      "//VTK::Color::Impl\nif (offsetVCVSOutput.y > 0.2) { discard; }\n", false);
  });
  TestChange(scene, "visibility", [](GaussianScene& s) { s.Assembly->VisibilityOff(); });
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
