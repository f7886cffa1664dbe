# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  PRIVATE_CLASSES
    AirlightFrame
    AirlightFramePlan
    AirlightTargets
  SOURCES
    AirlightFrameCasters.cxx
    AirlightFrameComposite.cxx
    AirlightFrameResolve.cxx
    AirlightFrameResolveShader.cxx
    AirlightFrameSurfaces.cxx
    AirlightFrameTurned.cxx
    AirlightFrameWholeRays.cxx
  HEADERS
    AirlightSceneDrawer.h
  GLSL
    glsl/AirlightDistancesFS.glsl)
