// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The scenes whose frames are timed, each in a window of its own off screen, and the ways to draw
 * them. The camera turns a little before each frame, so that nothing is taken over from the frame
 * before that a user who looks around would not have either.
 */

#ifndef FrameScene_h
#define FrameScene_h

#include "vtkAirlightPass.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

class vtkActor;
class vtkLight;
class vtkPointData;
class vtkPolyData;

namespace benchmarks
{
//------------------------------------------------------------------------------
// How a frame is drawn.
struct Way
{
  std::string Name;
  bool Plain = false; // by VTK alone
  int Technique = 0;  // of vtkAirlightPass
  int Steps = 0;      // where the technique takes any
  bool Moves = false; // the first light and the first actor move before each frame
};

Way MakePlain();
Way MakeUnshadowed();
Way MakePlanes(bool moves = false);
Way MakeShadowMap(int steps);
Way MakeRayMarch(int steps);

//------------------------------------------------------------------------------
// Seconds. A software renderer works on all cores: its time on them counts other programs less than
// the clock does.
struct FrameTime
{
  double Clock;
  double Processor;
};

//------------------------------------------------------------------------------
class FrameScene
{
public:
  FrameScene(int width, int height);
  FrameScene(const FrameScene&) = delete;
  void operator=(const FrameScene&) = delete;

  // What one frame takes, after another that is not timed and makes shaders and buffers.
  FrameTime Time(const Way& way);

  // How far the airlight of each way is from vtkAirlightReference of the same view at 160 x 120
  // pixels: the root of the mean squared error over the mean, by the names of the ways. Pixels on
  // edges where the two see different surfaces do not count: that is not an error of the airlight.
  // Plain frames have none and are left out. Takes seconds to minutes.
  std::map<std::string, double> MeasureErrors(const std::vector<Way>& ways);

  vtkActor* Add(vtkPolyData* data);
  vtkLight* AddLamp(double x, double y, double z);

  vtkIdType CountTriangles();

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkParticipatingMedium> Medium;

private:
  void Set(const Way& way);
  void Turn(const Way& way);
  void Draw();
  double MeasureError(const Way& way, vtkPointData* expected);

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkAirlightPass> Pass;
  int Frames = 0;
};

//------------------------------------------------------------------------------
struct SceneRecipe
{
  std::string Name;
  std::function<void(FrameScene&)> Fill;
  int Width = 800;
  int Height = 600;
  std::vector<Way> Ways;
};

// All there are; see Documentation/benchmarks.md for what each is for.
std::vector<SceneRecipe> MakeRecipes();
}

#endif
