# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's lights with photometric files and extents, beside vtkAirlightLight."""

import pathlib
import subprocess
import sys
import unittest

import airlight
from airlight import paraview as attaching
import numpy as np
from paraview import simple
from vtkmodules.vtkRenderingCore import vtkLight

import paraviewtest as test

RUN = pathlib.Path(__file__).resolve().parents[2] / "Utilities" / "paraview-test.sh"
FILES = pathlib.Path(__file__).resolve().parents[2] / "Testing" / "Data" / "Photometry"
FRAMES = 6
LAMP = {"Type": "Positional", "Position": [-0.9, 1.2, 0.8], "FocalPoint": [0.1, 0, 0],
        "Attenuation": [0, 0, 1], "Intensity": 3.0, "ConeAngle": 90}
SUN = {"Type": "Directional", "Position": [-1, 2, 0.5], "FocalPoint": [0, 0, 0], "Intensity": 0.6}
BEHIND = {"Type": "Directional", "Position": [0.02, 0.3, -5], "FocalPoint": [0, 0, 0],
          "Intensity": 0.01}

# A light, its properties in ParaView, and the same by the class.
CASES = {
    "photometry": (
        LAMP, {"Photometry": str(FILES / "lowbeam.ies"), "PhotometryUp": [0.2, 0.3, 1]},
        lambda settings, light: (settings.SetPhotometry(light, str(FILES / "lowbeam.ies")),
                                 settings.SetPhotometryUp(light, 0.2, 0.3, 1))),
    "ball": (LAMP, {"LampRadius": 0.25},
             lambda settings, light: settings.SetRadius(light, 0.25)),
    "panel": (LAMP, {"LampSize": [0.6, 0.2], "LampVisible": 1},
              lambda settings, light: (settings.SetSize(light, 0.6, 0.2),
                                       settings.SetVisible(light, True))),
    "sun": (SUN, {"AngularDiameter": 6},
            lambda settings, light: settings.SetAngularDiameter(light, 6)),
    "sun-seen": (BEHIND, {"AngularDiameter": 3, "LampVisible": 1},
                 lambda settings, light: (settings.SetAngularDiameter(light, 3),
                                          settings.SetVisible(light, True))),
}


def make_view(kind):
    view = test.make_view(kind)
    test.show(view, *test.make_sources())
    simple.Render(view)
    test.place_camera(view)
    return view


def add_light(view, properties):
    light = simple.AddLight(view=view)
    light.Coords = "Scene"
    for name, value in properties.items():
        setattr(light, name, value)
    return light


def draw(name, light, properties):
    """The picture of a view with such a light."""
    view = make_view("AirlightRenderView")
    view.Region = "Box"  # a sun is not seen in a medium without an end
    view.RegionBounds = [-2, 2, -0.7, 2, -2, 2]
    view.Thickness = "Coefficients"
    view.Scattering = [0.12] * 3
    view.PhaseFunction = "Isotropic"
    view.SubpixelFrames = FRAMES
    add_light(view, {**light, **properties})
    drawn = test.picture(view, name)
    simple.Delete(view)
    return drawn


def draw_by_classes(name, light, apply):
    view = make_view("RenderView")
    view.UseFXAA = 0
    lamp = vtkLight()
    lamp.SetLightTypeToSceneLight()
    lamp.SetPositional(light["Type"] == "Positional")
    lamp.SetConeAngle(light.get("ConeAngle", 30))
    lamp.SetPosition(light["Position"])
    lamp.SetFocalPoint(light["FocalPoint"])
    lamp.SetIntensity(light["Intensity"])
    lamp.SetAttenuationValues(light.get("Attenuation", [1, 0, 0]))
    apply(airlight.vtkAirlightLight, lamp)
    view.SMProxy.GetRenderer().AddLight(lamp)
    fog = airlight.vtkParticipatingMedium()
    fog.SetScattering(0.12, 0.12, 0.12)
    fog.SetRegionToBox()
    fog.SetBounds(-2, 2, -0.7, 2, -2, 2)
    attaching.attach(view, fog).SetSubpixelFrames(FRAMES)
    drawn = test.picture(view, name)
    simple.Delete(view)
    return drawn


class Lights(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        test.load_plugin()

    def test_properties(self):
        """As by the classes; without the property, another picture."""
        for name, (light, properties, apply) in CASES.items():
            with self.subTest(name):
                without = draw(f"light-{name}-without", light, {})
                found = draw(f"light-{name}", light, properties)
                expected = draw_by_classes(f"light-{name}-by-classes", light, apply)
                difference = np.abs(found - expected).max()
                print(f"{name}: {difference} from the class's, "
                      f"{np.abs(found - without).max()} from none")
                self.assertLessEqual(difference, 1)
                self.assertGreater(np.abs(found - without).max(), 8)

    def test_state(self):
        """A state file keeps them."""
        simple.ResetSession()
        test.load_plugin()
        view = make_view("AirlightRenderView")
        properties = {**CASES["photometry"][1], "LampSize": [0.6, 0.2], "LampRadius": 0.1,
                      "AngularDiameter": 2, "LampVisible": 1}
        add_light(view, {**LAMP, **properties})
        path = str(test.OUTPUT / "lights.pvsm")
        simple.SaveState(path)
        del view
        simple.ResetSession()
        simple.LoadState(path)
        view = test.find_view()
        loaded = view.AdditionalLights[0]
        for name, value in properties.items():
            found = getattr(loaded, name)
            self.assertEqual(list(found) if isinstance(value, list) else found, value, name)

    def test_bad_values(self):
        """An error that names file or value; the picture stays."""
        done = subprocess.run([str(RUN), "--run", __file__, "--bad"], capture_output=True,
                              text=True, timeout=120)
        text = done.stdout + done.stderr
        self.assertEqual(done.returncode, 0, text)
        for part in ("/no/such.ies", "radius -1", "size 1 x -2", "angular diameter 200",
                     "(0, 0, 0)"):
            self.assertIn(part, text)
        self.assertEqual(text.count("ERR|"), 5, text)
        self.assertIn("same picture: True", text)


def use_bad_values():
    """In a process of its own, whose output is read."""
    test.load_plugin()
    view = make_view("AirlightRenderView")
    light = add_light(view, LAMP)
    before = test.picture(view, "light-before-bad")
    for name, value in (("Photometry", "/no/such.ies"), ("PhotometryUp", [0, 0, 0]),
                        ("LampRadius", -1), ("LampSize", [1, -2]), ("AngularDiameter", 200)):
        setattr(light, name, value)
    print("same picture:", (test.picture(view, "light-after-bad") == before).all())


if __name__ == "__main__":
    if sys.argv[1:] == ["--bad"]:
        use_bad_values()
    # pvpython loses its window where a script calls sys.exit() with a view open.
    elif not unittest.main(argv=[__file__] + sys.argv[1:], exit=False).result.wasSuccessful():
        sys.exit(1)
