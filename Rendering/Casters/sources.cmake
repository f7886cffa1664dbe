# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  PRIVATE_CLASSES
    AirlightCasterBlocks
    AirlightCasterBox
    AirlightCasters
    AirlightPlanarFaces
    AirlightGlyphs
    AirlightNonPolygonalCaster
    AirlightOpacityMesh
    AirlightOpacityPieces
    AirlightCasterOpticalThickness
  HEADERS
    AirlightUsedEntries.h)
