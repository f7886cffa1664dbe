// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Annotations over a mean of frames: the frames have none.
 */

#ifndef AirlightAnnotations_h
#define AirlightAnnotations_h

class vtkRenderState;

namespace airlight
{
// Texts and other vtkActor2D into the framebuffer that is bound.
void DrawAnnotations(const vtkRenderState* s);
}

#endif
