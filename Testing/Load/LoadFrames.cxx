// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Thousands of frames in which everything moves: memory stays what it was, and the first picture
// comes back to the last bit.

#include "LoadTools.h"

#include "vtkProperty.h"
#include "vtkSphereSource.h"

#include <numeric>

using namespace airlight_test;

namespace airlightload
{
namespace
{

struct MovingScene : WindowScene
{
  MovingScene(int width, int height)
    : WindowScene(width, height, 2)
  {
    this->Pass->RecordBuffersOff();
    this->Spot = this->AddPointLight({ 0, 4, 4 }, { 20, 20, 30 });
    this->Spot->SetPositional(true);
    this->Spot->SetConeAngle(35.0);
    for (int i = 0; i < 3; ++i)
    {
      this->Balls.push_back(MakeBall(12 + 6 * i));
    }
    this->Ball->GetProperty()->SetOpacity(1.0);
  }

  static vtkSmartPointer<vtkPolyData> MakeBall(int resolution)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(1.0);
    sphere->SetThetaResolution(resolution);
    sphere->SetPhiResolution(resolution);
    return Make(sphere);
  }

  // Frame 0 and those after a multiple of 10 000 are the same.
  void Move(int frame)
  {
    const double turn = glm::radians(0.036 * (frame % 10000) * 7);
    this->Look({ 10.0 * std::sin(turn), 1.0 + std::sin(3.0 * turn), 10.0 * std::cos(turn) },
      { 0.0, 0.0, 0.0 });
    this->Lights[0]->SetPosition(3.0 * std::cos(2.0 * turn), 4.0, 2.0 + std::sin(turn));
    this->Spot->SetFocalPoint(std::sin(5.0 * turn), -1.0, 0.0);
    this->Ball->SetPosition(-1.2, 0.5 * std::sin(4.0 * turn), 0.0);
    this->Cube->SetOrientation(0.0, 57.3 * turn, 20.0);
    this->Medium->SetScattering(0.05 + 0.02 * std::sin(turn), 0.07, 0.1);
    // What needs other shaders changes together: few are compiled.
    const int epoch = frame % 10000 / 10;
    const int state = epoch % 4;
    this->Lights[1]->SetSwitch(state != 1);
    this->Cube->GetProperty()->SetOpacity(state == 1 || state == 2 ? 0.5 : 1.0);
    this->Pass->SetRecordBuffers(state == 2);
    this->Medium->SetRegion(
      state < 2 ? vtkParticipatingMedium::BOX : vtkParticipatingMedium::UNBOUNDED);
    static_cast<vtkPolyDataMapper*>(this->Ball->GetMapper())
      ->SetInputData(this->Balls[epoch % this->Balls.size()]);
  }

  vtkLight* Spot;
  std::vector<vtkSmartPointer<vtkPolyData>> Balls;
};

double Mean(const std::vector<double>& values, size_t first, size_t end)
{
  return std::accumulate(values.begin() + first, values.begin() + end, 0.0) /
    static_cast<double>(end - first);
}
}

//------------------------------------------------------------------------------
void RunFrames(const Options& options)
{
  const int width = options.Size.empty() ? 96 : options.Size[0];
  const int height = options.Size.empty() ? 72 : options.Size[1];
  MovingScene scene(width, height);
  if (options.Plain)
  {
    scene.Renderer->SetPass(nullptr);
  }
  int sizes[][2] = { { width, height }, { height, width }, { width * 3 / 2, height } };
  // All that ever comes comes in 120 frames, and again with other sizes.
  for (int i = 0; i < 360; i += options.Frames < 1000 ? 10 : 1)
  {
    scene.Window->SetSize(sizes[i / 120 % 3]);
    scene.Move(i);
    scene.Window->Render();
  }
  scene.Window->SetSize(sizes[0]);
  scene.Move(0);
  const Picture first = Capture(scene.Window);
  const int objects = CountObjects(scene.Window);
  std::vector<double> memory;
  const Clock clock;
  for (int frame = 0; frame < options.Frames; ++frame)
  {
    scene.Window->SetSize(sizes[frame / 100 % 3]);
    scene.Move(frame);
    scene.Window->Render();
    memory.push_back(GetResident());
    if (frame % 1000 == 999)
    {
      std::cout << frame + 1 << " frames: " << memory.back() << " MiB, "
                << CountObjects(scene.Window) << " objects, " << clock.GetSeconds() << " s"
                << std::endl;
    }
  }
  scene.Window->SetSize(sizes[0]);
  scene.Move(0);
  const Picture last = Capture(scene.Window);
  const size_t part = std::max<size_t>(memory.size() / 10, 1);
  const double before = Mean(memory, 0, part);
  const double after = Mean(memory, memory.size() - part, memory.size());
  std::cout << options.Frames << " frames of " << width << " x " << height << " in "
            << clock.GetSeconds() << " s: " << before << " MiB at first, " << after
            << " MiB at last; " << objects << " OpenGL objects at first, "
            << CountObjects(scene.Window) << " at last\n";
  Check(after - before < 2.0, "memory grows by less than 2 MiB");
  Check(CountObjects(scene.Window) == objects, "the number of OpenGL objects stays");
  Check(first == last, "the first picture comes back");
  Check(ShowsScene(first), "something is seen");
}
}
