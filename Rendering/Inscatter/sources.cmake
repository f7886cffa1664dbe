# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  PRIVATE_CLASSES
    AirlightInscatterPass
    AirlightInscatterShader
    AirlightLightShadow
    AirlightLightShadows
    AirlightMapShadow
    AirlightMixedShadow
    AirlightPlanesShadow
  HEADERS
    AirlightShadowMethod.h
  GLSL
    glsl/AirlightBoundaryReader.glsl
    glsl/AirlightMixedBoundaries.glsl
    glsl/AirlightNoBoundaries.glsl
    glsl/AirlightResolveFS.glsl
    glsl/AirlightResolveOutputs.glsl
    glsl/AirlightResolveTranslucent.glsl
    glsl/AirlightShadowCounts.glsl
    glsl/AirlightUnshadowedFS.glsl
    glsl/AirlightEquiangularFS.glsl
    glsl/AirlightEquiangularPixel.glsl
    glsl/AirlightEquiangularRay.glsl
    glsl/AirlightGoniometricSteps.glsl
    glsl/AirlightHeightFogSteps.glsl
    glsl/AirlightSteppedRay.glsl)
