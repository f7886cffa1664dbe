// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Shadow pieces inside a box. They extend to infinity, in homogeneous coordinates, and are cut by
 * the box' six planes, so that inside it they are exact wherever the light is.
 */

#ifndef AirlightCutPieces_h
#define AirlightCutPieces_h

#include "Silhouette/AirlightShadowPieces.h"

namespace airlight
{
// The pieces in the options' bounds, in the order of MakeShadowPieces(), which calls it.
ShadowPieces CutShadowPieces(const CasterMesh& mesh, const HomogeneousPoint& light,
  const PieceOptions& options, const CasterMesh::Progress& progress);
}

#endif
