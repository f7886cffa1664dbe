# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  PRIVATE_CLASSES
    AirlightHeadlessContext
    AirlightPixelArea
    AirlightProgram
    AirlightQuad
    AirlightSamplerSlots
    AirlightShaderLibrary
    AirlightStorageBinding
  HEADERS
    AirlightOpenGL.h
  GLSL
    glsl/AirlightDecode.glsl
    glsl/AirlightDiffuseLight.glsl
    glsl/AirlightFullScreenVS.glsl)
