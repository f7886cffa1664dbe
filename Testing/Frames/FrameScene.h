// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A scene that a seed makes and then changes, step by step. The same seed makes the same scene and the
 * same changes whether or not the steps between are drawn: so a scene with a history can be
 * compared with one that has none.
 *
 * No two random numbers are drawn in an order that C++ leaves open.
 *
 * The kept seeds mean the scenes of this generator. Before it is changed, what they show needs tests
 * of its own.
 */

#ifndef FrameScene_h
#define FrameScene_h

#include "FrameGroup.h"
#include "FrameParts.h"

#include "AirlightTestTools.h"

#include "vtkActor.h"
#include "vtkAirlightPass.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace airlight_test
{
// What happens to the window before a step is drawn.
enum FrameWindowEvent
{
  EVENT_NONE,
  EVENT_FINALIZE,      // the window loses its context
  EVENT_RELEASE,       // the pass releases its OpenGL objects
  EVENT_MOVE_RENDERER, // renderer and pass go to the other window
  EVENT_MOVE_PASS,     // the same, but the renderer is without its pass while it moves
  EVENT_SHARE,         // the pass draws another renderer of the other window
  EVENT_PLAIN,         // a frame is drawn without the pass
  EVENT_KINDS
};

class FrameScene
{
public:
  FrameScene(std::uint64_t seed, const std::string& photometry);

  int GetNumberOfSteps() const { return this->Steps; }

  // The changes before a step, from 1 on.
  FrameWindowEvent Change(int step);

  const FrameGroup& GetGroup() const { return this->Group; }
  bool MayBlend() const; // the picture has more than opaque surfaces
  std::string Describe() const;

  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderer> Under; // the layer below, if there is one
  vtkNew<vtkAirlightPass> Pass;
  std::vector<vtkSmartPointer<vtkParticipatingMedium>> Media;
  std::vector<vtkSmartPointer<vtkLight>> Lights;
  std::vector<FrameItem> Items; // in the renderer
  int Window = 0;               // in which of two
  int Size[2] = { 24, 18 };

private:
  // FrameScene.cxx
  void PlaceCamera(Random& random);
  void SetUpPass(Random& random);
  void SetViewport(Random& random);
  void AddLayer();
  void AddItem(Random& random);
  void PlaceItem(FrameItem& item, Random& random);

  // FrameLights.cxx
  void AddLights(Random& random);
  void PlaceLight(vtkLight* light, int kind, Random& random);
  void SetLightColour(vtkLight* light, int kind, Random& random);
  void ChangeLight(Random& random);

  // FrameMedia.cxx
  void AddMedium(size_t index, Random& random);
  void SetCoefficients(vtkParticipatingMedium* medium, Random& random);
  void SetRegion(vtkParticipatingMedium* medium, int region, Random& random);
  void SetHeight(vtkParticipatingMedium* medium, Random& random);
  void SetImage(vtkParticipatingMedium* medium, Random& random);
  void ChangeMedium(Random& random);

  // FrameRecent.cxx
  void AddRecent(Random& random);
  void AddCutOut(Random& random);
  void SetSky(vtkParticipatingMedium* medium, Random& random);
  void SetColours(vtkParticipatingMedium* medium, Random& random);
  void ScatterInVolumes(Random& random);
  void ChangeRecent(Random& random);

  // FrameChanges.cxx
  void ChangeItem(Random& random);
  void ChangeMesh(FrameItem& item, Random& random);
  void ChangePass(Random& random);
  void ChangeView(Random& random);
  void RemoveItem(Random& random);

  template <typename... Parts>
  void Note(const Parts&... parts)
  {
    this->Notes += airlight_test::Text("; ", parts...);
  }

  std::uint64_t Seed;
  FrameGroup Group;
  std::string Photometry; // the folder of IES files
  double Unit = 1.0;      // the length of what is 1 below
  int Steps = 1;
  std::string Notes;
};
}

#endif
