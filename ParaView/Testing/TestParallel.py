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


class Parallel(unittest.TestCase):
    def run_scene(self, ranks, name):
        command = [str(RUN), "--run", "-n", str(ranks), str(HERE / "parallel_scene.py"), name]
        done = subprocess.run(command, capture_output=True, text=True, timeout=250)
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
            for step in ("fog", "moved", "cloud", "translucent", "off"):
                pictures[ranks, step] = test.read_png(test.OUTPUT / f"{name}-{step}.png")
        for step in ("fog", "moved", "cloud", "off"):
            serial = pictures[1, step]
            self.assertGreater(serial.std(), 5, "there is something to be seen")
            for ranks in (2, 4):
                difference = np.abs(pictures[ranks, step] - serial)
                print(f"{step}, {ranks} ranks: largest difference {difference.max()}, "
                      f"{np.count_nonzero(difference.max(axis=-1))} pixels")
                self.assertLessEqual(difference.max(), 1, (step, ranks))
        # What moved moved its shadow, too, on ranks that do not have it.
        self.assertGreater(np.mean(np.abs(pictures[1, "moved"] - pictures[1, "fog"]) > 3), 0.01)

        # Nothing is gathered on one rank; on several it is silhouettes, which are small beside the
        # polygons: those have 36 bytes at least each.
        gathered = {ranks: int(re.search(r"gathered (\d+) bytes", text)[1])
                    for ranks, text in texts.items()}
        cells = int(re.search(r"(\d+) cells", texts[1])[1])
        self.assertEqual(gathered[1], 0)
        for ranks in (2, 4):
            self.assertGreater(gathered[ranks], 48 * 4, "the plate's four edges, and more")
            self.assertLess(gathered[ranks], 36 * cells / 2)

        # A translucent surface is composited in order; that is said, once.
        for ranks in (1, 2, 4):
            self.assertEqual("rank by rank, without depth" in texts[ranks], ranks > 1)
            self.assertEqual("draws on one process only" in texts[ranks], ranks > 1)


if __name__ == "__main__":
    # pvpython loses its window where a script calls sys.exit() with a view open.
    if not unittest.main(argv=[__file__] + sys.argv[1:], exit=False).result.wasSuccessful():
        sys.exit(1)
