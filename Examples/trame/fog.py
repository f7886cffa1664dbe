#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""A web application: a lantern in a hall full of fog, with sliders for fog, lamp and shadows.

    python fog.py                       # opens the browser
    python fog.py --server --port 8080  # serves http://localhost:8080/

The server renders, and the browser shows its pictures (VtkRemoteView): a render pass exists on the
server only. VtkLocalView would draw the hall in the browser with WebGL, without fog. See
Documentation/web.md.
"""

import asyncio
import math
import os

from trame.app import TrameApp, asynchronous
from trame.decorators import change
from trame.ui.vuetify3 import SinglePageWithDrawerLayout
from trame.widgets import vtk as vtk_widgets
from trame.widgets import vuetify3 as v3
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkAppendPolyData
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter
from vtkmodules.vtkFiltersSources import (
    vtkCubeSource, vtkCylinderSource, vtkDiskSource, vtkSphereSource)
from vtkmodules.vtkInteractionStyle import vtkInteractorStyleTrackballCamera
from vtkmodules.vtkRenderingCore import (
    vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor)
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLFXAAPass, vtkToneMappingPass

import airlight

STONE, FLOOR, IRON = (0.55, 0.5, 0.44), (0.34, 0.32, 0.3), (0.12, 0.11, 0.1)
WIDTH, HEIGHT, FRONT, BACK = 10.0, 5.2, 1.0, -15.0  # m, of the hall; the view is along -z
LAMP_Z = -6.0
BULB_RADIUS = 0.08  # m
LAMP_COLOUR = (1.0, 0.8, 0.55)
AMBIENT = (0.006, 0.009, 0.0144)  # W/(m^2 sr), of light that fog and walls scatter repeatedly

# What the sliders show first: metres, W/sr, metres, how shadows are computed.
START = {"visibility": 25, "intensity": 60, "height": 2.6,
         "technique": int(airlight.vtkAirlightPass.AUTOMATIC)}
TECHNIQUES = [{"title": title, "value": int(value)} for title, value in (
    ("Automatic", airlight.vtkAirlightPass.AUTOMATIC),
    ("Shadow planes", airlight.vtkAirlightPass.SHADOW_PLANES),
    ("Shadow map", airlight.vtkAirlightPass.SHADOW_MAP),
    ("Ray march", airlight.vtkAirlightPass.RAY_MARCH),
    ("None", airlight.vtkAirlightPass.NONE))]


def box(*bounds):
    source = vtkCubeSource()
    source.SetBounds(bounds)
    return source


def make_column(x, z):
    """A shaft between two plates, which carries a beam 4.5 m above the floor."""
    shaft = vtkCylinderSource()
    shaft.SetCenter(x, 2.25, z)
    shaft.SetRadius(0.26)
    shaft.SetHeight(4.2)
    shaft.SetResolution(48)
    plates = [box(x - 0.36, x + 0.36, y, y + 0.15, z - 0.36, z + 0.36) for y in (0, 4.35)]
    return [shaft, *plates]


def moved(source, turn=(0, 0), place=(0, 0, 0)):
    """Turned by degrees about x and y, and put at a place."""
    transform = vtkTransform()
    transform.Translate(place)
    transform.RotateX(turn[0])
    transform.RotateY(turn[1])
    result = vtkTransformPolyDataFilter()
    result.SetTransform(transform)
    result.SetInputConnection(source.GetOutputPort())
    return result


def make_lantern():
    """An iron cage around the origin, on a rod: its six bars cast the shadows."""
    bar = box(-0.04, 0.04, -0.4, 0.4, 0.29, 0.31)
    ring = vtkDiskSource()
    ring.SetInnerRadius(0.22)
    ring.SetOuterRadius(0.34)
    ring.SetCircumferentialResolution(48)
    rod = box(-0.015, 0.015, 0.4, HEIGHT, -0.015, 0.015)
    parts = [rod, *(moved(bar, turn=(0, 60 * i + 30)) for i in range(6)),
             *(moved(ring, turn=(90, 0), place=(0, y, 0)) for y in (-0.4, 0.4))]
    lantern = vtkAppendPolyData()
    for part in parts:
        lantern.AddInputConnection(part.GetOutputPort())
    return lantern


class FoggyHall:
    """The VTK side: a scene, a lamp, a medium and a window, without anything of trame."""

    def __init__(self):
        self.renderer = vtkRenderer()
        self.make_hall()
        self.make_lamp()
        self.make_fog()
        self.update(**START)
        self.reset_camera()

    def make_lamp(self):
        self.lamp = vtkLight()
        self.renderer.AddLight(self.lamp)
        bulb = vtkSphereSource()
        bulb.SetRadius(BULB_RADIUS)
        bulb.SetThetaResolution(32)
        bulb.SetPhiResolution(32)
        self.bulb = self.add(bulb, LAMP_COLOUR)
        self.bulb.GetProperty().SetDiffuse(0)
        airlight.vtkAirlightPass.SetCastsShadow(self.bulb, False)  # the lamp is inside it
        self.lantern = self.add(make_lantern(), IRON)

    def make_fog(self):
        self.fog = airlight.vtkParticipatingMedium()
        self.fog.SetPhaseFunctionToHenyeyGreenstein()
        self.fog.SetAnisotropy(0.5)
        self.fog.SetAmbientRadiance(AMBIENT)
        self.fog_pass = airlight.vtkAirlightPass()
        self.fog_pass.SetMedium(self.fog)

        # Bright fog is mapped to what a screen can show, then edges are smoothed.
        self.fog_pass.EncodedOutputOn()
        self.renderer.SetBackgroundAlpha(1)
        tone = vtkToneMappingPass()
        tone.SetToneMappingType(vtkToneMappingPass.GenericFilmic)
        tone.SetGenericFilmicDefaultPresets()
        tone.SetDelegatePass(self.fog_pass)
        smooth = vtkOpenGLFXAAPass()
        smooth.SetDelegatePass(tone)
        self.renderer.SetPass(smooth)

    def add(self, source, colour):
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(source.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(colour)
        self.renderer.AddActor(actor)
        return actor

    def make_hall(self):
        side, wall = WIDTH / 2, 0.2
        self.add(box(-side, side, -wall, 0, BACK, FRONT), FLOOR)
        for bounds in ((-side, side, HEIGHT, HEIGHT + wall, BACK, FRONT),
                       (-side - wall, -side, 0, HEIGHT, BACK, FRONT),
                       (side, side + wall, 0, HEIGHT, BACK, FRONT),
                       (-side, side, 0, HEIGHT, BACK - wall, BACK),
                       (-side, side, 0, HEIGHT, FRONT, FRONT + wall),
                       (-2.75, -2.05, 4.5, HEIGHT, BACK, FRONT),
                       (2.05, 2.75, 4.5, HEIGHT, BACK, FRONT)):
            self.add(box(*bounds), STONE)
        for x in (-2.4, 2.4):
            for z in (-1.5, -4.5, -7.5, -10.5, -13.5):
                for part in make_column(x, z):
                    self.add(part, STONE)

    def make_window(self):
        """A window that is not on a screen; trame's view sets its size."""
        if "DISPLAY" not in os.environ:  # VTK then finds EGL without a warning about X
            os.environ.setdefault("VTK_DEFAULT_OPENGL_WINDOW", "vtkEGLRenderWindow")
        window = vtkRenderWindow()
        window.OffScreenRenderingOn()
        window.SetMultiSamples(0)  # the pass does not need it
        window.AddRenderer(self.renderer)
        interactor = vtkRenderWindowInteractor()
        interactor.SetRenderWindow(window)
        interactor.SetInteractorStyle(vtkInteractorStyleTrackballCamera())
        return window

    def reset_camera(self):
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0.9, 1.6, 0.6)
        camera.SetFocalPoint(-0.15, 2.2, -7)
        camera.SetViewUp(0, 1, 0)
        camera.SetViewAngle(55)
        self.renderer.ResetCameraClippingRange()

    def update(self, visibility, intensity, height, technique):
        """Sets what START names."""
        self.fog.SetVisibility(visibility)
        self.fog_pass.SetShadowTechnique(technique)
        airlight.vtkAirlight.SetRadiantIntensity(self.lamp, [intensity * c for c in LAMP_COLOUR])
        # The bulb's radiance is its intensity divided by the area of its disk.
        self.bulb.GetProperty().SetAmbient(intensity / (math.pi * BULB_RADIUS ** 2))
        place = (0, height, LAMP_Z)
        for thing in (self.lamp, self.bulb, self.lantern):
            thing.SetPosition(place)


class FogApplication(TrameApp):
    """The web side: the page, and what its controls do."""

    def __init__(self, server=None):
        super().__init__(server)
        self.hall = FoggyHall()
        self.window = self.hall.make_window()
        self.drawing = None  # the task that draws
        self.is_outdated = False
        self.state.update(START)
        self.make_page()

    def make_page(self):
        self.state.trame__title = "Lantern in fog"
        with SinglePageWithDrawerLayout(self.server, width=300) as self.ui:
            self.ui.title.set_text("Lantern in fog")
            with self.ui.toolbar:
                v3.VSpacer()
                v3.VBtn("Reset view", prepend_icon="mdi-camera-retake", click=self.reset_view)
            with self.ui.drawer, v3.VContainer(classes="pt-6"):
                self.add_slider("visibility", "Visibility", "m", 4, 80, 1)
                self.add_slider("intensity", "Lamp", "W/sr", 10, 120, 5)
                self.add_slider("height", "Height of the lamp", "m", 0.8, 3.8, 0.1)
                v3.VSelect(v_model=("technique",), items=("techniques", TECHNIQUES),
                           label="Shadows", variant="outlined", density="compact")
            with self.ui.content:
                with v3.VContainer(fluid=True, classes="pa-0 fill-height"):
                    self.view = vtk_widgets.VtkRemoteView(
                        self.window, interactive_ratio=0.5, still_quality=95)

    def add_slider(self, name, title, unit, least, most, step):
        v3.VLabel(f"{title}: {{{{ {name} }}}} {unit}", classes="text-body-2")
        v3.VSlider(v_model=(name,), min=least, max=most, step=step, color="amber-darken-3",
                   density="compact")

    @change(*START)
    def on_change(self, **_):
        self.is_outdated = True
        if self.drawing is None or self.drawing.done():
            self.drawing = asynchronous.create_task(self.draw())

    async def draw(self):
        """Draws the newest values. Values that arrive during a frame wait for the next one."""
        while self.is_outdated:
            self.is_outdated = False
            self.hall.update(**{name: self.state[name] for name in START})
            self.view.update()
            await asyncio.sleep(0.02)  # receives what the browser sent in the meantime

    def reset_view(self):
        self.hall.reset_camera()
        self.view.update()


if __name__ == "__main__":
    FogApplication().server.start()
