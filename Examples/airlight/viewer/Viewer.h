// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Viewer_h
#define Viewer_h

#include "scene/SceneBuilder.h"
#include "viewer/LampMarkers.h"
#include "viewer/MovingQuality.h"
#include "viewer/ReadOut.h"
#include "viewer/RestRefinement.h"
#include "viewer/RestTimer.h"
#include "viewer/SceneControls.h"
#include "viewer/SliderPanel.h"

#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>

#include <array>
#include <chrono>
#include <memory>
#include <string>

namespace airlight
{

struct ViewerSettings
{
  std::string Screenshots = "airlight-%03d.png"; ///< with %d for the number
  std::string Play;                              ///< log of events to play first, empty for none
  std::string Record;                            ///< log of events to write, empty for none
  int Frames = 16;                               ///< of the mean at rest
  double FrameTime = 100.0;                      ///< ms for frames while something moves; 0: any
};

/**
 * A window on a scene whose lamps, medium and technique follow keys, mouse and sliders; GetKeys()
 * tells which does what. The read-out shows the state and how long the last such frame took, from
 * the call of vtkRenderWindow::Render() until the graphics card is done; after a key the picture is
 * drawn twice, so that the time shown belongs to what is shown. A screenshot is what the window
 * shows, with all frames of the mean that it shows at rest. While mouse or keys move something,
 * frames that would take too long are simpler.
 *
 * Logs of events are those of vtkInteractorEventRecorder; they are played as fast as frames can be
 * drawn.
 */
class Viewer
{
public:
  /**
   * Opens the window. Throws UserError for a bad pattern or log before that.
   */
  Viewer(const Scene& scene, const RenderSettings& settings, const ViewerSettings& viewer);

  /**
   * Serves the window until the user has quit. Throws UserError where a frame fails.
   */
  void Run();

  /**
   * The keys, a line each: for the window and for --help.
   */
  static const char* GetKeys();

  ///@{
  /**
   * What happened in the window. A key is named as vtkRenderWindowInteractor::GetKeySym() does; an
   * unknown one is ignored. Places and drags are in pixels. TakeLamp() chooses the lamp whose
   * dot is there, and is false if none is; a lamp outside the picture comes to its dot when it is
   * dragged. PointAt() makes the cursor a hand there.
   */
  void PressKey(const std::string& name);
  bool TakeLamp(int x, int y);
  void PointAt(int x, int y);
  void DragLamp(int right, int up);
  ///@}

  /**
   * Before the frame of a change that may be one of many, by keys or wheel: true if frames are
   * slow. The frame is then as one of a motion, and the one at rest follows when no more changes
   * come.
   */
  bool DeferRest();

private:
  bool ChangeText(const std::string& name);
  void SaveScreenshot();

  void DrawTwice();
  void DrawAtRest();
  void DrawChange(const std::string& key);
  void StartFrame();
  void EndFrame();
  void NoteFrame();
  void Quit();
  void Fail(const std::string& error);
  std::string GetState() const;

  RenderedScene Rendered;
  vtkSmartPointer<vtkAirlightPass> Pass; // also without medium
  ViewerSettings Settings;
  vtkNew<vtkRenderWindowInteractor> Interactor;
  std::unique_ptr<SceneControls> Controls;
  std::unique_ptr<MovingQuality> Quality;
  std::unique_ptr<ReadOut> Text;
  std::unique_ptr<LampMarkers> Markers;
  std::unique_ptr<SliderPanel> Sliders;
  std::unique_ptr<RestRefinement> Refinement;
  std::unique_ptr<RestTimer> Rest;
  std::array<double, 2> DotOffset = { 0.0, 0.0 }; // pixels, of the lamp that was taken
  bool ShowsSliders = true;                       // with the read-out
  std::chrono::steady_clock::time_point FrameStart;
  std::string Shown; // state in the window
  std::string Log;   // to play
  std::string Error;
  bool Live = false; // events come from the window, not from a log
  bool Done = false;
};

}

#endif
