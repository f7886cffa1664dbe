# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  PRIVATE_CLASSES
    AirlightCameraUniforms
    AirlightEquiangularLights
    AirlightFrameScene
    AirlightLampSamples
    AirlightLampShapes
    AirlightSceneArrays
    AirlightSceneLights
    AirlightLightGrid
    AirlightLightGridMap
    AirlightLightWays
    AirlightLightGrids
    AirlightPackedSamples
    AirlightSceneData
    AirlightScrambledNet
    AirlightSunDiscs
    AirlightUnseenLights
    AirlightUnshadowedLights
  GLSL
    glsl/AirlightCameraShader.glsl
    glsl/AirlightConstants.glsl
    glsl/AirlightLightPixel.glsl
    glsl/AirlightSunDisc.glsl
    glsl/AirlightUnshadowedRays.glsl)
