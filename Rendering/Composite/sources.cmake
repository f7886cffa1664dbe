# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  PRIVATE_CLASSES
    AirlightCompositePass
    AirlightDisplayStage
  GLSL
    glsl/AirlightCompositeFS.glsl
    glsl/AirlightCopyFS.glsl
    glsl/AirlightDisplay.glsl
    glsl/AirlightShadowingLight.glsl)
