# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Two and four ranks of pvbatch draw what one does, shadows of what other ranks have included."""

import pathlib
import re
import subprocess
import sys
import unittest

import numpy as np

import paraviewtest as test

HERE = pathlib.Path(__file__).resolve().parent
RUN = HERE.parents[1] / "Utilities" / "paraview-test.sh"
# Pictures that are the same on any number of ranks.
SAME = ("fog", "selected", "moved", "cloud", "gradient", "clear", "off", "translucent", "refined",
        "exposed", "volume", "scattering", "whole")


def neighbours(picture):
    """The least and the greatest of each pixel and those around it."""
    wide = np.pad(picture, ((1, 1), (1, 1), (0, 0)), mode="edge")
    height, width, _ = picture.shape
    shifted = [wide[y:y + height, x:x + width] for y in range(3) for x in range(3)]
    return np.min(shifted, axis=0), np.max(shifted, axis=0)


class Parallel(unittest.TestCase):
    def run_scene(self, ranks, name):
        command = [str(RUN), "--run", "-n", str(ranks), str(HERE / "parallel_scene.py"), name]
        done = subprocess.run(command, capture_output=True, text=True, timeout=400)
        text = done.stdout + done.stderr
        self.assertEqual(done.returncode, 0, text)
        self.assertNotIn("ERR|", text)
        print(text.strip())
        return text

    def test_same_picture(self):
        pictures, texts = {}, {}
        for ranks in (1, 2, 4):
            name = f"ranks{ranks}"
            texts[ranks] = self.run_scene(ranks, name)
            for step in SAME + ("smooth", "parts"):
                pictures[ranks, step] = test.read_png(test.OUTPUT / f"{name}-{step}.png")
        for step in SAME:
            serial = pictures[1, step]
            self.assertGreater(serial.std(), 5, "there is something to be seen")
            for ranks in (2, 4):
                difference = np.abs(pictures[ranks, step] - serial)
                print(f"{step}, {ranks} ranks: largest difference {difference.max()}, "
                      f"{np.count_nonzero(difference.max(axis=-1))} pixels")
                self.assertLessEqual(difference.max(), 1, (step, ranks))
        # FXAA makes no dark fringes where ranks meet: it comes after they are composited.
        for ranks in (1, 2, 4):
            np.testing.assert_array_equal(pictures[ranks, "selected"], pictures[ranks, "fog"])
            low, high = neighbours(pictures[ranks, "fog"])
            seen = pictures[ranks, "smooth"]
            outside = np.maximum(low - seen, seen - high).max()
            print(f"{ranks} ranks: FXAA is at most {outside} outside of the neighbours' colours")
            self.assertLessEqual(outside, 2)
            self.assertLessEqual(np.abs(seen - pictures[1, "smooth"]).max(), 1)
            self.assertGreater(np.abs(seen - pictures[ranks, "fog"]).max(), 20)
        # What moved moved its shadow, too, on ranks that do not have it.
        self.assertGreater(np.mean(np.abs(pictures[1, "moved"] - pictures[1, "fog"]) > 3), 0.01)

        # Nothing is gathered on one rank; on several it is silhouettes, which are small beside the
        # polygons: those have 36 bytes at least each.
        gathered = {ranks: int(re.search(r"gathered (\d+) bytes", text)[1])
                    for ranks, text in texts.items()}
        cells = int(re.search(r"(\d+) cells", texts[1])[1])
        self.assertEqual(gathered[1], 0)
        left = {ranks: int(re.search(r"(\d+) pixels left out", text)[1])
                for ranks, text in texts.items()}
        print(f"pixels that the first rank leaves out: {left}")
        self.assertEqual(left[1], 0)
        for ranks in (2, 4):
            self.assertGreater(left[ranks], 500)
        for ranks in (2, 4):
            self.assertGreater(gathered[ranks], 48 * 4, "the plate's four edges, and more")
            self.assertLess(gathered[ranks], 36 * cells / 2)

        for before, after in (("cloud", "gradient"), ("cloud", "translucent"),
                              ("translucent", "refined"), ("translucent", "exposed"),
                              ("translucent", "volume"), ("volume", "scattering")):
            changed = np.abs(pictures[1, after] - pictures[1, before]) > 3
            self.assertGreater(np.mean(changed), 0.005, (before, after))
        np.testing.assert_array_equal(pictures[1, "parts"], pictures[1, "scattering"])
        # Above the limit, each rank draws a part; that is said, once by each.
        for ranks in (1, 2, 4):
            self.assertEqual(texts[ranks].count("Each rank draws its own part"),
                             ranks if ranks > 1 else 0)
            self.assertEqual("draws on one process only" in texts[ranks], ranks > 1)


if __name__ == "__main__":
    # pvpython loses its window where a script calls sys.exit() with a view open.
    if not unittest.main(argv=[__file__] + sys.argv[1:], exit=False).result.wasSuccessful():
        sys.exit(1)
