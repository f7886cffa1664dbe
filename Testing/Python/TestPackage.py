# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the package says of itself: its version, its help, its classes' docstrings and constants."""

import pydoc
import re
import subprocess
import sys
import unittest

import airlight

CLASSES = [name for name in dir(airlight) if name.startswith("vtk")]


def run(*options):
    done = subprocess.run([sys.executable, "-m", "airlight", *options], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, timeout=60, check=False)
    return done.returncode, done.stdout


class TestPackage(unittest.TestCase):
    def test_command(self):
        code, text = run("--version")
        self.assertEqual(code, 0)
        self.assertRegex(text, rf"^airlight {re.escape(airlight.__version__)}, VTK \d+\.\d+\.\d+\n$")
        code, text = run()
        self.assertEqual((code, text.strip()), (0, airlight.__doc__.strip()))
        code, text = run("--nonsense")
        self.assertEqual(code, 2)
        self.assertIn("--nonsense", text)

    def test_help(self):
        text = pydoc.plain(pydoc.render_doc(airlight))
        self.assertIn("volumetric shadows in participating media", text)
        for name in CLASSES:
            self.assertRegex(text, rf"\n +{name} - \w")
        self.assertLess(len(text.splitlines()), 80)  # a screen or two

    def test_docstrings(self):
        self.assertIn("vtkAirlightPass", CLASSES)
        for name in CLASSES:
            doc = getattr(airlight, name).__doc__
            self.assertTrue(doc.startswith(name + " - "), name)
            self.assertGreater(len(doc), 300, name)
        text = airlight.vtkParticipatingMedium.SetVisibility.__doc__
        self.assertIn("SetVisibility(self, distance:float) -> None", text)
        self.assertIn("meteorological range", " ".join(text.split()))  # it is wrapped

    def test_constants(self):
        medium = airlight.vtkParticipatingMedium()
        medium.SetPhaseFunction(airlight.vtkRayleighPhaseFunction())  # for OBJECT
        kind = airlight.vtkParticipatingMedium.PhaseFunctionType
        constants = {name: value for name, value in vars(airlight.vtkParticipatingMedium).items()
                     if isinstance(value, kind)}
        self.assertEqual(sorted(constants.values()), list(range(len(constants))))
        self.assertGreaterEqual(len(constants), 8)
        for value in constants.values():
            self.assertIsInstance(value, int)
            medium.SetPhaseFunction(value)
            self.assertEqual(medium.GetPhaseFunction(), value)
        self.assertIs(type(constants["RAYLEIGH"]), kind)
        technique = airlight.vtkAirlightPass.SHADOW_MAP
        self.assertNotIsInstance(technique, kind)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
