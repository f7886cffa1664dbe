# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  PRIVATE_CLASSES
    AirlightAdaptive
    AirlightGridQuadrature
    AirlightIntegrate
  HEADERS
    AirlightFunctions.inl
    AirlightMath.h
    AirlightMembers.h
    AirlightMatrix.h)
