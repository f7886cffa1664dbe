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
#include "vtkSSAAPass.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkActor;
class vtkLight;
class vtkPolyData;

namespace benchmarks
{
//------------------------------------------------------------------------------
// What smooths the edges of a frame.
enum class Antialiasing
{
  None,
  Window, // a multisampled window, which smooths those of VTK's own frames alone
  Edges,  // vtkAirlightPass::SetMultisampling() in one
  Larger  // vtkSSAAPass around the pass
};

// How a frame is drawn.
struct Way
{
  std::string Name;
  bool Plain = false;  // by VTK alone
  int Technique = 0;   // of vtkAirlightPass
  int Steps = 0;       // where the technique takes any
  bool Moves = false;  // the first light and the first actor move before each frame
  double Target = 0.0; // above 0: with the fewest steps whose error is not above this
  Antialiasing Smooth = Antialiasing::None;
};

Way MakePlain();
Way MakeUnshadowed();
Way MakeAutomatic();
Way MakePlanes(bool moves = false);

// One of the others, smoothed.
Way MakeSmooth(Way way, Antialiasing smooth);

Way MakeShadowMap(int steps);
Way MakeRayMarch(int steps);

// The ray march of as many steps as FrameErrors finds for this error; it has no Steps yet.
Way MakeRayMarchTo(double error);

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
  // Draws into the window, alone or in turn with others.
  explicit FrameScene(vtkRenderWindow* window);
  ~FrameScene();
  FrameScene(const FrameScene&) = delete;
  void operator=(const FrameScene&) = delete;

  // What one frame takes, after another that is not timed and makes shaders and buffers.
  FrameTime Time(const Way& way);

  // What one frame takes at once.
  FrameTime TimeOne(const Way& way);

  // Whether the last frame was drawn with the way's technique, and not with another in its place.
  bool IsDrawnAs(const Way& way);

  // One frame, not timed, from where the camera is. The pass has its buffers where the way is not
  // plain.
  vtkAirlightPass* Record(const Way& way);

  vtkActor* Add(vtkPolyData* data);
  vtkLight* AddLamp(double x, double y, double z);
  void AddMedium(vtkParticipatingMedium* medium);

  // The first of those.
  vtkActor* GetFirstActor();
  vtkLight* GetFirstLamp();

  vtkIdType CountTriangles();

  // Of all actors that draw vtkPolyData in all lights of the scene, as vtkSilhouetteEdgesFilter
  // finds them.
  vtkIdType CountSilhouetteEdges();

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkParticipatingMedium> Medium;
  const vtkSmartPointer<vtkRenderWindow> Window;

private:
  vtkIdType CountSilhouetteEdges(vtkPolyData* data);
  void Set(const Way& way);
  void Turn(const Way& way);
  void Draw();

  vtkNew<vtkAirlightPass> Pass;
  vtkNew<vtkSSAAPass> Larger;
  int Frames = 0;
};

//------------------------------------------------------------------------------
// Scenes that are timed in turn: FrameFigures.h sets single frames of theirs against each other.
enum class SceneGroup
{
  None, // each alone
  Lights,
  Sizes
};

struct SceneRecipe
{
  std::string Name;
  std::function<void(FrameScene&)> Fill;
  std::function<void(FrameScene&)> Base;   // a scene whose frames are timed in turn, if any
  std::string BaseName;                    // what its rows begin with
  std::function<void(FrameScene&)> Change; // after which frames are timed (FrameChanges.h), if any
  int Width = 800;
  int Height = 600;
  std::vector<Way> Ways;
  SceneGroup Group = SceneGroup::None;
};

// All there are; see Documentation/benchmarks.md for what each is for.
std::vector<SceneRecipe> MakeRecipes();
}

#endif
