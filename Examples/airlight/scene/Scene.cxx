// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "scene/Scene.h"

#include <vtkBoundingBox.h>

namespace airlight
{

//------------------------------------------------------------------------------
bool Scene::GetBounds(double bounds[6]) const
{
  vtkBoundingBox box;
  for (const Surface& surface : this->Surfaces)
  {
    box.AddBounds(surface.Actor->GetBounds());
  }
  if (!box.IsValid())
  {
    return false;
  }
  box.GetBounds(bounds);
  return true;
}

}
