# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  PRIVATE_CLASSES
    AirlightEdgeMean
    AirlightExposureMeter
    AirlightFrame
    AirlightFramePlan
    AirlightFrameRecorder
    AirlightFroxels
    AirlightGeometryPass
    AirlightLightWaysPass
    AirlightMeanPicture
    AirlightPixelChoice
    AirlightSubpixelMean
    AirlightTargets
  HEADERS
    AirlightSceneDrawer.h
  GLSL
    glsl/AirlightAddFS.glsl
    glsl/AirlightEdgesFS.glsl
    glsl/AirlightFroxelFS.glsl
    glsl/AirlightFroxelLossFS.glsl
    glsl/AirlightDistancesFS.glsl
    glsl/AirlightLightWaysFS.glsl
    glsl/AirlightLuminanceFS.glsl
    glsl/AirlightMaskFS.glsl)
