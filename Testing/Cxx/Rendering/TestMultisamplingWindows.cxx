// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPass::SetMultisampling() in layers, in stereo and with a sun's disc: edges come closer
// to the mean over each pixel; and the three further frames are drawn at edges alone.

#include "AirlightTestDimScene.h"
#include "AirlightTestEdges.h"
#include "AirlightTestMeans.h"
#include "AirlightTestTools.h"
#include "AirlightTestWindowScene.h"

#include "vtkAirlightLight.h"
#include "vtkLight.h"
#include "vtkRenderStepsPass.h"
#include "vtk_glew.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
constexpr int Columns = DimScene::Columns;
constexpr int Rows = DimScene::Rows;

class SmoothScene : public DimScene
{
public:
  void SetSmooth(bool smooth)
  {
    this->Window->SetMultiSamples(smooth ? 4 : 0);
    this->Pass->SetMultisampling(smooth);
  }
};

void CheckEdges(const std::string& name, SmoothScene& scene, double goal)
{
  const Picture one = Capture(scene.Window);
  const Means expected = AverageByHand(scene.Window, scene.Renderer);
  scene.SetSmooth(true);
  const Picture smooth = Capture(scene.Window);
  Check(Capture(scene.Window) == smooth, name + ": the same each time");
  scene.SetSmooth(false);
  const double first = GetEdgeError(expected, one, one);
  const double error = GetEdgeError(expected, one, smooth);
  std::cout << name << ": one frame is off by " << first << " / 255, four samples by " << error
            << "\n";
  Check(error < goal * first, name + ": error of four samples");
  Check(Capture(scene.Window) == one, name + ": one frame as before");
}

//------------------------------------------------------------------------------
void TestLayers()
{
  SmoothScene scene;
  vtkNew<vtkRenderer> other;
  other->SetBackground(0.1, 0.2, 0.3);
  scene.Window->SetNumberOfLayers(2);
  scene.Window->AddRenderer(other);
  scene.Renderer->SetLayer(1);
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  CheckEdges("over another layer", scene, 0.5);
  scene.Renderer->SetLayer(0);
  other->SetLayer(1);
  CheckEdges("below another layer", scene, 0.5);
}

//------------------------------------------------------------------------------
void TestStereo()
{
  for (const int type : { VTK_STEREO_LEFT, VTK_STEREO_ANAGLYPH, VTK_STEREO_INTERLACED })
  {
    SmoothScene scene;
    scene.Window->SetStereoType(type);
    scene.Window->StereoRenderOn();
    CheckEdges(Text("stereo ", type), scene, 0.55);
  }
}

//------------------------------------------------------------------------------
// Its border is an edge.
void TestSunDisc()
{
  SmoothScene scene;
  scene.Renderer->GetLights()->RemoveAllItems();
  vtkLight* sun = scene.AddDirectionalLight({ 0.0, 0.1, -1.0 }, glm::dvec3(0.02));
  vtkAirlightLight::SetAngularDiameter(sun, 10.0);
  vtkAirlightLight::SetVisible(sun, true);
  CheckEdges("a sun", scene, 0.55);
}

//------------------------------------------------------------------------------
// The fragments that a picture draws.
GLuint CountFragments(SmoothScene& scene)
{
  scene.Window->Render(); // shaders and textures
  GLuint query = 0;
  GLuint count = 0;
  glGenQueries(1, &query);
  glBeginQuery(GL_SAMPLES_PASSED, query);
  scene.Window->Render();
  glEndQuery(GL_SAMPLES_PASSED);
  glGetQueryObjectuiv(query, GL_QUERY_RESULT, &count);
  glDeleteQueries(1, &query);
  return count;
}

// With a delegate the three frames are whole.
void TestEdgesAlone()
{
  SmoothScene scene;
  scene.SetSmooth(true);
  const double edges = CountFragments(scene);
  scene.Pass->MultisamplingOff();
  const double one = CountFragments(scene);
  vtkNew<vtkRenderStepsPass> steps;
  scene.Pass->SetDelegatePass(steps);
  const double oneWhole = CountFragments(scene);
  scene.Pass->MultisamplingOn();
  const double whole = CountFragments(scene);
  std::cout << "fragments of the three frames: " << edges - one << " at edges, " << whole - oneWhole
            << " if they are whole\n";
  Check(one > Columns * Rows && edges > one, "fragments are counted");
  Check(edges - one < 0.6 * (whole - oneWhole), "edges alone are drawn again");
}
}

//------------------------------------------------------------------------------
int TestMultisamplingWindows(int, char*[])
{
  TestLayers();
  TestStereo();
  TestSunDisc();
  TestEdgesAlone();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
