# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  PRIVATE_CLASSES
    AirlightConvert
    AirlightConvertSky
    AirlightEnvironment
    AirlightMediumSky
  HEADERS
    AirlightChange.h
    AirlightDerivedData.h
    AirlightMediaList.h
    AirlightMediaMethods.h
    AirlightMediumColours.h
    AirlightSkyHarmonics.h)
