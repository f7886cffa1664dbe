# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Bad input to the programs: a message that names file, line and key, exit code 1, never a crash.

Run it like TestAirlightProgram.py.
"""

import os
import struct
import unittest

import numpy as np

from programtest import (TETRAHEDRON, ProgramTest, reference_file, scene_file, write_models,
                         write_pfm)


NOT_FINITE = """ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
element face 1
property list uchar int vertex_indices
end_header
0 0 0
1 0 nan
0 1 0
3 0 1 2
"""


# Pieces of scene files.
BOX = """"type": "box",
   "min": [
    -25,
    -5,
    -25
   ],
   "max": [
    25,
    25,
    25
   ]"""
SPHERE = '"type": "sphere",\n"center": %s,\n"radius": %%s'
FOG = '"density": %s, "bounds"'
HEIGHTS = '{"type": "%s", "reference_height": 0, "scale_height": %s, "up": [0, %s, 0]}'


class TestBadModels(ProgramTest):
    def test_damaged_models(self):
        """VTK's readers crash on some of these; the program says which file it was."""
        for name in write_models(self.path):
            with open(self.path(name), "rb") as file:
                content = file.read()
            stem, extension = name.split(".")
            pieces = [b"", b"\0" * 100, content[:20]]
            if name not in ("a.obj", "b.obj"):  # half of one is a smaller model
                pieces += [content[:len(content) * k // 10] for k in (3, 5, 7, 9)]
            for i, piece in enumerate(pieces):
                bad = self.write(f"{stem}{i}.{extension}", piece)
                self.fail_with([bad], "render", bad, "-o", self.path("x.png"))
                self.assertFalse(os.path.exists(self.path("x.png")))

    def test_binary_models(self):
        """A triangle as .ply in both orders of bytes, whole and each time with less of its end."""
        for order, name in ((">", "big"), ("<", "little")):
            header = NOT_FINITE.replace("ascii", f"binary_{name}_endian")
            header = header[:header.index("0 0 0")].encode()
            face = struct.pack(order + "B3i", 3, 0, 1, 2)
            vertices = struct.pack(order + "9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)
            good = self.write(f"{name}.ply", header + vertices + face)
            self.succeed("render", good, "-o", self.path("x.png"), "--size", "16x12")
            for left, words in ((12, "face 0 of 1"), (0, "face 0 of 1"), (-1, "vertex 2 of 3")):
                content = header + (vertices + face)[:len(vertices) + left]
                bad = self.write(f"{name}.ply", content)
                self.fail_with([bad, "ends before the last number of " + words], "render", bad,
                               "-o", self.path("x.png"))
            bad = self.write(f"{name}.ply", header[:-1])
            self.fail_with([bad, "vertex 0 of 3"], "render", bad, "-o", self.path("x.png"))

    def test_impossible_models(self):
        for name, text, words in (
                ("c.obj", TETRAHEDRON + "f 1 2 99\n", ["points that it does not hold"]),
                ("c.ply", NOT_FINITE, [":11: 'nan' of vertex 1", "not finite"]),
                ("c.ply", NOT_FINITE.replace("nan", "1,"), [":11: ',' of vertex 2"]),
                ("c.ply", NOT_FINITE.replace("nan", "0").replace("3 0 1 2", "4 0 1 2"),
                 ["ends before the last number of face 0 of 1"]),
                ("c.ply", NOT_FINITE.replace("nan", "0").replace("3 0 1 2", "3 0 1 9"),
                 ["points that it does not hold"]),
                ("c.obj", "v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n", ["no extent"]),
                ("c.obj", "v 0 0 0\nv 0 0 0\nl 1 2\n", ["no extent"]),
                ("c.obj", TETRAHEDRON + "v nan 0 0\n", ["c.obj:", "three finite numbers"]),
                ("c.obj", TETRAHEDRON + "v 1 2\n", ["c.obj:", "three finite numbers"]),
                ("c.txt", TETRAHEDRON, ["unknown kind of model", "gltf"])):
            bad = self.write(name, text)
            self.fail_with([bad, *words], "render", bad, "-o", self.path("x.png"))


class TestBadScenes(ProgramTest):
    """Every complaint about a scene file names file, line and key."""

    CASES = (
        # (text to replace, replacement, line, words)
        ('"sigma_s"', '"sigma_z"', 27, ["unknown key 'sigma_z' in medium", "known keys: sigma_s"]),
        ('"camera"', '"kamera"', 8, ["unknown key 'kamera'"]),
        ('"height": 120', '"height": 120, "depth": 3', 6, ["unknown key 'depth' in image"]),
        ('"height": 120', '"height": 120,', 7, ["malformed JSON"]),
        ('"g": 0.0', '"h": 0.0', 39, ["unknown key 'h' in medium.phase"]),
        (',\n   "g": 0.0', '', 37, ["missing key 'g' in medium.phase"]),
        ('"width": 160', '"width": -160', 5, ["image.width", "-160"]),
        ('"width": 160', '"width": 0', 5, ["image.width"]),
        ('"width": 160', '"width": 16385', 5, ["image.width", "16384"]),
        ('"width": 160', '"width": 160.5', 5, ["image.width", "whole number"]),
        ('"width": 160', '"width": "160"', 5, ["image.width"]),
        ('"width": 160', '"width": 160, "width": 160', 5, ["'width' is given twice"]),
        ('   0.08,\n   0.08,', '   NaN,\n   0.08,', 28, ["malformed JSON"]),
        ('   0.08,\n   0.08,', '   0.08,\n   1e999,', 29, ["1e999"]),
        ('   0.08,\n   0.08,', '   0.08,\n   -0.08,', 29, ["medium.sigma_s[1]", "-0.08"]),
        ('   0.08,\n   0.08,', '   0.08,', 27, ["medium.sigma_s", "3 numbers"]),
        ('   0.08,\n   0.08,', '   0.08,\n   null,', 29, ["medium.sigma_s[1]", "null"]),
        ('"g": 0.0', '"g": 1.0', 39, ["medium.phase.g", "0.99"]),
        ('"henyey_greenstein"', '"mie"', 38, ["medium.phase.type", "isotropic"]),
        ('"box"', '"cone"', 42, ["medium.bounds.type", "sphere"]),
        ('"box"', '"sphere"', 48, ["unknown key 'max'", "center, radius"]),
        (BOX, SPHERE % "[0, 0]" % 1, 43, ["medium.bounds.center", "3 numbers"]),
        (BOX, SPHERE % "[0, 0, 0]" % -1, 44, ["medium.bounds.radius", "-1"]),
        (',\n   "min"', ',\n   "center": [0, 0, 0],\n   "min"', 43, ["unknown key 'center'"]),
        ('"bounds"', FOG % "3", 41, ["medium.density", "object", "scale_height"]),
        ('"bounds"', FOG % '{"type": "linear"}', 41, ["missing key 'reference_height'"]),
        ('"bounds"', FOG % HEIGHTS % ("linear", 1, 0), 41, ["medium.density.type", "linear"]),
        ('"bounds"', FOG % HEIGHTS % ("exponential_height", 0, 1), 41, ["density.scale_height"]),
        ('"bounds"', FOG % HEIGHTS % ("exponential_height", 1, 0), 41, ["density.up", "zero"]),
        ('    -25,\n', '    26,\n', 43, ["medium.bounds.min", "max"]),
        ('"point"', '"area"', 57, ["lights[0].type", "directional"]),
        ('    30.0,', '    -30.0,', 64, ["lights[0].intensity[0]"]),
        ('"view_angle_deg": 40.0', '"view_angle_deg": 180', 24, ["camera.view_angle_deg"]),
        ('   0,\n   1,\n   0\n', '   0,\n   0,\n   0\n', 19, ["camera.view_up"]),
        ('    0.5,\n    0.25', '    1.5,\n    0.25', 82, ["surfaces[1].albedo[0]"]),
        ('"meshes/s3_box.ply"', '3', 80, ["surfaces[1].mesh", "string"]),
        ('meshes/s3_box.ply', 'meshes/none.ply', 80, ["surfaces[1].mesh", "none.ply"]),
        ('meshes/s3_box.ply', 'cut.ply', 80, ["surfaces[1].mesh", "cut.ply"]),
        ('"surfaces": [', '"surfaces": 3, "more": [', 70, ["unknown key 'more'"]),
    )

    def test_table(self):
        with open(scene_file("S3_ground_occluders")) as file:
            good = file.read()
        with open(os.path.join(os.path.dirname(scene_file("")), "..", "meshes",
                               "s3_box.ply")) as file:
            mesh = file.read()
        for name in ("ground", "box", "sphere"):
            self.write(f"meshes/s3_{name}.ply", mesh)
        self.write("cut.ply", mesh[:len(mesh) // 2])
        scene = self.write("bad.json", good)
        self.succeed("render", scene, "-o", self.path("good.png"))
        for old, new, line, words in self.CASES:
            with self.subTest(old=old, new=new):
                self.assertIn(old, good)
                self.write("bad.json", good.replace(old, new, 1))
                self.fail_with([f"{scene}:{line}: ", *words], "render", scene, "-o",
                               self.path("x.png"))

    def test_files(self):
        output = self.path("x.png")
        empty = self.write("empty.json", "")
        self.fail_with([empty, "empty"], "render", empty, "-o", output)
        self.fail_with(["none.json", "no such file"], "render", "none.json", "-o", output)
        self.fail_with([self.folder, "folder"], "render", self.folder, "-o", output)
        for text in ("[" * 100000, '{"a":' * 100000, "null", "[1, 2]", "\\", "\xff\xfe", "{}"):
            bad = self.write("bad.json", text.encode("latin-1"))
            self.fail_with([bad + ":1: "], "render", bad, "-o", output)

    def test_options(self):
        scene = scene_file("S1_point_iso")
        output = ["-o", self.path("x.png")]
        for options, words in (
                (["--no-such-option"], ["--no-such-option"]),
                (["--size", "10"], ["--size '10'", "WxH"]),
                (["--size", "0x10"], ["--size '0x10'"]),
                (["--size", "99999x10"], ["--size", "16384"]),
                (["--visibility", "0"], ["--visibility '0'"]),
                (["--visibility", "nan"], ["--visibility 'nan'"]),
                (["--scattering", "1,2"], ["--scattering '1,2'", "r,g,b"]),
                (["--scattering", "1,2,inf"], ["--scattering"]),
                (["--absorption=-1,2,3"], ["--absorption '-1,2,3'"]),
                (["--anisotropy", "1"], ["--anisotropy '1'", "0.99"]),
                (["--point", "1,2,3"], ["--point '1,2,3'", "x,y,z:I"]),
                (["--point", "1,2,3:4:5"], ["--point"]),
                (["--box", "1,2,3,4,5,6", "--sphere", "1,2,3:4"], ["--box", "--sphere"]),
                (["--box", "0,1,0,1,0,1", "--box", "0,1,0,1,0,1"], ["--box"]),
                (["--no-medium", "--box", "0,1,0,1,0,1"], ["--no-medium"]),
                (["--cylinder", "1,2,3:4:5", "--sphere", "1,2,3:4"], ["--cylinder", "--sphere"]),
                (["--no-medium", "--sphere", "1,2,3:4"], ["--no-medium"]),
                (["--no-medium", "--height-fog", "0:1"], ["--no-medium"]),
                (["--camera", "1,2,3:1,2,3"], ["--camera"]),
                (["--camera", "1,2,3:0,0,0:200"], ["--camera"]),
                (["--exposure", "-1"], ["--exposure '-1'"]),
                (["--buffer", "Nothing"], ["--buffer", "Radiance"]),
                (["--technique", "Magic"], ["--technique", "ShadowPlanes", "RayMarch"]),
                (["--steps", "0"], ["--steps", "2048"]),
                (["--antialiasing", "0"], ["--antialiasing", "1024"]),
                (["--antialiasing", "4", "--reference"], ["--antialiasing", "--reference"]),
                (["--no-medium", "--visibility", "3"], ["--no-medium"]),
                (["--exposure", "0"], ["--exposure '0'", "auto"]),
                (["--tone-mapping", "clamp", "--buffer", "Depth"], ["--tone-mapping"]),
                (["--exposure", "auto", "--buffer", "Depth"], ["--exposure auto"]),
                (["--tone-mapping", "gamma"], ["--tone-mapping", "gamma"]),
                (["--no-dithering", "--reference"], ["--no-dithering", "--reference"])):
            with self.subTest(options=options):
                self.fail_with(words, "render", scene, *output, *options)
        self.fail_with(["x.jpg", "png, pfm, tiff, exr"], "render", scene, "-o", "x.jpg")
        missing = os.path.join(self.folder, "none", "x.pfm")
        self.fail_with([missing, "folder"], "render", scene, "-o", missing)


class TestBadOptions(ProgramTest):
    """One line that names the option, the value and the form, of `render` and `view` alike."""

    CASES = {
        ("--point", "x,y,z:I"): (
            "", "1,2,3", "1,2,3:", ":4", "1,2:4", "1,2,3,4:4", "1,2,3:4,5", "1,2,3:4,5,6,7",
            "1,2,3:-4", "1,2,3:4,-5,6", "1,2,x:4", "1,2,3:nan", "1,inf,3:4", "1,2,3:4:5",
            "1,2,3: 4", "1e31,2,3:4", "1,2,3:1e31"),
        ("--spot", "x,y,z:tx,ty,tz:ANGLE:I:EXPONENT"): (
            "", "1,2,3:4", "1,2,3:4,5,6", "1,2,3:4,5,6:30", "1,2,3:4,5,6:30:", "1,2:4,5,6:30:7",
            "1,2,3:4,5:30:7", "1,2,3:1,2,3:30:7", "1,2,3:4,5,6:0:7", "1,2,3:4,5,6:90:7",
            "1,2,3:4,5,6:-30:7", "1,2,3:4,5,6:nan:7", "1,2,3:4,5,6:30,30:7", "1,2,3:4,5,6:30:-7",
            "1,2,3:4,5,6:30:7,8", "1,2,3:4,5,6:30:inf", "1,2,3:4,5,6:30:7:", "1,2,3:4,5,6:30:7:-1",
            "1,2,3:4,5,6:30:7:129", "1,2,3:4,5,6:30:7:2:1", "0,0,0:1e-170,0,0:30:7",
            "1,2,3:4,5,1e31:30:7"),
        ("--sun", "dx,dy,dz:E"): (
            "", "1,2,3", "1,2,3:", "0,0,0:4", "1,2:4", "1,2,3:-4", "1,2,3:4,5", "1,2,3:nan",
            "1,nan,3:4", "1,2,3:4:5", "sun:4"),
        ("--ambient", "r,g,b"): ("", "1", "1,2", "1,2,-3", "1,2,3,4", "1,2,nan"),
        ("--box", "xmin,xmax,ymin,ymax,zmin,zmax"): (
            "", "1", "0,1,0,1,0", "0,1,0,1,0,1,0", "1,0,0,1,0,1", "0,1,1,0,0,1", "0,1,0,1,1,0",
            "0,1,0,1,0,inf", "0,1,0,1,0,1e31", "0,1,0,1,0,", "0:1,0,1,0,1"),
        ("--sphere", "x,y,z:R"): (
            "", "1,2,3", "1,2,3:", "1,2:4", "1,2,3:-4", "1,2,3:nan", "1,2,3:4,4", "1,2,3:4:5",
            "1,2,3:1e31"),
        ("--cylinder", "x,y,z:R:H"): (
            "", "1,2,3", "1,2,3:4", "1,2,3:4:", "1,2:4:5", "1,2,3:-4:5", "1,2,3:nan:5",
            "1,2,3:4:0", "1,2,3:4:-5", "1,2,3:4:inf", "1,2,3:4:5:0,0,0", "1,2,3:4:5:1,2",
            "1,2,3:4:5:0,1,0:6"),
        ("--height-fog", "REFERENCE:SCALE:ux,uy,uz"): (
            "", "1", "1:", ":1", "1:0", "1:-1", "nan:1", "1:inf", "1e31:1", "1:1e31", "1:2:0,0,0",
            "1:2:", "1:2:1,2", "1:2:0,1,0:3", "1,2"),
    }

    def test_table(self):
        scene = scene_file("S1_point_iso")
        output = self.path("x.png")
        for (option, form), values in self.CASES.items():
            for value in values:
                with self.subTest(option=option, value=value):
                    errors = self.fail_with([f"airlight: {option} '{value}': expected ", form],
                                            "render", option, value, scene, "-o", output)
                    self.assertEqual(errors.count("\n"), 1)
            # Before any window opens.
            self.fail_with([f"{option} '{values[1]}'", form], "view", scene, option, values[1])
        self.assertFalse(os.path.exists(output))


class TestBadImages(ProgramTest):
    def test_compare(self):
        total = reference_file("S1_point_iso", "total")
        with open(total, "rb") as file:
            content = file.read()
        for i, (piece, word) in enumerate((
                (b"", "empty"), (content[:50], "bytes"), (content[:-1], "bytes"),
                (content + b"x", "bytes"), (b"P6\n1 1\n255\n123", "PF or Pf"), (b"PF\n", "header"),
                (b"PF\n-160 120\n-1\n" + content[16:], "header"),
                (b"PF\n160 120\nx\n" + content[16:], "header"),
                (b"PF\n999999999 999999999\n-1\n", "header"))):
            bad = self.write(f"{i}.pfm", piece)
            self.fail_with([bad, word], "compare", bad, total)
            self.fail_with([bad, word], "compare", total, total, "--mask", bad)
        depth = reference_file("S1_point_iso", "depth")
        self.fail_with(["160x120 pixels of 3 channels", "1 channels"], "compare", total, depth)
        small = self.path("small.pfm")
        write_pfm(small, np.ones((2, 3, 1)))
        self.fail_with(["3x2", "160x120"], "compare", depth, small)
        self.fail_with(["mask", "3x2"], "compare", depth, depth, "--mask", small)
        nothing = self.path("nothing.pfm")
        write_pfm(nothing, np.zeros((120, 160, 1)))
        self.fail_with(["no pixels"], "compare", total, total, "--mask", nothing)
        plot = ["-o", self.path("plot.png")]
        for words, options in (
                (["--profile", "together"], plot), (["-o", "together"], ["--profile", "3"]),
                (["120", "rows 0 to 119"], ["--profile", "120", *plot]),
                (["-1", "rows 0 to 119"], ["--profile=-1", *plot]),
                (["x.pfm", ".png"], ["--profile", "3", "-o", self.path("x.pfm")]),
                (["nowhere"], ["--profile", "3", "-o", self.path("nowhere/x.png")]),
                (["x.jpg", "pfm"], ["--difference", self.path("x.jpg")])):
            self.fail_with(words, "compare", total, total, *options)

    def test_montage(self):
        good = self.path("good.png")
        self.succeed("render", scene_file("S1_point_iso"), "-o", good, "--size", "40x30")
        small = self.path("small.png")
        self.succeed("render", scene_file("S1_point_iso"), "-o", small, "--size", "40x20")
        with open(good, "rb") as file:
            content = file.read()
        output = ["-o", self.path("x.png")]
        for i, piece in enumerate((b"", b"x" * 99, content[:20], content[:len(content) // 2])):
            bad = self.write(f"{i}.png", piece)
            self.fail_with([bad], "montage", good, bad, *output)
        self.fail_with([small, "20 pixels high", "30"], "montage", good, small, *output)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
