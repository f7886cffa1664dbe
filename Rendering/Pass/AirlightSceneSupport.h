// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the props of a scene allow the frame to do.
 */

#ifndef AirlightSceneSupport_h
#define AirlightSceneSupport_h

#include <vector>

class vtkProp;
class vtkRenderPass;
class vtkRenderState;

namespace airlight
{
// Whether all that is drawn as opaque is drawn by shaders that the pass can add to. `delegate`: the
// user's pass that draws the scene, or null.
bool HasInjectableShaders(const vtkRenderState* s, const vtkRenderPass* delegate);

// Whether each fragment of the opaque surfaces hides all that is behind it, as far as is known.
bool HidesAllBehind(const vtkRenderState* s, const vtkRenderPass* delegate);

// Actors that are drawn as their mappers' inputs are, opaque everywhere; in the order of pointers.
std::vector<vtkProp*> FindSolidProps(const vtkRenderState* s, const vtkRenderPass* delegate);
}

#endif
