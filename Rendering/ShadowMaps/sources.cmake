# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  PRIVATE_CLASSES
    AirlightEpipolarMap
    AirlightEpipolarSlices
    AirlightShadowMap
    AirlightShadowMapProjection
  GLSL
    glsl/AirlightEpipolarMapFS.glsl
    glsl/AirlightMapBoundaries.glsl
    glsl/AirlightMapLookup.glsl
    glsl/AirlightMapMarch.glsl
    glsl/AirlightMergeCastersFS.glsl
    glsl/AirlightRayMarch.glsl
    glsl/AirlightShadowMapFS.glsl
    glsl/AirlightShadowMapVS.glsl
    glsl/AirlightSliceLayout.glsl
    glsl/AirlightSliceRangesFS.glsl)
