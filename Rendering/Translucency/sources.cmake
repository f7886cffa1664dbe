# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  PRIVATE_CLASSES
    AirlightDimming
    AirlightLayerRecords
  GLSL
    glsl/AirlightDimmed.glsl
    glsl/AirlightLayers.glsl
    glsl/AirlightLayersBefore.glsl)
