# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Bad phase functions, tables, photometric files and surfaces: one line that names option or key,
file and culprit, exit code 1, no picture.

Run it like TestAirlightProgram.py.
"""

import json
import os
import unittest

from programtest import SOURCE, TETRAHEDRON, SceneTest

STREETLIGHT = os.path.join(SOURCE, "Testing", "Data", "Photometry", "streetlight.ies")

TABLES = (
    (b"", ["empty"]),
    (b"0,1\n", ["1 rows", "at least 2 rows"]),
    (b"angle,value\n0,1\n", ["1 rows", "at least 2 rows"]),
    (b"0\n90\n180\n", ["1 columns", "2 columns"]),
    (b"0,1\n90,2\n60,1\n", ["angle 60 in row 2", "ascend"]),
    (b"0,1\n90,2\n90,1\n", ["angle 90 in row 2"]),
    (b"0,1\n90,2\n181,1\n", ["angle 181 in row 2", "[0, 180]"]),
    (b"angle,value\n-1,1\n90,2\n", ["angle -1 in row 0"]),
    (b"0,1\n90,0\n180,1\n", ["value 0 in row 1", "above 0"]),
    (b"0,1\n90,-2\n180,1\n", ["value -2 in row 1"]),
    (b"0,1\n90,x\n180,1\n", ["value x in row 1"]),
    (b"0,1\n90,nan\n180,1\n", ["row 1"]),
    (b"0,1\n90,inf\n180,1\n", ["row 1"]),
    (b"0,1\n90\n180,1\n", ["row 1"]),
    (b"0,x\n90,1\n180,1\n", ["value x in row 0"]),
    (b"0,1\n90,1e-13\n180,1\n", ["1e12"]),
    (b"\0" * 100, ["columns"]),
    (b"\x89PNG\r\n\xff\xfe,\xff\n\xfe,\xfe\n", []),
)

OPEN = TETRAHEDRON.replace("f 1 4 3\n", "")


class TestBadFiles(SceneTest):
    def fail_twice(self, words, option, file, key, **medium):
        """As an option, and as the key of a scene file."""
        output = self.path("x.png")
        if option:
            errors = self.fail_with([option + " " + file + ": ", *words], "render", self.scene(),
                                    option, file, "-o", output)
            self.assertEqual(errors.count("\n"), 1, errors)
        scene = self.scene(**medium)
        errors = self.fail_with([scene + ":1: " + key + " cannot be used: ", file + ": ", *words],
                                "render", scene, "-o", output)
        self.assertEqual(errors.count("\n"), 1, errors)
        self.assertFalse(os.path.exists(output))

    def test_tables(self):
        for i, (content, words) in enumerate(TABLES):
            with self.subTest(content=content):
                file = self.write(f"{i}.csv", content)
                self.fail_twice(words, "--phase-table", file, "medium.phase.table",
                                phase={"type": "tabulated", "table": os.path.basename(file)})

    def test_surfaces(self):
        for i, (content, words) in enumerate((
                ("", ["empty"]), (OPEN, ["not closed: 3 edges"]), ("v 0 0 0\n", ["no polygons"]),
                (TETRAHEDRON + "f 1 2 99\n", ["points that it does not hold"]))):
            with self.subTest(content=content):
                file = self.write(f"{i}.obj", content)
                self.fail_twice(words, "--surface", file, "medium.bounds.mesh",
                                bounds={"type": "surface", "mesh": os.path.basename(file)})
        file = self.write("a.txt", TETRAHEDRON)
        self.fail_twice(["unknown kind of model", "ply"], "--surface", file, "medium.bounds.mesh",
                        bounds={"type": "surface", "mesh": "a.txt"})

    def test_photometry(self):
        with open(STREETLIGHT) as file:
            good = file.read()
        output = self.path("x.png")
        for i, (content, words) in enumerate((
                ("", ["empty"]), ("no photometry\n", [":1: "]),
                (good[:len(good) // 2], ["expected"]),
                (good.replace("236.4", "-236.4"), [":9: ", "-236.4"]),
                (good.replace("236.4", "nan"), [":9: ", "nan"]))):
            with self.subTest(content=content[:30]):
                bad = self.write(f"{i}.ies", content)
                for kind in (("--point", "1,2,3:4"), ("--spot", "1,2,3:4,5,6:30:7")):
                    errors = self.fail_with(["--ies " + bad + ":", *words], "render", self.scene(),
                                            *kind, "--ies", bad, "-o", output)
                    self.assertEqual(errors.count("\n"), 1, errors)
                scene = self.lamp_scene(photometry=f"{i}.ies")
                self.fail_with([scene + ":1: lights[0].photometry cannot be used: " + bad + ":",
                                *words], "render", scene, "-o", output)
                self.assertFalse(os.path.exists(output))

    def lamp_scene(self, **lamp):
        with open(self.scene()) as file:
            scene = json.load(file)
        scene["lights"] = [dict({"type": "point", "position": [1, 1, 2],
                                 "intensity": [100, 200, 300]}, **lamp)]
        return self.write("lamp.json", json.dumps(scene))

    def test_missing_files(self):
        output = ["-o", self.path("x.png")]
        for option in ("--phase-table", "--surface"):
            for name, words in (("none.csv", "no such file"), (self.folder, "folder"), ("", "")):
                self.fail_with([option + " " + name, words], "render", self.scene(), *output,
                               option, name)
        for name, words in (("none.ies", "no such file"), (self.folder, "folder"), ("", "")):
            self.fail_with(["--ies " + name, words], "render", self.scene(), *output, "--point",
                           "1,2,3:4", "--ies", name)
        for scene, key in (
                (self.lamp_scene(photometry="none.ies"), "lights[0].photometry"),
                (self.scene(phase={"type": "tabulated", "table": "none.csv"}),
                 "medium.phase.table")):
            self.fail_with([key, "does not exist", "none."], "render", scene, *output)
        scene = self.scene(bounds={"type": "surface", "mesh": "none.ply"})
        self.fail_with(["medium.bounds.mesh", "does not exist"], "render", scene, *output)
        self.assertFalse(os.path.exists(self.path("x.png")))


class TestBadUse(SceneTest):
    def test_phase_option(self):
        for text, word in (
                ("", "rayleigh"), ("mie", "mie_hazy"), ("Rayleigh", "rayleigh"),
                ("tabulated", "--phase-table"), ("rayleigh:0.5", "no parameter"),
                ("mie_hazy:", "no parameter"), ("schlick", "schlick:k"),
                ("schlick:", "schlick:k"), ("schlick:1", "0.99"), ("schlick:0.5:1", "schlick:k"),
                ("cornette_shanks:-1", "cornette_shanks:g"), ("henyey_greenstein:nan", "0.99"),
                ("henyey_greenstein", "henyey_greenstein:g"), ("draine:0.5", "draine:g:alpha"),
                ("draine:0.5:101", "0 to 100 for alpha"), ("draine:1:1", "-0.99 to 0.99 for g")):
            self.fail_with([f"--phase '{text}': expected ", word], "render", self.scene(), "-o",
                           self.path("x.png"), "--phase", text)

    def test_phase_keys(self):
        for phase, words in (
                ({"type": "mie"}, ["medium.phase.type", "mie_hazy", "tabulated", '"mie"']),
                ({"type": "rayleigh", "g": 0.5}, ["unknown key 'g' in medium.phase"]),
                ({"type": "schlick", "g": 0.5}, ["unknown key 'g'", "type, k"]),
                ({"type": "cornette_shanks"}, ["missing key 'g'"]),
                ({"type": "schlick", "k": 1}, ["medium.phase.k", "0.99"]),
                ({"type": "draine", "g": 0.5}, ["missing key 'alpha'"]),
                ({"type": "draine", "g": 0.5, "alpha": -1}, ["medium.phase.alpha", "100"]),
                ({"type": "schlick", "k": 0.5, "alpha": 1}, ["unknown key 'alpha'"]),
                ({"type": "tabulated"}, ["missing key 'table'"]),
                ({"type": "tabulated", "table": 3}, ["medium.phase.table", "string"])):
            self.fail_with(words, "render", self.scene(phase=phase), "-o", self.path("x.png"))

    def test_places(self):
        """A photometric file needs a lamp before it that has a place; its aim and turn need it."""
        point, sun, ies = ("--point", "1,2,3:4"), ("--sun", "1,2,3:4"), ("--ies", STREETLIGHT)
        spot = ("--spot", "1,2,3:4,5,6:30:7")
        for options, words in (
                ((*ies, *point), ["--ies", "behind the --point or --spot"]),
                (ies, ["--ies", "behind the --point or --spot"]),
                ((*point, *sun, *ies), ["--ies", "behind the --point or --spot"]),
                ((*point, *ies, *ies), ["--ies", "already"]),
                ((*point, "--ies-aim", "0,0,0"), ["--ies-aim", "behind the --ies FILE"]),
                ((*point, "--ies-up", "0,1,0", *ies), ["--ies-up", "behind the --ies FILE"]),
                ((*spot, *ies, "--ies-aim", "0,0,0"), ["--ies-aim", "--spot aims"]),
                ((*point, *ies, "--ies-aim", "1,2,3"), ["--ies-aim '1,2,3'", "another point"]),
                ((*point, *ies, "--ies-aim", "1,2"), ["--ies-aim '1,2'", "tx,ty,tz"]),
                ((*point, *ies, "--ies-up", "0,0,0"), ["--ies-up '0,0,0'", "other than 0"]),
                ((*point, *ies, "--ies-up", "x"), ["--ies-up 'x'", "ux,uy,uz"]),
                (("--no-medium", *point, *ies), ["--no-medium", "--ies"]),
                (("--no-medium", "--glow"), ["--no-medium", "--glow"]),
                (("--no-medium", "--phase", "rayleigh"), ["--no-medium", "--phase"]),
                (("--no-medium", "--surface", "a.ply"), ["--no-medium", "--surface"]),
                (("--no-medium", "--phase-table", "a"), ["--no-medium", "--phase-table"]),
                (("--phase", "rayleigh", "--anisotropy", "0"), ["--phase", "--anisotropy"]),
                (("--phase", "rayleigh", "--phase-table", "a"), ["--phase", "--phase-table"]),
                (("--anisotropy", "0.5", "--phase-table", "a"), ["--anisotropy", "--phase-table"]),
                (("--surface", "a.ply", "--box", "0,1,0,1,0,1"), ["--surface", "--box"]),
                (("--surface", "a.ply", "--sphere", "0,1,0:1"), ["--surface", "--sphere"])):
            with self.subTest(options=options):
                self.fail_with(words, "render", self.scene(), "-o", self.path("x.png"), *options)
        self.assertFalse(os.path.exists(self.path("x.png")))

    def test_keys(self):
        with open(self.scene()) as file:
            scene = json.load(file)
        point = scene["lights"][0]
        sun = {"type": "directional", "direction": [0, -1, 0], "irradiance": [1, 1, 1]}
        lamp = os.path.basename(STREETLIGHT)
        with open(STREETLIGHT) as file:
            self.write(lamp, file.read())
        for changes, words in (
                ({"scattered_surface_light": 1}, ["scattered_surface_light", "true or false", "1"]),
                ({"lights": [dict(point, direction=[0, 1, 0])]}, ["unknown key 'direction'"]),
                ({"lights": [dict(point, photometry_up=[0, 1, 0])]}, ["'photometry_up'"]),
                ({"lights": [dict(sun, photometry=lamp)]}, ["unknown key 'photometry'"]),
                ({"lights": [dict(point, photometry=lamp, photometry_up=[0, 0, 0])]},
                 ["lights[0].photometry_up", "zero"]),
                ({"lights": [dict(point, photometry=lamp, direction=[0, 0, 0])]},
                 ["lights[0].direction", "zero"]),
                ({"lights": [dict(point, photometry=7)]}, ["lights[0].photometry", "string"])):
            bad = self.write("bad.json", json.dumps(dict(scene, **changes)))
            self.fail_with([bad + ":1: ", *words], "render", bad, "-o", self.path("x.png"))
        for bounds, words in (
                ({"type": "surface"}, ["missing key 'mesh'"]),
                ({"type": "surface", "mesh": "a", "min": 1}, ["unknown key 'min'"]),
                ({"type": "cylinder", "center": [0, 0, 0], "radius": 1}, ["missing key 'height'"]),
                ({"type": "cylinder", "center": [0, 0, 0], "radius": 1, "height": 0},
                 ["medium.bounds.height", "0"]),
                ({"type": "cylinder", "center": [0, 0, 0], "radius": 1, "height": 2,
                  "axis": [0, 0, 0]}, ["medium.bounds.axis", "zero"]),
                ({"type": "cone"}, ["medium.bounds.type", "cylinder", "surface"])):
            self.fail_with(words, "render", self.scene(bounds=bounds), "-o", self.path("x.png"))


if __name__ == "__main__":
    unittest.main(argv=[__file__])
