// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casters/AirlightCasterKinds.h"

#include "Casters/AirlightGlyphs.h"
#include "Scene/AirlightCasterKeys.h"
#include "Scene/AirlightClassTraits.h"
#include "vtkDataSet.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMapper.h"
#include "vtkProp.h"

namespace airlight
{
//------------------------------------------------------------------------------
bool MayCast(vtkProp* prop) { return prop->GetVisibility() && CastsShadow(prop); }

//------------------------------------------------------------------------------
bool HasPolygons(vtkMapper* mapper)
{
  auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper);
  if (!glyphs || glyphs->GetNumberOfInputConnections(0) == 0)
  {
    return glyphs || DrawsItsPolygons(mapper);
  }
  glyphs->Update();
  return HasSupportedGlyphs(glyphs);
}

//------------------------------------------------------------------------------
bool ShowsAll(vtkDataObject* input)
{
  auto* data = vtkDataSet::SafeDownCast(input);
  return data && !data->HasAnyGhostCells() && !data->HasAnyBlankCells();
}
}
