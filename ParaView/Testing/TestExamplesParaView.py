# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The scripts of Examples/ParaView run as a user runs them, and their pictures are looked into."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import paraviewtest as test

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "Examples" / "ParaView"
COW = ROOT / "Examples" / "Data" / "meshes" / "cow.ply"


class Examples(unittest.TestCase):
    ran = set()

    def run_example(self, name, *arguments, ranks=0):
        command = [ROOT / "Utilities" / "paraview-test.sh", "--run"]
        command += ["-n", ranks] if ranks else []
        command += [EXAMPLES / name, *arguments]
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True,
                              timeout=120)
        text = done.stdout + done.stderr
        self.assertEqual(done.returncode, 0, text)
        self.assertNotIn("ERR|", text)
        Examples.ran.add(name)
        return text

    def test_fog_in_stock_scene(self):
        """The same picture with thinner fog has more contrast."""
        contrast = []
        for visibility in (150, 1500):
            path = test.OUTPUT / f"fog_in_stock_scene-{visibility}.png"
            self.run_example("fog_in_stock_scene.py", "-o", path, "--visibility", visibility)
            contrast.append(test.read_png(path).std())
        self.assertGreater(contrast[1], 1.5 * contrast[0])

    def test_shafts_through_clip(self):
        path = test.OUTPUT / "shafts_through_clip.png"
        self.run_example("shafts_through_clip.py", COW, "-o", path)
        # The lamp's light is warm, ParaView's own nearly white: red less blue is the lamp's.
        red, _, blue = np.moveaxis(test.read_png(path), -1, 0)
        lamp = red - blue
        # Behind the cut the air is lit, before the mesh and below the shaft it is not.
        self.assertGreater(lamp[:150, 300:400].mean(), 5 * lamp[:150, :100].mean())
        self.assertGreater(lamp[20, 300:].mean(), 3 * lamp[280, :40].mean())

    def test_state_file(self):
        with tempfile.TemporaryDirectory() as folder:
            self.run_example("state_file.py", "-o", folder)
            before, after = (test.read_png(f"{folder}/{name}.png") for name in ("before", "after"))
            text = pathlib.Path(folder, "fog.pvsm").read_text()
        np.testing.assert_array_equal(after, before)
        self.assertGreater(before.std(), 10)
        self.assertIn("AirlightRenderView", text)

    def test_animation(self):
        """The posts fade frame by frame: white in clear air, lost in fog."""
        with tempfile.TemporaryDirectory() as folder:
            self.run_example("animation.py", "-o", folder, "--frames", 4)
            frames = [test.read_png(f"{folder}/fog.{i:04}.png") for i in range(4)]
        contrast = [frame.std() for frame in frames]
        print("contrast of the frames:", contrast)
        self.assertTrue(all(a > b for a, b in zip(contrast, contrast[1:])), contrast)
        self.assertGreater(contrast[0], 2 * contrast[-1])

    def test_parallel(self):
        pictures = []
        for ranks in (1, 2):
            path = test.OUTPUT / f"parallel-{ranks}.png"
            text = self.run_example("parallel.py", COW, "-o", path, ranks=ranks)
            pictures.append(test.read_png(path))
            self.assertEqual("gathered: 0 bytes" in text, ranks == 1, text)
        self.assertGreater(pictures[0].std(), 10)
        self.assertLessEqual(np.abs(pictures[0] - pictures[1]).max(), 1)

    def test_documentation(self):
        """The scripts in Documentation/paraview.md, one after the other."""
        text = (ROOT / "Documentation" / "paraview.md").read_text()
        smoke, sources, view, attached = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
        view = view.replace('"AirlightParaView.so"', repr(os.environ["AIRLIGHT_PLUGIN"]))
        with tempfile.TemporaryDirectory() as folder:
            script = pathlib.Path(folder, "script.py")
            script.write_text(view + "view.ViewSize = [160, 120]\n"
                              "Show(Sphere(), view)\nRender(view)\n"
                              + smoke + "Render(view)\nHide(view=view)\n"
                              + sources.replace("\n\n", "\nRender(view)\n")
                              + "Render(view)\nDelete(view)\n"
                              "view = CreateView('RenderView')\nShow(Sphere(), view)\n" + attached
                              + "Render(view)\nprint(fog_pass.GetEffectiveShadowTechnique())\n")
            # By shadow planes: a light of ParaView's casts.
            self.assertIn("\n1\n", "\n" + self.run_example(script))

    @classmethod
    def tearDownClass(cls):
        missing = {path.name for path in EXAMPLES.glob("*.py")} - cls.ran
        if missing and len(sys.argv) == 1:
            raise AssertionError(f"not run: {missing}")


if __name__ == "__main__":
    # pvpython loses its window where a script calls sys.exit() with a view open.
    if not unittest.main(argv=[__file__] + sys.argv[1:], exit=False).result.wasSuccessful():
        sys.exit(1)
