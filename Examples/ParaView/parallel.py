#!/usr/bin/env pvbatch
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""A mesh distributed over the ranks of a parallel ParaView, in fog, with shadows across ranks.

    mpirun -n 2 pvbatch parallel.py MESH.ply [-o PICTURE.png]

The picture is the same with one rank and with several. The variable AIRLIGHT_PLUGIN names the
plugin's file.
"""

import argparse
import os

from paraview.simple import *

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("mesh")
parser.add_argument("-o", "--output", default="parallel.png")
options = parser.parse_args()
LoadPlugin(os.environ["AIRLIGHT_PLUGIN"], remote=False, ns=globals())

view = CreateView("AirlightRenderView")
view.ViewSize = [320, 240]
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = [0, 0, 0]
view.UseFXAA = 0
view.UseLight = 0

reader = PLYReader(FileNames=[options.mesh])
reader.UpdatePipeline()
x = reader.GetDataInformation().GetBounds()
size = max(x[1] - x[0], x[3] - x[2], x[5] - x[4])
centre = [(x[0] + x[1]) / 2, (x[2] + x[3]) / 2, (x[4] + x[5]) / 2]
spread = ExtractSurface(Input=RedistributeDataSet(Input=reader))
Show(spread, view)
floor = Plane(Origin=[centre[0] - 3 * size, x[2], centre[2] + 3 * size],
              Point1=[centre[0] + 3 * size, x[2], centre[2] + 3 * size],
              Point2=[centre[0] - 3 * size, x[2], centre[2] - 3 * size])
Show(floor, view)

lamp = AddLight(view=view)
lamp.Coords = "Scene"
lamp.Type = "Positional"
lamp.Position = [centre[0] - 0.9 * size, centre[1] + 0.9 * size, centre[2] - 0.3 * size]
lamp.ConeAngle = 180
lamp.Intensity = 3 * size**2
lamp.Attenuation = [0, 0, 1]
view.VisibilityDistance = 12 * size
view.CameraPosition = [centre[0] + 0.3 * size, centre[1] + 0.6 * size, centre[2] + 3.5 * size]
view.CameraFocalPoint = centre
SaveScreenshot(options.output, view)
spread.UpdatePipeline()
view.SMProxy.UpdatePropertyInformation()
print(f"silhouettes gathered: {view.GetProperty('GatheredBytes')} bytes")
