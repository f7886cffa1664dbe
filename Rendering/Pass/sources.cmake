# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
airlight_sources(
  PRIVATE_CLASSES
    AirlightContext
    AirlightDelegate
    AirlightScenePass
    vtkAirlightPassInternals
  SOURCES
    vtkAirlightPassChecks.cxx
    vtkAirlightPassFaults.cxx
    vtkAirlightPassLights.cxx
    vtkAirlightPassOnce.cxx
    vtkAirlightPassRemote.cxx
    vtkAirlightPassShaders.cxx
    vtkAirlightPassSteps.cxx)
