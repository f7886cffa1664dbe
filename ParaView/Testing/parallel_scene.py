# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""One scene on any number of ranks, for TestParallel.py: parallel_scene.py NAME.

Each rank has a part of the balls; the floor and the plate are on the first one only. Prints how
many cells there are, what was gathered, and how long a frame took.
"""

import sys
import time

from paraview import simple
from vtkmodules.vtkCommonCore import vtkCollection

import airlight.paraview
import paraviewtest as test

name = sys.argv[1]
test.load_plugin()
view = test.make_view()
view.Background = [0.3, 0.4, 0.6]
view.UseFXAA = 0
ball, floor = test.make_sources()
small = simple.Sphere(Radius=0.2, Center=[-0.75, 0.35, 0.45], ThetaResolution=40,
                      PhiResolution=40)
plate = simple.Plane(Origin=[0.6, -0.2, -0.5], Point1=[1.4, 0.1, -0.5], Point2=[0.6, 0.6, -0.2])
test.add_lamp(view)
displays = test.show(view, ball, floor, small, plate)
view.Thickness = "Coefficients"
view.Scattering = [0.12] * 3
view.Absorption = [0.03] * 3
simple.Render(view)
test.place_camera(view)  # the first Render() moves it
test.picture(view, name + "-fog")

start = time.perf_counter()
for i in range(3):
    simple.Render(view)
frame = (time.perf_counter() - start) / 3
cells = sum(source.GetDataInformation().GetNumberOfCells()
            for source in (ball, floor, small, plate))
view.SMProxy.UpdatePropertyInformation()
print(f"{name}: {cells} cells, gathered {view.GetProperty('GatheredBytes')} bytes of silhouettes, "
      f"{1000 * frame:.0f} ms a frame")

print(f"{view.GetProperty('PixelsLeftOut')} pixels left out")
# While cells are selected, ranks have other parts of the picture.
view.SMProxy.SelectSurfaceCells([20, 20, 180, 130], vtkCollection(), vtkCollection(), True)
test.picture(view, name + "-selected")
view.UseFXAA = 1
test.picture(view, name + "-smooth")
view.UseFXAA = 0

# The helper for scripts draws on one process.
try:
    airlight.paraview.attach(view)
    airlight.paraview.detach(view)
except RuntimeError as error:
    print(error)

# Something moved: gathered again.
small.Center = [-0.75, 0.55, 0.45]
test.picture(view, name + "-moved")
# A coloured cloud before backgrounds, beyond the data, and without a background.
view.Region = "Sphere"
view.RegionRadius = 0.9
view.Scattering = [0.9, 0.5, 0.2]
test.picture(view, name + "-cloud")
view.Background2 = [0.9, 0.7, 0.2]
view.BackgroundColorMode = "Gradient"
test.picture(view, name + "-gradient")
view.BackgroundColorMode = "Single Color"
test.picture(view, name + "-clear", TransparentBackground=1)
view.Airlight = 0
test.picture(view, name + "-off")
view.Airlight = 1
# What only one rank can draw.
displays[3].Opacity = 0.5
test.picture(view, name + "-translucent")
view.SMProxy.SelectSurfaceCells([20, 20, 180, 130], vtkCollection(), vtkCollection(), True)
view.SubpixelFrames = 4
test.picture(view, name + "-refined")
view.SubpixelFrames = 1
view.AutomaticExposure = 1
test.picture(view, name + "-exposed")
view.AutomaticExposure = 0
wavelet = simple.Wavelet(WholeExtent=[-8, 8] * 3)
volume = test.show(view, wavelet)[0]
volume.SetRepresentationType("Volume")
simple.ColorBy(volume, ("POINTS", "RTData"))
volume.SetScalarBarVisibility(view, False)
volume.Scale = [0.05] * 3
volume.Position = [0.2, 0.5, 0.3]
test.picture(view, name + "-volume")
view.VolumesScatter = 1
test.picture(view, name + "-scattering")
# Each rank its own part, and back.
view.GatherLimit = 0
test.picture(view, name + "-parts")
simple.Render(view)
view.GatherLimit = 1024
test.picture(view, name + "-whole")
