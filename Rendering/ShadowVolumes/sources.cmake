# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  PRIVATE_CLASSES
    AirlightBoundaryStore
    AirlightClippedView
    AirlightHidingFaces
    AirlightRemoteShadows
    AirlightShadowLists
    AirlightShadowVolumes
  SOURCES
    AirlightShadowListsBuffers.cxx
    AirlightShadowListsSort.cxx
    AirlightShadowVolumesEye.cxx
  GLSL
    glsl/AirlightBoundaries.glsl
    glsl/AirlightHeads.glsl
    glsl/AirlightOutlineFS.glsl
    glsl/AirlightPlanesFS.glsl
    glsl/AirlightPlanesVS.glsl
    glsl/AirlightSlots.glsl
    glsl/AirlightSortFS.glsl
    glsl/AirlightSortedList.glsl
    glsl/AirlightSortedSlots.glsl
    glsl/AirlightSpillFS.glsl)
