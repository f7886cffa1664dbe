// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where vtkGlyph3DMapper draws its sources.
 */

#ifndef AirlightGlyphs_h
#define AirlightGlyphs_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkGlyph3DMapper;
class vtkMatrix4x4;
class vtkPolyData;

namespace airlight
{
struct Glyph
{
  vtkPolyData* Source;
  vtkSmartPointer<vtkMatrix4x4> ToActor;
};

// Whether GetGlyphs() knows the mapper's glyphs.
bool HasSupportedGlyphs(vtkGlyph3DMapper* mapper);

// The glyphs of a data set, turned, scaled, indexed and masked as the mapper does. None for
// composite data sets and for sources from a table tree.
std::vector<Glyph> GetGlyphs(vtkGlyph3DMapper* mapper);
}

#endif
