# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests in ParaView share: the plugin, scenes, pictures as arrays, rays of their pixels.

AIRLIGHT_PLUGIN names the plugin's file, AIRLIGHT_TEST_OUTPUT a folder for pictures.
"""

import os
import pathlib
import unittest

import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

OUTPUT = pathlib.Path(os.environ.get("AIRLIGHT_TEST_OUTPUT", "."))
VERSION = (servermanager.vtkSMProxyManager.GetVersionMajor(),
           servermanager.vtkSMProxyManager.GetVersionMinor())
SIZE = (200, 150)
CAMERA = {"position": (0.4, 0.6, 5.0), "focal_point": (0, 0, 0), "view_angle": 30.0}


def load_plugin():
    simple.LoadPlugin(os.environ["AIRLIGHT_PLUGIN"], remote=False, ns=vars(simple))


def make_view(kind="AirlightRenderView", size=SIZE):
    """A view without ParaView's own lights and axes, before a black background, whose colours are
    radiances."""
    view = simple.CreateView(kind)
    if kind == "AirlightRenderView":
        view.ToneMapping = "Clamp"
    view.ViewSize = list(size)
    view.OrientationAxesVisibility = 0
    view.CenterAxesVisibility = 0
    view.UseLight = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0, 0, 0]
    place_camera(view)
    return view


def find_view(kind="AirlightRenderView"):
    """The first view of a kind in the session."""
    return next(view for view in simple.GetViews() if view.GetXMLName() == kind)


def place_camera(view):
    view.CameraPosition = list(CAMERA["position"])
    view.CameraFocalPoint = list(CAMERA["focal_point"])
    view.CameraViewUp = [0, 1, 0]
    view.CameraViewAngle = CAMERA["view_angle"]


def add_lamp(view, position=(-1.2, 1.6, 0.8), colour=(1.0, 0.9, 0.75), intensity=3.0):
    """A point light of the radiant intensity pi colour intensity."""
    lamp = simple.AddLight(view=view)
    lamp.Coords = "Scene"
    lamp.Type = "Positional"
    lamp.Position = list(position)
    lamp.ConeAngle = 180
    lamp.DiffuseColor = list(colour)
    lamp.Intensity = intensity
    lamp.Attenuation = [0, 0, 1]
    return lamp


def make_sources():
    """A finely faceted ball of radius 0.5 above a floor."""
    ball = simple.Sphere(Radius=0.5, ThetaResolution=96, PhiResolution=96)
    floor = simple.Plane(Origin=[-4, -0.6, 4], Point1=[4, -0.6, 4], Point2=[-4, -0.6, -4])
    return ball, floor


def show(view, *sources, **properties):
    displays = []
    for source in sources:
        display = simple.Show(source, view)
        for name, value in properties.items():
            display.SetPropertyWithName(name, value)
        displays.append(display)
    return displays


def read_png(path):
    """Channels 0 to 255 as floats, top row first."""
    reader = vtkPNGReader()
    reader.SetFileName(str(path))
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)
    return pixels[::-1].astype(float)


def picture(view, name, size=None, **options):
    path = OUTPUT / f"{name}.png"
    path.unlink(missing_ok=True)
    simple.SaveScreenshot(str(path), view, ImageResolution=list(size or view.ViewSize), **options)
    return read_png(path)


def pixel_rays(width, height):
    """Unit directions [height, width, 3] of the pixels' middles, top row first."""
    eye, focus = (np.array(CAMERA[key], float) for key in ("position", "focal_point"))
    forward = (focus - eye) / np.linalg.norm(focus - eye)
    right = np.cross(forward, (0, 1, 0))
    right /= np.linalg.norm(right)
    up = np.cross(right, forward)
    half = np.tan(np.radians(CAMERA["view_angle"]) / 2)
    x = (np.arange(width) + 0.5 - width / 2) / (height / 2) * half
    y = (height / 2 - np.arange(height) - 0.5) / (height / 2) * half
    rays = forward + x[None, :, None] * right + y[:, None, None] * up
    return rays / np.linalg.norm(rays, axis=-1, keepdims=True)


def hit_ball(origins, rays, radius=0.5):
    """Distance to a ball around the origin; infinite where it is missed or behind."""
    along = -(origins * rays).sum(axis=-1)
    square = radius**2 - (origins * origins).sum(axis=-1) + along**2
    root = np.sqrt(np.maximum(square, 0))
    near = np.where(along - root > 0, along - root, along + root)
    return np.where((square > 0) & (near > 0), near, np.inf)


def hit_floor(origins, rays, height=-0.6, half=4.0):
    """Distance to the floor; infinite where it is missed."""
    with np.errstate(divide="ignore", invalid="ignore"):
        t = (height - origins[..., 1]) / rays[..., 1]
        x, z = (origins[..., i] + t * rays[..., i] for i in (0, 2))
    return np.where((t > 0) & (np.abs(x) <= half) & (np.abs(z) <= half), t, np.inf)


def cross_box(origins, rays, low, high):
    """Where rays enter and leave a box; two equal distances where they miss it."""
    with np.errstate(divide="ignore"):
        ends = (np.array([low, high])[:, None, None] - origins) / rays
    enter = np.maximum(ends.min(axis=0).max(axis=-1), 0)
    return enter, np.maximum(ends.max(axis=0).min(axis=-1), enter)


def lengths_in_box(low, high):
    """How long each pixel's ray of SIZE is in a box."""
    rays = pixel_rays(*SIZE)
    enter, leave = cross_box(np.array(CAMERA["position"]), rays, np.array(low), np.array(high))
    return leave - enter


class ClearViewTestCase(unittest.TestCase):
    """Each test has a view of its own in clear air, without lights, and takes its sources along."""

    NAME = "clear"  # of pictures

    def setUp(self):
        load_plugin()
        self.view = make_view()
        self.view.Thickness = "Coefficients"
        self.view.Scattering = [0, 0, 0]
        self.view.AmbientFromBackground = 0

    def tearDown(self):
        for source in list(simple.GetSources().values()):
            simple.Delete(source)
        simple.Delete(self.view)

    def picture(self, name):
        """Red, 0 to 1."""
        simple.Render(self.view)
        place_camera(self.view)
        return picture(self.view, f"{self.NAME}-{name}")[..., 0] / 255
