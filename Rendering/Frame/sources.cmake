# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  PRIVATE_CLASSES
    AirlightFrame
    AirlightFramePlan
    AirlightFrameRecorder
    AirlightTargets
  SOURCES
    AirlightFrameCasters.cxx
    AirlightFrameResolve.cxx
    AirlightFrameResolveShader.cxx
    AirlightFrameSurfaces.cxx
  HEADERS
    AirlightSceneDrawer.h
  GLSL
    glsl/AirlightDistancesFS.glsl)
