# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  PRIVATE_CLASSES
    AirlightStageVariants
    AirlightMapperShader
    AirlightMaterialSpecializations
    AirlightPolyDataMapperShader
    AirlightSpecialization
    AirlightSurfaceDeclarations
    AirlightSurfaceShader
    AirlightSurfaceUniforms
    AirlightVolumeShader
  GLSL
    glsl/AirlightInscatterFromFroxels.glsl
    glsl/AirlightInscatterToFragment.glsl
    glsl/AirlightFragment.glsl
    glsl/AirlightSurface.glsl
    glsl/AirlightSurfaceIrradiance.glsl
    glsl/AirlightSurfaceLights.glsl
    glsl/AirlightSurfaceMedium.glsl
    glsl/AirlightSurfaceMultiple.glsl
    glsl/AirlightVertexMedium.glsl
    glsl/AirlightVolume.glsl)
