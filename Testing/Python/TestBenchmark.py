# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the benchmark of frames and looks at what it prints and writes, whatever the times are."""

import csv
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy as np

PROGRAM = os.environ["AIRLIGHT_BENCHMARK"]
FRAMES = 2
SCENES = ["small", "lights/1", "lights/4", "sizes/400x300", "sizes/800x600", "triangles/10000",
          "triangles/100000"]
BRIEF = ["plain", "no shadows", "shadow planes"]
MARCH = "equiangular march to 2e-3"
SMALL = BRIEF + ["shadow map, 64 steps"] + [
    f"equiangular march, {steps} steps" for steps in (32, 64, 256, 1024, 2048)] + [MARCH]


def run(*arguments, **environment):
    return subprocess.run([PROGRAM, *arguments], check=False, text=True, timeout=600,
                          env={**os.environ, **environment}, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE)


def logarithmic_slope(x, y):
    """NaN unless all are above 0."""
    return np.polyfit(np.log(x), np.log(y), 1)[0] if min(y) > 0 else np.nan


class TestBenchmark(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            paths = {kind: pathlib.Path(folder) / f"results.{kind}"
                     for kind in ("json", "csv", "markdown")}
            options = [f"--{kind}={path}" for kind, path in paths.items()]
            cls.done = run(*SCENES, f"--frames={FRAMES}", "--size", "160", "120", "--errors",
                           *options)
            if cls.done.returncode:
                raise AssertionError(cls.done.stderr)
            text = {kind: path.read_text(encoding="utf-8") for kind, path in paths.items()}
        cls.results = json.loads(text["json"])
        cls.table = list(csv.DictReader(text["csv"].splitlines()))
        cls.markdown = text["markdown"]
        cls.rows = {(row["scene"], row["technique"]): row for row in cls.results["rows"]}

    def median(self, kind, scene, way):
        return np.median(self.rows[scene, way][kind]["seconds"])

    def excess(self, kind, scene, way, other="plain"):
        return self.median(kind, scene, way) - self.median(kind, scene, other)

    def test_says_only_what_it_does(self):
        self.assertEqual(self.done.stderr.splitlines(), [scene + " ..." for scene in SCENES])
        self.assertEqual(self.done.stdout, self.markdown)

    def test_rows(self):
        names = [(scene, way) for scene in SCENES for way in (SMALL if scene == "small" else BRIEF)]
        self.assertEqual([(row["scene"], row["technique"]) for row in self.results["rows"]], names)
        for (scene, _), row in self.rows.items():
            for kind in ("clock", "processors"):
                times = row[kind]
                self.assertEqual(len(times["seconds"]), FRAMES)
                self.assertGreater(min(times["seconds"]), 0)
                expected = np.quantile(times["seconds"], (0.25, 0.5, 0.75))
                found = [times[key] for key in ("lower_quartile", "median", "upper_quartile")]
                np.testing.assert_allclose(found, expected, rtol=1e-9)
                plain = self.median(kind, scene, "plain")
                self.assertAlmostEqual(times["ratio"], times["median"] / plain, places=9)
            size = [int(n) for n in scene[6:].split("x")] if "sizes" in scene else [160, 120]
            self.assertEqual([row["width"], row["height"]], size)

    def test_counts(self):
        # 24 x 25 spheres, the floor's one square; each lamp sees its four sides and the spheres'
        # outlines, each of which goes at least once from pole to pole and back or once around.
        small = self.rows["small", "plain"]
        self.assertEqual(small["triangles"], 25 * 2 * 24 * 23 + 2)
        self.assertTrue(25 * 24 + 4 <= small["edges"] <= 25 * 4 * 24 + 4)
        # A disc of 256 sides: one triangle for each in the innermost ring, two in all others.
        disc = self.rows["triangles/100000", "plain"]
        self.assertEqual(disc["edges"], 256 + 4)
        self.assertEqual((disc["triangles"] - 2) % 512, 256)
        self.assertAlmostEqual(disc["triangles"], 100000, delta=512)

    def test_errors(self):
        for scene in SCENES:
            self.assertIsNone(self.rows[scene, "plain"]["error"])
            self.assertLess(self.rows[scene, "shadow planes"]["error"], 2e-5, scene)
            self.assertGreater(self.rows[scene, "no shadows"]["error"], 1e-3, scene)
        marches = [self.rows["small", f"equiangular march, {steps} steps"]
                   for steps in (32, 64, 256, 1024)]
        self.assertEqual([row["steps"] for row in marches], [32, 64, 256, 1024])
        self.assertTrue(np.all(np.diff([row["error"] for row in marches]) < 0))
        march = self.rows["small", MARCH]
        self.assertEqual(march["target"], 2e-3)
        self.assertLessEqual(march["error"], 2e-3)
        # The steps that are too few are fewer, those that are too many are more.
        for row in marches:
            self.assertEqual(row["steps"] >= march["steps"], row["error"] <= 2e-3)

    def test_same_in_csv_and_markdown(self):
        self.assertEqual(len(self.table), len(self.rows))
        for line in self.table:
            row = self.rows[line["scene"], line["technique"]]
            self.assertEqual(line["renderer"], self.results["machine"]["opengl_renderer"])
            for key in ("width", "height", "triangles", "edges", "steps", "target", "error"):
                if row[key] is None:
                    self.assertEqual(line[key], "")
                else:
                    np.testing.assert_allclose(float(line[key]), row[key], rtol=1e-8)
            for prefix, times in (("", row["clock"]), ("processors_", row["processors"])):
                for name in ("lower_quartile", "upper_quartile", "ratio"):
                    value = line[prefix + name + ("" if name == "ratio" else "_s")]
                    np.testing.assert_allclose(float(value), times[name], rtol=1e-5)
            np.testing.assert_allclose(float(line["median_s"]), row["clock"]["median"], rtol=1e-5)
            cells = f"| {line['technique']}{', %d steps' % row['steps'] if row['target'] else ''} |"
            self.assertIn(f"{cells} {1e3 * row['clock']['median']:.2f} |", self.markdown)

    def test_machine(self):
        machine = self.results["machine"]
        self.assertTrue(machine["opengl_vendor"] and machine["opengl_version"])
        self.assertIn(machine["opengl_renderer"], self.markdown.splitlines()[0])
        self.assertEqual(machine["software"], "llvmpipe" in machine["opengl_renderer"])
        self.assertEqual("software" in self.markdown.splitlines()[0], machine["software"])

    def expected_figures(self, kind):
        """The derived figures, from the single frames."""
        figures = {}
        for name, other in (("extra", "plain"), ("beyond no shadows", "no shadows")):
            figures[f"small: {MARCH} / shadow planes, {name}"] = (
                self.excess(kind, "small", MARCH, other),
                self.excess(kind, "small", "shadow planes", other))
        figures[f"small: {MARCH} / shadow planes, frame"] = (
            self.median(kind, "small", MARCH), self.median(kind, "small", "shadow planes"))
        for way in ("no shadows", "shadow planes"):
            figures[f"lights/4: extra / that of one light, {way}"] = (
                self.excess(kind, "lights/4", way), self.excess(kind, "lights/1", way))
            times = []
            for width, height in ((400, 300), (800, 600)):
                scene = f"sizes/{width}x{height}"
                times.append(1e3 * self.excess(kind, scene, way) / (1e-6 * width * height))
                figures[f"{scene}: extra, ms per megapixel, {way}"] = times[-1]
            figures[f"sizes: largest / smallest of these, {way}"] = (max(times), min(times))
            mean = np.mean(times)
            figures[f"sizes: largest deviation from their mean, percent, {way}"] = (
                100 * np.abs(times - mean).max(), mean)
        # Ratios of what is not above 0 are not given.
        figures = {name: value if np.isscalar(value) else
                   value[0] / value[1] if min(value) > 0 else np.nan
                   for name, value in figures.items()}
        scenes = ["triangles/10000", "triangles/100000"]
        triangles = [self.rows[scene, "plain"]["triangles"] for scene in scenes]
        extra = [self.excess(kind, scene, "shadow planes") for scene in scenes]
        shadows = [self.excess(kind, scene, "shadow planes", "no shadows") for scene in scenes]
        slope, start = np.polyfit(triangles, shadows, 1)
        figures.update({
            "triangles: exponent of extra in triangles": logarithmic_slope(triangles, extra),
            "triangles: exponent of shadows in triangles": logarithmic_slope(triangles, shadows),
            "triangles: shadows, ns for each of triangles (straight line)": 1e9 * slope,
            "triangles: shadows, ms for none of triangles (straight line)": 1e3 * start})
        return figures

    def test_figures(self):
        found = {figure["name"]: figure for figure in self.results["figures"]}
        for kind in ("clock", "processors"):
            expected = self.expected_figures(kind)
            self.assertEqual(sorted(found), sorted(expected))
            for name, value in expected.items():
                if np.isnan(value):
                    self.assertIsNone(found[name][kind], name)
                else:
                    np.testing.assert_allclose(found[name][kind], value, rtol=1e-6, err_msg=name)
                    cell = f"{value:.3g}"
                    line = next(line for line in self.markdown.splitlines()
                                if line.startswith(f"| {name} |"))
                    self.assertIn(f" {cell} ", line)

    def test_content(self):
        """Every kind of content is drawn beside the ball and floor; the worst is on top."""
        ways = ["plain", "no shadows", "automatic", "shadow map, 64 steps"]
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "content.json"
            done = run("content", "--frames=1", "--size", "64", "48", f"--json={path}")
            self.assertEqual(done.returncode, 0, done.stderr)
            results = json.loads(path.read_text(encoding="utf-8"))
        scenes = [name for name in run("--list").stdout.splitlines() if name.startswith("content/")]
        self.assertGreaterEqual(len(scenes), 25)
        rows = {(row["scene"], row["technique"]): row["processors"]["median"]
                for row in results["rows"]}
        self.assertEqual(sorted(rows), sorted((scene, prefix + way) for scene in scenes
                                              for prefix in ("", "ball and floor, ")
                                              for way in ways))
        found = [figure for figure in results["figures"] if figure["name"].endswith(", automatic")]
        costs = [figure["processors"] for figure in found[:-1]]
        self.assertEqual(len(costs), len(scenes) - 1)  # one has nothing beside the ball and floor
        known = [cost for cost in costs if cost is not None]
        self.assertEqual(known, sorted(known, reverse=True))
        for figure in found[:-1]:
            scene = figure["name"].split(":")[0]
            extra, base = (rows[scene, prefix + "automatic"] - rows[scene, prefix + "plain"]
                           for prefix in ("", "ball and floor, "))
            if min(extra, base) > 0:
                self.assertAlmostEqual(figure["processors"] * base / extra, 1, places=6)
            else:
                self.assertIsNone(figure["processors"])
        self.assertEqual(found[-1]["name"], "content: median of these, automatic")

    def test_user_errors(self):
        done = run("nosuch")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertEqual(done.stderr, "error: no scene is called 'nosuch'; --list names them\n")
        done = run("small", "--json=/nowhere/results.json")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertEqual(done.stderr, "error: cannot write /nowhere/results.json\n")
        done = run("small", DISPLAY="")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertRegex(done.stderr, "^error: DISPLAY names no X server; take --egl, or ")

    def test_list(self):
        names = run("--list").stdout.splitlines()
        self.assertEqual(len(names), len(set(names)))
        others = ["heavy", "shafts", "mesh/3000000", "edges/2048", "moving"]
        self.assertTrue(set(SCENES + others) <= set(names))

    def test_egl(self):
        done = run("--egl", "--info", DISPLAY="")
        if done.returncode:
            self.assertRegex(done.stderr, "(?m)^error: --egl: ")
            self.skipTest(done.stderr)
        self.assertEqual(done.stderr, "")
        found = dict(line.split(": ", 1) for line in done.stdout.splitlines())
        self.assertEqual(sorted(found), ["renderer", "software", "vendor", "version"])
        self.assertTrue(all(found.values()), found)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
