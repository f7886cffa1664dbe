#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""What sensors on the floor of a smoky room measure, and how well an eye sees the floor.

    sensors_on_floor.py [OUT.npz]

A light hangs above a table. For each sensor, the program computes the direct irradiance, the
irradiance that the smoke scatters onto it, and the contrast of the floor. The contrast is the
floor's share of the light that the eye sees; the rest comes from the smoke in front of the floor.
"""

import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkRenderingCore import vtkLight

import airlight

SENSORS = 33  # along each side
ALBEDO = 0.5  # of the floor


def rectangle(x, y, z):
    """The horizontal rectangle from -x to x and -z to z at the height y, facing up."""
    plane = vtkPlaneSource()
    plane.SetOrigin(-x, y, z)
    plane.SetPoint1(x, y, z)
    plane.SetPoint2(-x, y, -z)
    return plane


floor = rectangle(4, 0, 4)
floor.SetResolution(SENSORS - 1, SENSORS - 1)
table = rectangle(1, 0.75, 0.6)
lamp = vtkLight()
airlight.vtkAirlight.SetRadiantIntensity(lamp, (40, 36, 30))  # W/sr
lamp.SetPosition(0, 2.5, 0)
smoke = airlight.vtkParticipatingMedium()
smoke.SetScattering(0.15, 0.15, 0.15)  # per metre
smoke.SetAbsorption(0.05, 0.05, 0.05)

probe = airlight.vtkAirlightProbeFilter()
probe.SetInputConnection(floor.GetOutputPort())
probe.AddInputConnection(1, table.GetOutputPort())
probe.AddLight(lamp)
probe.SetMedium(smoke)
probe.SetViewpoint(0, 1.7, 6)
probe.ScatteredIrradianceOn()
probe.Update()

output = probe.GetOutput()
data = output.GetPointData()
arrays = {name: vtk_to_numpy(data.GetArray(name)).reshape(SENSORS, SENSORS, 3)
          for name in ("Radiance", "Transmittance", "DirectIrradiance", "ScatteredIrradiance")}
arrays["Position"] = vtk_to_numpy(output.GetPoints().GetData()).reshape(SENSORS, SENSORS, 3)
direct, scattered = arrays["DirectIrradiance"], arrays["ScatteredIrradiance"]
seen = ALBEDO / np.pi * (direct + scattered) * arrays["Transmittance"]
contrast = seen / (seen + arrays["Radiance"])

dark = direct[..., 0] == 0
print(f"{dark.sum()} of {dark.size} sensors are in the table's shadow")
print(f"direct irradiance: up to {direct.max():.4f}, mean {direct.mean():.4f} W/m^2")
print(f"scattered by the smoke: up to {scattered.max():.4f}, mean {scattered.mean():.4f} W/m^2")
print(f"contrast of the floor: {contrast.min():.3f} to {contrast.max():.3f}, in the shadow at most "
      f"{contrast[dark].max():.3f}")
if len(sys.argv) > 1:
    np.savez(sys.argv[1], **arrays)
