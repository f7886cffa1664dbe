// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ReferencePicture_h
#define ReferencePicture_h

#include "formats/Picture.h"
#include "scene/Scene.h"

#include <string>

namespace airlight
{

/**
 * Compute a scene by vtkAirlightReference, on the CPU in double precision and without a window, and
 * write it; in PNG without gamma, clamped to 0..1. Throws UserError on failure and for what only
 * the pass knows: some of its buffers, photometric files and scattered surface light.
 */
void ComputeToFile(
  const Scene& scene, const PictureSettings& settings, const std::string& fileName);

}

#endif
