# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
if (NOT TARGET OpenVDB::openvdb)
  return ()
endif ()
airlight_sources(
  PRIVATE_CLASSES
    AirlightDensityImage
    AirlightDensityImagePlan
    AirlightOpenVDBFile
  HEADERS
    AirlightOpenVDBArchive.h
    AirlightOpenVDBScanner.h
    AirlightOpenVDBTreeCheck.h)
