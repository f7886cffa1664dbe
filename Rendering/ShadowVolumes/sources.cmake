# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  PRIVATE_CLASSES
    AirlightBoundaryBuffer
    AirlightBoundarySort
    AirlightClippedRegions
    AirlightPlanarOccluders
    AirlightRayStart
    AirlightShadowLists
    AirlightShadowPlaneBuffers
    AirlightShadowVolumes
    AirlightSilhouetteExchange
  HEADERS
    AirlightShadowRecords.h
  GLSL
    glsl/AirlightBoundaries.glsl
    glsl/AirlightKBuffer.glsl
    glsl/AirlightListHeads.glsl
    glsl/AirlightOutlineFS.glsl
    glsl/AirlightOverflowFS.glsl
    glsl/AirlightPlanesFS.glsl
    glsl/AirlightPlanesVS.glsl
    glsl/AirlightSortFS.glsl
    glsl/AirlightSortedKBuffer.glsl
    glsl/AirlightSortedList.glsl)
