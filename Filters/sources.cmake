# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  CLASSES
    vtkAirlightComparison
    vtkAirlightDensityImage
    vtkAirlightProbeFilter
    vtkAirlightReference
    vtkEmissionLights
    vtkLitIntervalsFilter
    vtkShadowPlanesFilter
    vtkSilhouetteEdgesFilter)
if (TARGET OpenVDB::openvdb)
  airlight_sources(CLASSES vtkOpenVDBDensityReader)
endif ()
