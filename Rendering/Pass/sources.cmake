# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  PRIVATE_CLASSES
    AirlightAnnotations
    AirlightContext
    AirlightDelegateProps
    AirlightEdgeSamples
    AirlightErrorRecovery
    AirlightGaussianFragments
    AirlightIdleRender
    AirlightMapperHooks
    AirlightMovedCamera
    AirlightPassMessages
    AirlightPassRenderer
    AirlightRefinement
    AirlightScenePass
    AirlightSceneStages
    AirlightSceneStamp
    AirlightSceneSupport
    AirlightStagePasses
    AirlightSubpixelFrames
    AirlightWiderRange
  HEADERS
    AirlightStateSaver.h)
