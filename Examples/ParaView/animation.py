#!/usr/bin/env pvpython
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Fog thickens: ParaView animates the visibility like any other property.

    pvpython animation.py [-o FOLDER] [--frames N]

Writes fog.0000.png and so on. The variable AIRLIGHT_PLUGIN names the plugin's file.
"""

import argparse
import os

from paraview.simple import *

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("-o", "--output", default=".", help="folder")
parser.add_argument("--frames", type=int, default=5)
options = parser.parse_args()
LoadPlugin(os.environ["AIRLIGHT_PLUGIN"], remote=False, ns=globals())

view = CreateView("AirlightRenderView")
view.ViewSize = [320, 240]
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = [0, 0, 0]
for depth in range(5):
    post = Cylinder(Resolution=24, Height=2, Radius=0.15, Center=[depth - 2, 0, -2 * depth])
    Show(post, view)
lamp = AddLight(view=view)
lamp.Coords = "Scene"
lamp.Position = [1, 2, 2]
lamp.FocalPoint = [0, 0, -3]
view.UseLight = 0
view.CameraPosition = [0.4, 0.5, 6]
view.CameraFocalPoint = [0, 0, -2]

scene = GetAnimationScene()
scene.PlayMode = "Sequence"
scene.NumberOfFrames = options.frames
track = GetAnimationTrack("VisibilityDistance", proxy=view)
clear, thick = CompositeKeyFrame(), CompositeKeyFrame()
clear.KeyTime, clear.KeyValues = 0, [200]
thick.KeyTime, thick.KeyValues = 1, [8]
track.KeyFrames = [clear, thick]
SaveAnimation(os.path.join(options.output, "fog.png"), view, FrameWindow=[0, options.frames - 1])
