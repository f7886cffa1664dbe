#!/usr/bin/env pvpython
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's Wavelet in fog, which shows depth.

    pvpython fog_in_stock_scene.py [-o PICTURE.png] [--visibility DISTANCE]

ParaView's own lights illuminate the surfaces; CameraLightsScatter makes them illuminate the fog
too. The variable AIRLIGHT_PLUGIN names the plugin's file.
"""

import argparse
import os

from paraview.simple import *

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("-o", "--output", default="fog_in_stock_scene.png")
parser.add_argument("--visibility", type=float, default=150.0, help="world units")
options = parser.parse_args()
LoadPlugin(os.environ["AIRLIGHT_PLUGIN"], remote=False, ns=globals())

view = CreateView("AirlightRenderView")
view.ViewSize = [480, 360]
view.OrientationAxesVisibility = 0

wavelet = Wavelet()
contour = Contour(Input=wavelet, ContourBy=["POINTS", "RTData"], Isosurfaces=[160, 230])
ColorBy(Show(contour, view), ("POINTS", "RTData"))
Show(Outline(Input=wavelet), view)
view.CameraPosition = [32, 18, 44]
view.CameraFocalPoint = [0, -1, 0]

view.VisibilityDistance = options.visibility
view.CameraLightsScatter = 1  # the only lights here are fixed to the camera
view.UseColorPaletteForBackground = 0
view.Background = [0.02, 0.03, 0.05]
SaveScreenshot(options.output, view)
