// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Programs that draw distances alone follow what the mappers' programs are told, come again after a
// release, and are right for all who share a mapper.

#include "AirlightTestDistances.h"

#include "vtkShaderProperty.h"
#include "vtkUniforms.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
//------------------------------------------------------------------------------
// Shaders of the user's that move vertices by a uniform, set by the property or by an observer.
void TestShaders()
{
  const auto move = [](vtkActor* actor, const char* declaration) {
    vtkShaderProperty* shaders = actor->GetShaderProperty();
    shaders->AddVertexShaderReplacement(
      "//VTK::PositionVC::Dec", true, std::string("//VTK::PositionVC::Dec\n") + declaration, false);
    shaders->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true,
      "//VTK::PositionVC::Impl\n  gl_Position.x += moved * gl_Position.w;\n", false);
  };
  const vtkSmartPointer<vtkPolyData> ball = MakeSphere(2.0);
  CompareDistances("a uniform of the property", ball, 1, [&](vtkActor* actor, vtkPolyDataMapper*) {
    move(actor, "");
    actor->GetShaderProperty()->GetVertexCustomUniforms()->SetUniformf("moved", 0.3f);
  });
  CompareDistances(
    "a uniform of an observer", ball, 1, [&](vtkActor* actor, vtkPolyDataMapper* mapper) {
      move(actor, "uniform float moved;\n");
      vtkNew<vtkCallbackCommand> set;
      set->SetCallback([](vtkObject*, unsigned long, void*, void* program) {
        if (program)
        {
          static_cast<vtkShaderProgram*>(program)->SetUniformf("moved", -0.4f);
        }
      });
      mapper->AddObserver(vtkCommand::UpdateShaderEvent, set);
    });
}

//------------------------------------------------------------------------------
// Programs go with the window's resources, and other ones come to where they were.
void TestReleases()
{
  Scenery scene;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(MakeSphere(2.0));
  vtkSmartPointer<vtkActor> actor = Scene::MakeActor(mapper);
  scene.Renderer->AddActor(actor);
  scene.Watch(mapper);
  vtkNew<vtkImageData> first;
  first->DeepCopy(scene.Render().at("Depth"));
  for (int i = 0; i < 5; ++i)
  {
    actor->GetProperty()->SetInterpolation(i % 3);
    scene.Window->Finalize();
    scene.Others = 0;
    const Buffers buffers = scene.Render();
    Check(scene.Others == 1, "a program for distances after a release");
    Check(AreSame(first, buffers.at("Depth")), "the same distances after a release");
  }
}

//------------------------------------------------------------------------------
// Two actors of one mapper, and a parallel projection in between.
void TestSharing()
{
  const auto draw = [](vtkPolyDataMapper* mapper) {
    Scenery scene;
    mapper->SetInputData(MakeSphere(1.0));
    for (const double x : { -1.5, 1.5 })
    {
      vtkSmartPointer<vtkActor> actor = Scene::MakeActor(mapper);
      actor->SetPosition(x, 0.0, x);
      scene.Renderer->AddActor(actor);
    }
    std::vector<Buffers> all;
    for (const bool parallel : { false, true, false })
    {
      scene.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
      scene.Renderer->GetActiveCamera()->SetParallelScale(4.0);
      all.push_back(scene.Render());
    }
    return all;
  };
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<OwnMapper> own;
  const std::vector<Buffers> a = draw(mapper);
  const std::vector<Buffers> b = draw(own);
  for (size_t i = 0; i < a.size(); ++i)
  {
    Check(AreSame(a[i].at("Depth"), b[i].at("Depth")), "two actors of one mapper");
  }
}
}

//------------------------------------------------------------------------------
int TestDepthPrePassUpdates(int, char*[])
{
  TestShaders();
  TestReleases();
  TestSharing();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
