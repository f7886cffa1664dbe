// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Silhouettes and shadow pieces as VTK's data.
 */

#ifndef AirlightWritePieces_h
#define AirlightWritePieces_h

#include "Silhouette/AirlightShadowPieces.h"

class vtkPolyData;

namespace airlight
{
// The edges as lines with the arrays Weight and EdgePoints and the input's point data.
void WriteLines(const CasterMesh& mesh, const std::vector<SilhouetteEdge>& edges,
  vtkPolyData* input, vtkPolyData* output);

// The pieces as polygons with the arrays Weight, EdgePoints and Part and the input's point data.
void WritePieces(
  const CasterMesh& mesh, const ShadowPieces& pieces, vtkPolyData* input, vtkPolyData* output);
}

#endif
