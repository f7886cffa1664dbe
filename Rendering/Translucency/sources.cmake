# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  PRIVATE_CLASSES
    AirlightFroxelNodes
    AirlightShadowTransmittance
    AirlightTranslucentFragments
  GLSL
    glsl/AirlightFroxelAtlasFS.glsl
    glsl/AirlightFroxelDepths.glsl
    glsl/AirlightFroxelLookup.glsl
    glsl/AirlightFroxelGrid.glsl
    glsl/AirlightSortTranslucentFS.glsl
    glsl/AirlightTransmittanceBuffer.glsl
    glsl/AirlightTranslucentLists.glsl
    glsl/AirlightTranslucentRecord.glsl
    glsl/AirlightInscatterToTranslucent.glsl)
