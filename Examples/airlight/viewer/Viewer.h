// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Viewer_h
#define Viewer_h

#include "scene/SceneBuilder.h"
#include "viewer/ReadOut.h"
#include "viewer/SceneControls.h"

#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>

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
};

/**
 * A window on a scene whose lamps, medium and technique follow keys and mouse; GetKeys() tells
 * which does what. The read-out shows the state and how long the last frame took, from the call of
 * vtkRenderWindow::Render() until the graphics card is done; after a key the picture is drawn
 * twice, so that the time shown belongs to what is shown. A screenshot is what the window shows.
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
   * unknown one is ignored. Drags are in pixels.
   */
  void PressKey(const std::string& name);
  void DragLamp(int right, int up);
  ///@}

private:
  bool ChangeText(const std::string& name);
  void SaveScreenshot();

  void DrawTwice();
  void StartFrame();
  void EndFrame();
  void Quit();
  void Fail(const std::string& error);
  std::string GetState() const;

  RenderedScene Rendered;
  ViewerSettings Settings;
  vtkNew<vtkRenderWindowInteractor> Interactor;
  std::unique_ptr<SceneControls> Controls;
  std::unique_ptr<ReadOut> Text;
  std::chrono::steady_clock::time_point FrameStart;
  double FrameTime = 0.0; // seconds
  std::string Shown;      // state in the window
  std::string Log;        // to play
  std::string Error;
  bool Done = false;
};

}

#endif
