#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""A ball and a light in fog, rendered off screen; the buffers of the pass as numpy arrays.

    fog_to_numpy.py [OUT.npz]
"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow)
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401 VTK's renderer

import airlight

ball = vtkSphereSource()
mapper = vtkPolyDataMapper()
mapper.SetInputConnection(ball.GetOutputPort())
actor = vtkActor()
actor.SetMapper(mapper)
lamp = vtkLight()
airlight.vtkAirlight.SetRadiantIntensity(lamp, (20, 18, 15))  # W/sr
lamp.SetPosition(1.5, 1.5, 1)

medium = airlight.vtkParticipatingMedium()
medium.SetVisibility(15)
fog_pass = airlight.vtkAirlightPass()
fog_pass.SetMedium(medium)
fog_pass.RecordBuffersOn()

renderer = vtkRenderer()
renderer.AddActor(actor)
renderer.AddLight(lamp)
renderer.SetPass(fog_pass)
renderer.GetActiveCamera().SetPosition(0, 0, 5)
window = vtkRenderWindow()
window.SetOffScreenRendering(True)
window.SetMultiSamples(0)
window.SetSize(320, 240)
window.AddRenderer(renderer)
window.Render()

arrays = {}
for name in ("Radiance", "Airlight", "Transmittance", "Depth"):
    image = fog_pass.GetBuffer(name)
    width, height, _ = image.GetDimensions()
    # Row 0 is the bottom row; radiance is linear, in W/(m^2 sr).
    arrays[name] = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)

on_ball = arrays["Depth"][..., 0] > 0
airlight_share = arrays["Airlight"].sum() / arrays["Radiance"].sum()
print(f"the ball covers {on_ball.mean():.1%} of the picture")
print(f"{airlight_share:.1%} of the light comes from the fog")
print(f"brightest: {arrays['Radiance'].max(axis=(0, 1))}")
if len(sys.argv) > 1:
    np.savez(sys.argv[1], **arrays)
