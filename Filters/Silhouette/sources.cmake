# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  PRIVATE_CLASSES
    AirlightCasterMesh
    AirlightMergedPoints
    AirlightShadowPieces
    AirlightSilhouette
  SOURCES
    AirlightCasterEdges.cxx
    AirlightCutPieces.cxx
    AirlightWritePieces.cxx
  HEADERS
    AirlightMeshCache.h
    AirlightParallel.h)
