# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  PRIVATE_CLASSES
    AirlightShadowMap
    AirlightShadowMapProjection
  GLSL
    glsl/AirlightMapBoundaries.glsl
    glsl/AirlightMapMarch.glsl
    glsl/AirlightMergeCastersFS.glsl
    glsl/AirlightRayMarch.glsl
    glsl/AirlightShadowMapFS.glsl
    glsl/AirlightShadowMapVS.glsl)
