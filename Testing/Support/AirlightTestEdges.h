// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How far the edges of a picture are from the mean over each pixel.
 */

#ifndef AirlightTestEdges_h
#define AirlightTestEdges_h

#include "AirlightTestMeans.h"
#include "AirlightTestTools.h"
#include "AirlightTestWindowScene.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"

namespace airlight_test
{
//------------------------------------------------------------------------------
// The mean is of radiance, those by hand are of what the window shows of it: the lamp is where its
// glow, which is cut off at white, is not seen.
inline void HideLamp(WindowScene& scene)
{
  vtkLightCollection* lights = scene.Renderer->GetLights();
  vtkLight* lamp = vtkLight::SafeDownCast(lights->GetItemAsObject(0));
  lamp->SetPosition(3.0, 4.5, 7.0);
  lamp->SetIntensity(4.0);
}
}

#endif
