# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  PRIVATE_CLASSES
    AirlightPathDirections
    AirlightPathLights
    AirlightPathPicture
    AirlightPathRay
    AirlightPathSegment
    AirlightPathTracer
    AirlightPathVertex
    AirlightReferenceLamp
    AirlightReferenceLights
    AirlightReferenceLitParts
    AirlightReferenceMesh
    AirlightReferencePicture
    AirlightReferenceScene
    AirlightReferenceSky
    AirlightReferenceSurface
    AirlightReferenceTracer
    AirlightReferenceVolumes)
