# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  PRIVATE_CLASSES
    AirlightCasterEdges
    AirlightCasterMesh
    AirlightCutPieces
    AirlightMergedPoints
    AirlightShadowPieces
    AirlightSilhouette
    AirlightWritePieces
  HEADERS
    AirlightMeshCache.h
    AirlightParallel.h)
