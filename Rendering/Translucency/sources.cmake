# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  PRIVATE_CLASSES
    AirlightShadowTransmittance
    AirlightTranslucentFragments
  GLSL
    glsl/AirlightSortTranslucentFS.glsl
    glsl/AirlightTransmittanceBuffer.glsl
    glsl/AirlightTranslucentLists.glsl
    glsl/AirlightTranslucentRecord.glsl
    glsl/AirlightInscatterToTranslucent.glsl)
