# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Bad values of the view's properties: an error that names them, and the old ones stay."""

import pathlib
import subprocess
import sys
import unittest

import paraviewtest as test

RUN = pathlib.Path(__file__).resolve().parents[2] / "Utilities" / "paraview-test.sh"
# Property, value, and what the error says.
BAD = (
    ("VisibilityDistance", -3, "VisibilityDistance -3 must be finite and at least 0; it stays 0"),
    ("VisibilityDistance", float("nan"), "VisibilityDistance nan must be finite"),
    ("MediumColor", [2, 0, 0], "Color (2, 0, 0) must be finite, at least 0 and at most 1"),
    ("Scattering", [0, -1, 0], "ScatteringCoefficient (0, -1, 0) must be finite, at least 0"),
    ("Absorption", [0, 0, float("inf")], "AbsorptionCoefficient (0, 0, inf) must be finite"),
    ("Anisotropy", 5, "PhaseAnisotropy 5 must be from -0.99 to 0.99; it stays 0"),
    ("Alpha", 101, "PhaseAlpha 101 must be from 0 to 100; it stays 1"),
    ("RegionBounds", [1, 0, 0, 1, 0, 1], "Bounds (1, 0, 0, 1, 0, 1) must be finite"),
    ("RegionCenter", [0, 0, float("nan")], "Center (0, 0, nan) must be finite"),
    ("RegionRadius", -1, "Radius -1 must be finite and at least 0; it stays"),
    ("RegionHeight", -1, "Height -1 must be finite and above 0; it stays"),
    ("RegionAxis", [0, 0, 0], "Axis (0, 0, 0) must be a direction"),
    ("ScaleHeight", -1, "ScaleHeight -1 must be finite and above 0; it stays"),
    ("ReferenceHeight", float("inf"), "ReferenceHeight inf must be finite"),
    ("Up", [0, 0, 0], "Up (0, 0, 0) must be a direction"),
    ("AmbientRadiance", [-1, 0, 0], "AmbientRadiance (-1, 0, 0) must be finite"),
    ("Emission", [0, -1, 0], "Emission (0, -1, 0) must be finite"),
    ("SkyRadiance", [0, -1, 0], "SkyRadiance (0, -1, 0) must be finite"),
    ("VolumesAnisotropy", 5, "Anisotropy 5 must be from -0.99 to 0.99"),
    ("LampColor", [0, 2, 0], "LampColor (0, 2, 0) must be from 0 to 1"),
    ("LampBrightness", -1, "LampBrightness -1 must be finite and at least 0; it stays 1"),
    ("LampRadius", -1, "LampRadius -1 must be finite and at least 0; it stays 0"),
    ("LightRadius", -1, "LightRadius -1 must be finite and at least 0; it stays 0"),
    ("ShadowMapResolution", 3, "ShadowMapResolution 3 must be from 16 to 8192; it stays 1024"),
    ("MaximumBoundariesPerPixel", -1,
     "MaximumBoundariesPerPixel -1 must not be below 0; it stays 16"),
    ("NumberOfSteps", 0, "NumberOfSteps 0 must be from 1 to 2048; it stays 64"),
)


def set_bad_values():
    """In a process of its own, whose output is read."""
    test.load_plugin()
    view = test.make_view()
    test.add_lamp(view)
    test.show(view, *test.make_sources())
    before = test.picture(view, "before-errors")
    for name, value, _ in BAD:
        setattr(view, name, value)
        test.simple.Render(view)
    test.place_camera(view)
    print("same picture:", (test.picture(view, "after-errors") == before).all())


class Errors(unittest.TestCase):
    def test_bad_values(self):
        done = subprocess.run([str(RUN), "--run", __file__, "--set"], capture_output=True,
                              text=True, timeout=120)
        text = done.stdout + done.stderr
        self.assertEqual(done.returncode, 0, text)
        for name, _, message in BAD:
            self.assertIn(message, text, name)
        self.assertEqual(text.count("ERR|"), len(BAD), text)
        self.assertIn("same picture: True", text)


if __name__ == "__main__":
    if sys.argv[1:] == ["--set"]:
        set_bad_values()
    # pvpython loses its window where a script calls sys.exit() with a view open.
    elif not unittest.main(argv=[__file__] + sys.argv[1:], exit=False).result.wasSuccessful():
        sys.exit(1)
