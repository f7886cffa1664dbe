# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  PRIVATE_CLASSES
    AirlightFrame
    AirlightFramePlan
    AirlightFrameRecorder
    AirlightGeometryPass
    AirlightTargets
  HEADERS
    AirlightSceneDrawer.h
  GLSL
    glsl/AirlightDistancesFS.glsl)
