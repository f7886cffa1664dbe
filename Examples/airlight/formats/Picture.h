// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Picture_h
#define Picture_h

#include "scene/SceneBuilder.h"

#include <vtkImageData.h>

#include <string>
#include <vector>

namespace airlight
{

struct PictureSettings
{
  std::string Buffer;    ///< one of GetBufferNames(); empty: the picture
  double Exposure = 1.0; ///< buffers are multiplied by it
};

/**
 * What the window shows, 8-bit RGB, without another frame.
 */
vtkSmartPointer<vtkImageData> GrabWindow(vtkRenderWindow* window);

/**
 * The names that vtkAirlightPass::GetBuffer() knows.
 */
const std::vector<std::string>& GetBufferNames();

/**
 * Whether writing this file takes the pass's float buffers, or the window's 8-bit picture will do.
 */
bool NeedsBuffers(const PictureSettings& settings, const std::string& fileName);

/**
 * Draw a frame and write it. If NeedsBuffers(), the scene has to be built with RecordBuffers.
 * Throws UserError on failure.
 */
void RenderToFile(
  RenderedScene& scene, const PictureSettings& settings, const std::string& fileName);

}

#endif
