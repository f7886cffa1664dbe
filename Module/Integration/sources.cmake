# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  PRIVATE_CLASSES
    AirlightAdaptiveQuadrature
    AirlightIntegrate
    AirlightRayCuts
  HEADERS
    AirlightFunctions.inl
    AirlightMath.h
    AirlightMembers.h
    AirlightMatrix.h)
