# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""One scene in one process or, for TestServer.py, drawn with a pvserver: server_scene.py [PORT]."""

import os
import pathlib
import sys

from paraview import simple

import paraviewtest as test

DATA = pathlib.Path(__file__).resolve().parents[2] / "Testing" / "Data"
PHOTOMETRY = DATA / "Photometry" / "lowbeam.ies"


def draw(name, threshold=0):
    """Pictures of a scene in fog, and in thicker fog.

    threshold: megabytes of polygons from which on the server draws.
    """
    view = test.make_view()
    view.Background = [0.3, 0.4, 0.6]
    view.UseFXAA = 0  # ParaView antialiases twice on one rank, once on several
    view.RemoteRenderThreshold = threshold
    lamp = test.add_lamp(view)
    test.show(view, *test.make_sources())
    view.Thickness = "Coefficients"
    for step, scattering in (("thin", 0.12), ("thick", 0.4)):
        view.Scattering = [scattering] * 3
        simple.Render(view)
        test.place_camera(view)  # the first Render() moves it
        test.picture(view, f"{name}-{step}")
    # A surface and an image of which each rank has a part.
    view.RegionSurface = simple.Sphere(Center=[0.2, 0.1, 0.3], Radius=1.1, ThetaResolution=24,
                                       PhiResolution=20)
    view.Region = "Surface"
    test.picture(view, f"{name}-surface")
    view.DensityImage = simple.Wavelet(WholeExtent=[-2, 2, -2, 2, -2, 2])
    view.DensityArray = ["POINTS", "RTData"]
    view.Region = "Unbounded"
    view.Density = "Image"
    view.Scattering = [0.003] * 3  # at density 1; the image has some 200
    test.picture(view, f"{name}-image")
    # The same two as media beside the view's own.
    view.Density = "Uniform"
    view.Scattering = [0.1] * 3
    surface, image = test.show(view, view.RegionSurface, view.DensityImage, Representation="Medium")
    surface.MediumColor = [0.9, 0.5, 0.3]
    image.MediumDensityArray = ["POINTS", "RTData"]
    test.picture(view, f"{name}-media")
    lamp.Photometry = str(PHOTOMETRY)  # which each process reads
    lamp.FocalPoint = [0, 0, 0]
    simple.Hide(view.RegionSurface, view)
    simple.Hide(view.DensityImage, view)
    test.picture(view, f"{name}-photometry")
    # What only one rank can draw.
    glass = simple.Sphere(Center=[0.3, 0.1, 0.6], Radius=0.5, ThetaResolution=24)
    test.show(view, glass, Opacity=0.4)
    view.SubpixelFrames = 2
    test.picture(view, f"{name}-translucent")
    view.SubpixelFrames = 1
    simple.Hide(glass, view)
    # Before ParaView's own white and black, which the medium does not follow.
    view.Region = "Sphere"
    view.RegionRadius = 1.5
    test.picture(view, f"{name}-transparent", TransparentBackground=1)


if len(sys.argv) > 1:
    simple.Connect("localhost", int(sys.argv[1]))
    simple.LoadPlugin(os.environ["AIRLIGHT_PLUGIN"], remote=True, ns=vars(simple))
    test.load_plugin()
    draw("by-server")
    draw("by-client", 1e9)
else:
    test.load_plugin()
    draw("by-one")
