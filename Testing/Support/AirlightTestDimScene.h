// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A scene nothing of which is cut off at white, so that means of pictures are pictures of means.
 */

#ifndef AirlightTestDimScene_h
#define AirlightTestDimScene_h

#include "AirlightTestWindowScene.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"

namespace airlight_test
{
class DimScene : public WindowScene
{
public:
  static constexpr int Columns = 96;
  static constexpr int Rows = 72;

  DimScene()
    : WindowScene(Columns, Rows)
  {
    auto* lamp = vtkLight::SafeDownCast(this->Renderer->GetLights()->GetItemAsObject(0));
    lamp->SetPosition(3.0, 4.5, 7.0);
    lamp->SetIntensity(4.0);
    this->Pass->DitheringOff();
  }
};
}

#endif
