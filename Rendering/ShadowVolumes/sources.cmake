# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  PRIVATE_CLASSES
    AirlightBoundaryBuffer
    AirlightClippedRegions
    AirlightPlanarOccluders
    AirlightShadowLists
    AirlightShadowVolumes
    AirlightSilhouetteExchange
  SOURCES
    AirlightShadowListsBuffers.cxx
    AirlightShadowListsSort.cxx
    AirlightShadowVolumesEye.cxx
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
