#!/usr/bin/env pvpython
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""A light inside a closed mesh that is cut open: its light leaves through the cut as a shaft.

    pvpython shafts_through_clip.py MESH.ply [-o PICTURE.png]

Any closed mesh will do, for example Examples/Data/meshes/cow.ply. The variable AIRLIGHT_PLUGIN
names the plugin's file.
"""

import argparse
import os

from paraview.simple import *

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("mesh")
parser.add_argument("-o", "--output", default="shafts_through_clip.png")
parser.add_argument("--size", type=int, nargs=2, default=[480, 300], metavar=("WIDTH", "HEIGHT"))
parser.add_argument("--frames", type=int, default=1, help="for smooth edges")
options = parser.parse_args()
LoadPlugin(os.environ["AIRLIGHT_PLUGIN"], remote=False, ns=globals())

view = CreateView("AirlightRenderView")
view.ViewSize = options.size
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = [0, 0, 0]

reader = PLYReader(FileNames=[options.mesh])
reader.UpdatePipeline()
x = reader.GetDataInformation().GetBounds()
centre = [(x[0] + x[1]) / 2, (x[2] + x[3]) / 2, (x[4] + x[5]) / 2]
size = max(x[1] - x[0], x[3] - x[2], x[5] - x[4])

# Smooths the coarse mesh, and removes the back above a plane that leaves the head.
smooth = LoopSubdivision(Input=Triangulate(Input=reader), NumberofSubdivisions=2)
clip = Clip(Input=smooth, ClipType="Plane", Invert=1)
clip.ClipType.Origin = [centre[0], centre[1] + 0.3 * size, centre[2]]
clip.ClipType.Normal = [0.0, 1.0, -1.1]
shell = Show(GenerateSurfaceNormals(Input=ExtractSurface(Input=clip)), view)
shell.DiffuseColor = shell.AmbientColor = [0.4, 0.3, 0.22]  # dark: the lamp is near

lamp = AddLight(view=view)  # its radiant intensity is pi times color times intensity
lamp.Coords = "Scene"
lamp.Type = "Positional"
lamp.Position = [centre[0], centre[1] - 0.13 * size, centre[2] - 0.15 * size]
lamp.ConeAngle = 180
lamp.DiffuseColor = [1, 0.8, 0.5]
lamp.Intensity = 2.5 * size**2
lamp.Attenuation = [0, 0, 1]
view.UseLight = 1  # ParaView's own light shows the outside
view.KeyLightIntensity = 2.6

view.VisibilityDistance = 6 * size
view.PhaseFunction = "Henyey-Greenstein"
view.Anisotropy = 0.3
view.RadianceExposure = 2.7
view.ToneMapping = "Neutral PBR"  # bright colours fade to white
view.SubpixelFrames = options.frames
view.CameraPosition = [centre[0] + 2.3 * size, centre[1] + 1.1 * size, centre[2] + 0.5 * size]
view.CameraFocalPoint = [centre[0], centre[1] + 0.1 * size, centre[2] - 0.15 * size]
SaveScreenshot(options.output, view)
