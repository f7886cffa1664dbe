# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  PRIVATE_CLASSES
    AirlightDensityGrid
    AirlightDensitySamples
    AirlightFilledBlocks
    AirlightImageColours
  HEADERS
    AirlightTrilinear.h)
