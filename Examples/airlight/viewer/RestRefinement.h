// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef RestRefinement_h
#define RestRefinement_h

#include "scene/SceneBuilder.h"

#include <vtkAirlightPass.h>

#include <string>

namespace airlight
{

/**
 * Makes pictures at rest smooth: each adds a frame to a mean, until it has so many.
 */
class RestRefinement
{
public:
  /**
   * Without a pass there is nothing to refine.
   */
  RestRefinement(vtkAirlightPass* pass, int frames);

  RestRefinement(const RestRefinement&) = delete;
  void operator=(const RestRefinement&) = delete;

  /**
   * From now on; before, pictures are single frames.
   */
  void Start();

  /**
   * Draws what is missing.
   */
  void Finish(RenderedScene& rendered);

  ///@{
  /**
   * Before a picture; then whether it draws the scene, and does not show the mean again.
   */
  void BeginPicture() { this->Draws = this->Frames == 1; }
  void NoteFrame() { this->Draws = true; }
  bool DrawsScene(bool moves) const { return this->Draws || moves; }
  ///@}

  /**
   * How many frames the picture has, of how many; empty for one frame.
   */
  std::string GetText() const;

private:
  vtkAirlightPass* Pass;
  int Wanted;
  int Frames = 1; // wanted now
  bool Draws = true;
};

}

#endif
