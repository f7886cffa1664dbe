// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferencePicture_h
#define ReferencePicture_h

#include "formats/Picture.h"
#include "scene/Scene.h"

#include <functional>
#include <string>

namespace airlight
{

/**
 * How light that is scattered several times is followed: see vtkAirlightReference.
 */
struct PathChoices
{
  int Orders = 1;         ///< 0: all
  int Samples = 0;        ///< of each pixel, at most
  double Error = 0.0;     ///< at which to stop; 0: none
  double TimeLimit = 0.0; ///< seconds; 0: none
  int Seed = 0;
};

/**
 * A buffer that only pictures with other orders than 1 have.
 */
constexpr const char* StandardErrorBuffer = "StandardError";

/**
 * Compute a scene by vtkAirlightReference, on the CPU in double precision and without a window, and
 * write it; in PNG without gamma, clamped to 0..1. Throws UserError on failure and for what only
 * the pass knows: some of its buffers and scattered surface light. `progress`,
 * which may be empty, is called with the share that is done.
 */
void ComputeToFile(const Scene& scene, const PictureSettings& settings, const PathChoices& paths,
  const std::string& fileName, const std::function<void(double)>& progress);

}

#endif
