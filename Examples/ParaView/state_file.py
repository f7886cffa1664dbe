#!/usr/bin/env pvpython
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Saves and loads the medium with a ParaView state file.

    pvpython state_file.py [-o FOLDER]

Writes fog.pvsm, a picture before the state was saved, and a picture after everything was deleted
and loaded again. The variable AIRLIGHT_PLUGIN names the plugin's file; ParaView must load it before
the state.
"""

import argparse
import os

from paraview.simple import *

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("-o", "--output", default=".", help="folder")
options = parser.parse_args()
LoadPlugin(os.environ["AIRLIGHT_PLUGIN"], remote=False, ns=globals())

view = CreateView("AirlightRenderView")
view.ViewSize = [320, 240]
Show(Superquadric(ThetaResolution=32, PhiResolution=32), view)
lamp = AddLight(view=view)
lamp.Coords = "Scene"
lamp.Type = "Positional"
lamp.Position = [0.9, 0.7, -0.4]
lamp.ConeAngle = 180
lamp.Attenuation = [0, 0, 1]
view.UseLight = 0
view.UseColorPaletteForBackground = 0
view.Background = [0, 0, 0]
view.CameraPosition = [0, 0.4, 3.5]
view.Thickness = "Coefficients"
view.Scattering = [0.15, 0.2, 0.3]  # blue scatters most
view.PhaseFunction = "Cornette-Shanks"
view.Anisotropy = 0.4
view.Region = "Sphere"
view.RegionRadius = 1.2
SaveScreenshot(os.path.join(options.output, "before.png"), view)
SaveState(os.path.join(options.output, "fog.pvsm"))

ResetSession()
LoadState(os.path.join(options.output, "fog.pvsm"))
loaded = GetActiveViewOrCreate("AirlightRenderView")
SaveScreenshot(os.path.join(options.output, "after.png"), loaded)
