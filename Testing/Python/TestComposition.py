# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the examples of Documentation/composition.md, word for word, and two of them by numbers."""

import pathlib
import re
import unittest

import numpy as np
import vtkmodules.vtkRenderingFreeType  # noqa: F401 texts
import vtkmodules.vtkRenderingOpenGL2 as gl
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkUnsignedCharArray
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer,
                                         vtkRenderWindow, vtkTextActor)

import airlight

SIZE = 90, 90
GUIDE = pathlib.Path(__file__).resolve().parents[2] / "Documentation" / "composition.md"


def add(renderer, source, position=(0, 0, 0)):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.SetPosition(position)
    renderer.AddActor(actor)
    return actor


class Scene:
    """Balls on a floor, one of them translucent, one of lines, and a text."""

    def __init__(self, foggy=True):
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(0.05, 0.08, 0.12)
        self.renderer.AutomaticLightCreationOff()
        floor = vtkPlaneSource()
        floor.SetOrigin(-6, -1, 4)
        floor.SetPoint1(6, -1, 4)
        floor.SetPoint2(-6, -1, -10)
        add(self.renderer, floor)
        ball = vtkSphereSource()
        ball.SetThetaResolution(24)
        ball.SetPhiResolution(24)
        ball.SetRadius(0.9)
        add(self.renderer, ball, (-1, -0.1, 0))
        self.ball = add(self.renderer, ball, (1.2, 0.2, 1))
        self.ball.GetProperty().SetOpacity(0.4)
        lines = add(self.renderer, ball, (0.9, 0.6, -3))
        lines.SetScale(1.5)
        lines.GetProperty().SetRepresentationToWireframe()
        coarse = vtkSphereSource()  # lines far enough apart to see others through
        coarse.SetThetaResolution(9)
        self.lines = add(self.renderer, coarse, (1.5, -0.2, -2))
        self.lines.SetScale(3)
        self.lines.GetProperty().SetRepresentationToWireframe()
        self.lines.VisibilityOff()
        self.text = vtkTextActor()
        self.text.SetInput("Airlight")
        self.text.SetPosition(5, 70)
        self.renderer.AddActor(self.text)
        self.lamp = vtkLight()
        airlight.vtkAirlight.SetRadiantIntensity(self.lamp, (30, 27, 22))
        self.lamp.SetPosition(1, 3.5, 1)
        self.renderer.AddLight(self.lamp)
        camera = self.renderer.GetActiveCamera()
        camera.SetPosition(0, 1.2, 9)
        camera.SetFocalPoint(0, 0, 0)
        camera.SetClippingRange(1, 40)
        medium = airlight.vtkParticipatingMedium()
        if foggy:
            medium.SetScattering(0.05, 0.06, 0.07)
        else:
            medium.SetScattering(0, 0, 0)
        self.fog_pass = airlight.vtkAirlightPass()
        self.fog_pass.SetMedium(medium)
        self.fog_pass.SetSurfaceShadows(foggy)
        self.fog_pass.RecordBuffersOn()
        self.renderer.SetPass(self.fog_pass)
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(*SIZE)
        self.window.AddRenderer(self.renderer)

    def picture(self):
        self.window.Render()
        pixels = vtkUnsignedCharArray()
        self.window.GetPixelData(0, 0, SIZE[0] - 1, SIZE[1] - 1, 1, pixels, 0)
        return vtk_to_numpy(pixels).reshape(SIZE[1], SIZE[0], 3).astype(int)

    def buffer(self, name):
        image = self.fog_pass.GetBuffer(name)
        width, height, _ = image.GetDimensions()
        return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1).copy()

    def reset(self):
        """As it was made: without passes of VTK's."""
        self.renderer.GetPass().ReleaseGraphicsResources(self.window)
        if self.fog_pass.GetDelegatePass():
            self.fog_pass.GetDelegatePass().ReleaseGraphicsResources(self.window)
        self.fog_pass.SetDelegatePass(None)
        self.fog_pass.EncodedOutputOff()
        self.fog_pass.AnnotationsOn()
        self.renderer.SetPass(self.fog_pass)
        self.renderer.SetBackgroundAlpha(0)
        self.renderer.UseSSAOOff()
        self.renderer.UseFXAAOff()
        self.renderer.UseDepthPeelingOff()
        self.renderer.UseHiddenLineRemovalOff()

    def close(self):
        self.reset()
        self.fog_pass.ReleaseGraphicsResources(self.window)
        self.renderer.SetPass(None)


class TestComposition(unittest.TestCase):
    def check_example(self, scene, title, block, plain):
        names = {"gl": gl, "renderer": scene.renderer, "window": scene.window,
                 "fog_pass": scene.fog_pass}
        exec(block, names)  # pylint: disable=exec-used
        picture = scene.picture()
        finite = np.isfinite(scene.buffer("Radiance")).all()
        scene.reset()
        self.assertTrue(finite)
        # It does something, and does not lose the scene.
        self.assertGreater(np.count_nonzero(np.abs(picture - plain).max(axis=2) > 2), 20)
        self.assertGreater(np.corrcoef(picture.ravel(), plain.ravel())[0, 1], 0.3)
        return picture

    def test_examples(self):
        text = GUIDE.read_text(encoding="utf-8")
        scene = Scene()
        shown = {}
        for section in re.split(r"^### ", text, flags=re.MULTILINE)[1:]:
            title = section.split("\n", 1)[0]
            # Two ways blend in two ways, and FXAA outside smooths texts, too.
            scene.ball.SetVisibility(title == "Depth peeling")
            scene.lines.SetVisibility(title == "Hidden line removal")
            scene.text.SetVisibility(title == "Annotations")
            plain = scene.picture()
            for block in re.findall(r"```python\n(.*?)```", section, re.DOTALL):
                with self.subTest(title):
                    picture = self.check_example(scene, title, block, plain)
                    if title in shown and title in ("SSAO", "FXAA"):
                        self.assertLessEqual(np.abs(picture - shown[title]).max(), 1)
                    shown[title] = picture
        scene.close()
        headings = [title.lower().replace(" ", "-") for title in shown]
        rows = re.findall(r"^\| \[.*?\]\(#(.*?)\)", text, re.MULTILINE)
        self.assertGreater(len(rows), 8)
        for row in rows:  # each has an example
            self.assertIn(row, headings)

    def test_tone_mapping(self):
        scene = Scene()
        airlight.vtkAirlight.SetRadiantIntensity(scene.lamp, (150, 120, 90))
        scene.fog_pass.EncodedOutputOn()
        scene.fog_pass.AnnotationsOff()
        scene.renderer.SetBackgroundAlpha(1)
        tone = gl.vtkToneMappingPass()
        tone.SetToneMappingType(gl.vtkToneMappingPass.Reinhard)
        tone.SetDelegatePass(scene.fog_pass)
        scene.renderer.SetPass(tone)
        picture = scene.picture()
        radiance = scene.buffer("Radiance").astype(float)
        self.assertGreater(np.count_nonzero(radiance > 1), 50)
        expected = 255 * (radiance / (1 + radiance)) ** (1 / 2.2)
        self.assertLessEqual(np.abs(picture - expected).max(), 1)
        scene.close()

    def test_ambient_occlusion(self):
        clear = Scene(foggy=False)
        clear.ball.VisibilityOff()  # VTK darkens translucent surfaces with the opaque ones
        ssao = gl.vtkSSAOPass()
        ssao.SetRadius(0.5)
        ssao.SetDelegatePass(gl.vtkRenderStepsPass())
        clear.renderer.SetPass(ssao)
        own = clear.picture()
        clear.fog_pass.SetDelegatePass(ssao)
        clear.renderer.SetPass(clear.fog_pass)
        self.assertLessEqual(np.abs(clear.picture() - own).max(), 1)
        clear.reset()
        self.assertGreater(np.count_nonzero(np.abs(clear.picture() - own) > 8), 300)
        clear.close()


if __name__ == "__main__":
    unittest.main(argv=[__file__])  # the data folders are not needed
