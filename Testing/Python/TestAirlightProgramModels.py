# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Models on their own: their first picture, the choices of a person, and what their files hold.

Run it like TestAirlightProgram.py.
"""

import base64
import json
import struct
import unittest

import numpy as np
from vtkmodules.vtkIOGeometry import vtkOBJReader

from programtest import ProgramTest, read_pfm, scene_file, write_mesh, write_models


def ball(count):
    """Points and quads of a ball of radius 1 with count rings."""
    angles = np.linspace(0, np.pi, count)
    turns = np.arange(2 * count) * np.pi / count
    points = [(np.sin(a) * np.cos(b), np.cos(a), np.sin(a) * np.sin(b))
              for a in angles for b in turns]
    faces = [(i * 2 * count + j, i * 2 * count + (j + 1) % (2 * count),
              (i + 1) * 2 * count + (j + 1) % (2 * count), (i + 1) * 2 * count + j)
             for i in range(count - 1) for j in range(2 * count)]
    return points, faces


class TestModels(ProgramTest):
    def test_models(self):
        """The model is in the middle, lit, and the light around the lamp is above it to the left.
        """
        for name in write_models(self.path):
            with self.subTest(model=name):
                picture = self.render(self.path(name), name + ".png", "--size", "96x72")
                middle = np.s_[24:48, 32:64]
                self.assertGreater(picture[middle].mean(), 0.1)
                self.assertGreater(picture[:36, :48].mean(), picture[36:, 48:].mean())
                plain = self.render(self.path(name), name + ".plain.png", "--size", "96x72",
                                    "--no-medium")
                self.assertGreater(plain[middle].mean(), 0.1)
                self.assertEqual(plain[0].max(), 0)

    def test_moods(self):
        """Each mood and place has a picture of its own, in which the model is neither black nor
        white; the defaults are what the help says."""
        model = self.path(write_models(self.path)[0])
        size = ("--size", "96x72", "--antialiasing", "2")
        plain = self.render(model, "plain.png", *size)
        pictures = {}
        for option, names in (("--mood", ("mist", "haze", "fog", "smoke", "night", "underwater")),
                              ("--light-from", ("behind", "left", "right", "above", "front"))):
            for name in names:
                picture = self.render(model, name + ".png", option, name, *size)
                middle = picture[24:48, 32:64].mean()
                self.assertGreater(middle, 0.08, name)
                self.assertLess(middle, 0.9, name)
                self.assertLess((picture.min(axis=-1) > 0.98).mean(), 0.05, name)
                pictures[name] = picture
        for name in ("mist", "behind"):
            np.testing.assert_array_equal(pictures.pop(name), plain)
        distinct = [plain, *pictures.values()]
        for i, first in enumerate(distinct):
            for second in distinct[:i]:
                self.assertGreater(np.abs(first - second).mean(), 0.01)
        # What the words say.
        self.assertLess(pictures["night"].mean(), 0.7 * plain.mean())
        water = pictures["underwater"].mean(axis=(0, 1))
        self.assertGreater(water[2], 2 * water[0])

        depth = self.render(model, "depth.pfm", *size[:2], "--buffer", "Depth")
        last = np.flatnonzero(depth[:, 44:52].min(axis=1) > 0).max()

        def contrast(picture):  # of the model's lower edge
            return abs(picture[last - 4:last, 44:52].mean() - picture[last + 3:, 44:52].mean())
        self.assertLess(contrast(pictures["fog"]), 0.85 * contrast(pictures["haze"]))
        for side, other in (("left", "right"), ("right", "left")):
            half = np.s_[:, :32] if side == "left" else np.s_[:, 64:]
            self.assertGreater(pictures[side][half].mean(), 1.3 * pictures[other][half].mean())

    def plate(self, name, turn):
        """A thin plate with a wedge on it, whose points are turned to other axes."""
        points = [(x, y, z) for x in (-2, 2) for z in (-1, 1) for y in (0, 0.1)] + [
            (-2, 1, -1), (-2, 1, 1)]
        faces = ["2 1 3 4", "5 6 8 7", "1 5 7 3", "1 2 6 5", "3 7 8 4", "2 4 10 9", "6 2 9",
                 "4 8 10", "6 9 10 8"]
        return self.write(name, "".join("v %g %g %g\n" % turn(*point) for point in points)
                          + "".join("f " + face + "\n" for face in faces))

    def test_up(self):
        """A model that lies on another side looks the same where its file, or a person, says which
        way is up."""
        options = ("--size", "96x72", "--antialiasing", "2")
        usual = self.render(self.plate("y.obj", lambda x, y, z: (x, y, z)), "y.png", *options)
        turns = {"x": lambda x, y, z: (y, -x, z), "z": lambda x, y, z: (x, -z, y),
                 "-x": lambda x, y, z: (-y, x, z), "-y": lambda x, y, z: (-x, -y, z),
                 "-z": lambda x, y, z: (x, z, -y)}
        for up, turn in turns.items():
            model = self.plate("a.obj", turn)
            picture = self.render(model, "a.png", *options, "--up", up)
            self.assertLess(np.abs(picture - usual).mean(), 2e-3, up)
            lying = self.render(model, "b.png", *options)
            self.assertGreater(np.abs(lying - usual).mean(), 0.01, up)
        reader = vtkOBJReader()
        reader.SetFileName(self.plate("z.obj", turns["z"]))
        reader.Update()
        write_mesh(reader.GetOutput(), self.path("z.stl"))
        np.testing.assert_array_equal(
            *(self.render(self.path("z.stl"), "c.png", *options, *up)
              for up in ((), ("--up", "z"))))
        self.fail_with(["--up", "z", "-x"], "render", model, "-o", self.path("x.png"), "--up", "w")
        scene = scene_file("S1_point_iso")
        self.fail_with(["--up: expected a model", scene], "render", scene, "-o",
                       self.path("x.png"), "--up", "z")

    def test_fills_the_picture(self):
        """From all around the model is seen whole, and from one side or the other close."""
        model = self.plate("a.obj", lambda x, y, z: (x, y, z))
        pole = self.plate("b.obj", lambda x, y, z: (0.1 * x, 5 * y, 0.1 * z))
        for name, width, height in ((model, 96, 54), (model, 54, 96), (pole, 96, 54),
                                    (pole, 36, 96), (self.ball(12, 1), 96, 54)):
            self.succeed("render", name, "-o", self.path("%d.pfm"), "--orbit", "8",
                         "--size", f"{width}x{height}", "--buffer", "Depth")
            shares = []
            for i in range(8):
                depth = read_pfm(self.path(f"{i}.pfm"))
                for seen in ((depth > 0).any(axis=axis) for axis in (0, 1)):
                    self.assertFalse(seen[0] or seen[-1], (name, width, i))
                    shares.append(seen.mean())
            self.assertGreater(max(shares), 0.6, (name, width))

    def test_inside(self):
        """A lamp in an open box shines out of it, through the side that it lacks."""
        lines = [f"v {x} {y} {z}" for x in (0, 1) for y in (0, 1) for z in (0, 1)]
        faces = ["1 2 4 3", "5 7 8 6", "1 5 6 2", "1 3 7 5", "2 6 8 4", "3 4 8 7"]
        lines += ["f " + face for face in faces]
        shut = self.write("shut.obj", "\n".join(lines) + "\n")
        model = self.write("open.obj", "\n".join(lines[:-1]) + "\n")
        options = ("--light-from", "inside", "--size", "96x72", "--buffer", "Airlight",
                   "--ambient", "0,0,0")
        self.assertGreater(self.render(model, "a.pfm", *options).mean(),
                           5 * self.render(shut, "b.pfm", *options).mean())

    def test_choices(self):
        """Other options change parts of a mood; scene files have no use for it."""
        model = self.path(write_models(self.path)[0])
        options = ("--mood", "smoke", "--size", "48x36", "--buffer", "Transmittance")
        thick = self.render(model, "a.pfm", *options)
        thin = self.render(model, "b.pfm", *options, "--visibility", "1e4")
        middle = np.s_[16:20, 22:26]
        self.assertLess(thick[middle].max(), 0.7)
        self.assertGreater(thin[middle].min(), 0.99)
        for option, name, words in (
                ("--mood", "gloom", ["--mood", "mist", "underwater"]),
                ("--light-from", "below", ["--light-from", "behind", "inside"])):
            self.fail_with(words, "render", model, "-o", self.path("x.png"), option, name)
        for lamp in ("--point=0,9,0:9", "--spot=0,9,0:0,0,0:20:9", "--sun=0,1,0:9"):
            self.fail_with(["--light-from", lamp[:5]], "render", model, "-o", self.path("x.png"),
                           "--light-from", "left", lamp)
        scene = scene_file("S1_point_iso")
        for options in (("--mood", "fog"), ("--light-from", "left")):
            for command in (("render", scene, "-o", self.path("x.png")), ("view", scene)):
                self.fail_with([options[0] + ": expected a model", scene], *command, *options)

    # White light along the view on surfaces in nearly clear air.
    CLEAR = ("--visibility", "1e6", "--ambient", "0,0,0", "--camera", "0,0,9:0,0,0",
             "--sun", "0,0,1:3,3,3", "--size", "96x72", "--buffer", "Surface")

    def test_colours(self):
        """Colours of materials are those of screens: sRGB."""
        self.write("a.mtl", "newmtl red\nKd 0.8 0.2 0.5\n")
        model = self.write("a.obj", "mtllib a.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n"
                           "usemtl red\nf 1 2 3\nf 1 3 4\n")
        colour = self.render(model, "a.pfm", *self.CLEAR)[36, 48]
        expected = ((np.array([0.8, 0.2, 0.5]) + 0.055) / 1.055) ** 2.4 * 3 / np.pi
        np.testing.assert_allclose(colour, expected, rtol=1e-3)

    def ball(self, count, sign=None):
        """A ball of radius 1 with count rings; normals outwards, inwards, 0 or none."""
        points, faces = ball(count)
        lines = ["ply", "format ascii 1.0", f"element vertex {len(points)}"]
        names = ["x", "y", "z"] + (["nx", "ny", "nz"] if sign is not None else [])
        lines += [f"property float {name}" for name in names]
        lines += [f"element face {len(faces)}", "property list uchar int vertex_indices",
                  "end_header"]
        for point in points:
            values = point if sign is None else (*point, *(sign * x for x in point))
            lines.append(" ".join(f"{x:.6f}" for x in values))
        lines += ["4 " + " ".join(map(str, face)) for face in faces]
        return self.write("ball.ply", "\n".join(lines) + "\n")

    def test_smooth(self):
        """A coarse ball has no facets; normals of 0 and those that point inwards are not used."""
        pictures = [self.render(self.ball(12, sign), "ball.pfm", *self.CLEAR)[..., 0]
                    for sign in (None, 0, -1)]
        lit = pictures[0][pictures[0] > 0]
        self.assertGreater(len(np.unique(lit.round(5))), 0.2 * lit.size)
        for picture in pictures[1:]:
            np.testing.assert_allclose(picture, pictures[0], atol=2e-3)

    def test_curved(self):
        """A coarse ball is round, and where it turns away from the lamp its shading is that of a
        ball, albedo/pi E cos, instead of the shadow of its facets."""
        options = (*self.CLEAR[:4], "--camera", "0,0,9:0,0,0:16", "--sun", "1,0,0:3", "--size",
                   "300x300", "--buffer")
        view = np.tan(np.radians(8)) * ((np.arange(300) + 0.5) / 150 - 1)
        x, y = np.meshgrid(view, -view)
        # The ray (x, y, -1) t from (0, 0, 9) meets the ball.
        a = x * x + y * y + 1
        root = 81 - a * 80
        hit = root > 0
        t = (9 - np.sqrt(np.maximum(root, 0))) / a
        expected = np.where(hit, 0.7 / np.pi * 3 * np.maximum(t * x, 0), 0)
        errors = []
        for more in ((), ("--facets",)):
            model = self.ball(12)
            depth = self.render(model, "depth.pfm", *options, "Depth", *more)[..., 0]
            shape = np.mean((depth > 0) != hit)
            image = self.render(model, "ball.pfm", *options, "Surface", *more)[..., 0]
            inside = hit & (depth > 0)
            errors.append((shape, np.abs(image - expected)[inside].mean()))
        for curved, flat in zip(*errors):
            self.assertLess(curved, 0.75 * flat, errors)

    def test_lines(self):
        """Of a coarse model stay."""
        model = self.write("a.obj", "v -1 -1 0\nv 1 -1 0\nv 0 0 0\nv -1 1 0\nv 1 1 0\n"
                           "f 1 2 3\nl 4 5\n")
        depth = self.render(model, "a.pfm", "--camera", "0,0,5:0,0,0", "--size", "96x72",
                            "--buffer", "Depth")
        self.assertGreater(depth[:20].max(), 4)

    def test_sharp(self):
        """Edges that normals do not round stay where they are."""
        model = self.path(write_models(self.path)[4])  # a tetrahedron
        options = ("--size", "96x72", "--buffer", "Depth")
        np.testing.assert_allclose(self.render(model, "a.pfm", *options),
                                   self.render(model, "b.pfm", *options, "--facets"), rtol=1e-6)


def decode(colour):
    """sRGB above its linear part."""
    return ((np.array(colour) + 0.055) / 1.055) ** 2.4


def gltf_square(**changes):
    """A square of half a side 1 at z = 0, with lamps of all kinds and a camera, as JSON."""
    points = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]
    data = np.array(points, "<f4").tobytes() + np.array([0, 1, 2, 0, 2, 3], "<u2").tobytes()
    lamps = [{"type": "point", "color": [1, 0.5, 0.25], "intensity": 40},
             {"type": "spot", "intensity": 100, "spot": {"outerConeAngle": 0.5}},
             {"type": "directional", "intensity": 3}]

    def lamp(number, **place):
        return dict({"extensions": {"KHR_lights_punctual": {"light": number}}}, **place)
    turned = [-np.sqrt(0.5), 0, 0, np.sqrt(0.5)]  # -z becomes -y
    return json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2, 3, 4]}],
        "extensionsUsed": ["KHR_lights_punctual", "KHR_materials_unlit"],
        "extensions": {"KHR_lights_punctual": {"lights": lamps}},
        "nodes": [{"mesh": 0}, lamp(0, translation=[1, 2, 3]), lamp(1, translation=[0, 0, 5]),
                  lamp(2, rotation=turned), {"camera": 0, "translation": [0.5, 0.2, 4]}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.8, "znear": 0.1}}],
        "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.6, 0.7, 1]}}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
                       "min": [-1, -1, 0], "max": [1, 1, 0]},
                      {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 48},
                        {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
        "buffers": [{"byteLength": 60, "uri": "data:application/octet-stream;base64,"
                                              + base64.b64encode(data).decode()}], **changes})


VRML = """#VRML V2.0 utf8
DirectionalLight { direction 0 -1 -2 intensity 0.5 color 1 1 0.5 }
Shape { appearance Appearance { material Material { diffuseColor 1 1 1 } }
 geometry IndexedFaceSet { coord Coordinate { point [ -1 -1 0, 1 -1 0, 1 1 0, -1 1 0 ] }
 coordIndex [ 0 1 2 3 -1 ] colorPerVertex TRUE
 color Color { color [ 0.8 0.2 0.5, 0.2 0.6 0.9, 0.8 0.2 0.5, 0.2 0.6 0.9 ] } } }
"""


def chunk(tag, content):
    """Of a 3DS file."""
    return struct.pack("<HI", tag, 6 + len(content)) + content


def studio_square():
    """The same square as a 3DS file, with a point lamp, a spot and a camera."""
    mesh = chunk(0x4110, struct.pack("<H12f", 4, -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0))
    mesh += chunk(0x4120, struct.pack("<9H", 2, 0, 1, 2, 0, 0, 2, 3, 0))
    colour = chunk(0x0010, struct.pack("<3f", 1, 0.5, 0.25))
    spot = chunk(0x4610, struct.pack("<5f", 0, 0, 0, 30, 40))
    objects = (
        (b"mesh", chunk(0x4100, mesh)),
        (b"omni", chunk(0x4600, struct.pack("<3f", 1, 2, 3) + colour)),
        (b"spot", chunk(0x4600, struct.pack("<3f", 0, 0, 5) + colour + spot)),
        (b"eye", chunk(0x4700, struct.pack("<8f", 0.5, -4, 2, 0.5, 0, 0, 0, 50))))
    content = b"".join(chunk(0x4000, name + b"\0" + part) for name, part in objects)
    return chunk(0x4D4D, chunk(0x3D3D, content))


def spot_exponent(inner, outer):
    """Of the cosine to whose power a spot sends out as much light as one that fades between the
    angles as KHR_lights_punctual says; by sums over the angle."""
    angles = (np.arange(20000) + 0.5) / 20000 * outer
    cosine, ring = np.cos(angles), np.sin(angles)
    ramp = (cosine - np.cos(outer)) / max(1e-9, np.cos(inner) - np.cos(outer))
    light = (np.clip(ramp, 0, 1) ** 2 * ring).sum()
    low, high = 0.0, 128.0
    for _ in range(50):
        middle = (low + high) / 2
        low, high = (middle, high) if (cosine**middle * ring).sum() > light else (low, middle)
    return low


class TestImported(ProgramTest):
    """Lamps, cameras and colours of files, against options that say the same."""

    SIZE = ("--size", "48x36")

    def check(self, model, lamps, camera=None):
        """lamps: option, place, power, and what a surface in the middle gets of it."""
        factor = 3.5 * np.pi / sum(share * max(power) for _, _, power, share, *_ in lamps)
        options = []
        for option, place, power, _, *rest in lamps:
            powers = ",".join(str(factor * x) for x in power)
            options += [option, ":".join((place, powers, *rest))]
        if camera:
            options += ["--camera", camera]
        image = self.render(model, "a.pfm", *self.SIZE)
        np.testing.assert_allclose(image, self.render(model, "b.pfm", *self.SIZE, *options),
                                   rtol=1e-4, atol=1e-6)
        other = self.render(model, "c.pfm", *self.SIZE, "--light-from", "left")
        self.assertGreater(np.abs(other - image).max(), 0.1 * image.max())

    def test_gltf(self):
        lamps = [("--point", "1,2,3", (40, 20, 10), 1 / 14),
                 ("--spot", f"0,0,5:0,0,0:{np.degrees(0.5)}", (100, 100, 100), 1 / 25,
                  str(spot_exponent(0, 0.5))),
                 ("--sun", "0,1,0", (3, 3, 3), 1)]
        model = self.write("a.gltf", gltf_square())
        self.check(model, lamps, f"0.5,0.2,4:0.5,0.2,0:{np.degrees(0.8)}")
        for name, camera in (("no.gltf", []), ("parallel.gltf", [
                {"type": "orthographic", "orthographic":
                    {"xmag": 1, "ymag": 1, "znear": 0.1, "zfar": 9}}])):
            nodes = json.loads(gltf_square())["nodes"][:4 + len(camera)]
            bare = self.write(name, gltf_square(
                cameras=camera, nodes=nodes, scenes=[{"nodes": list(range(len(nodes)))}]))
            image = self.render(bare, "d.pfm", *self.SIZE, "--buffer", "Depth")
            background = (image < 0).mean()
            self.assertTrue(0.3 < background < 0.95, f"{name}: {background}")

    def test_spots(self):
        """Fade between two angles; light has no range."""
        nodes = json.loads(gltf_square())["nodes"]
        for inner, outer in ((0, 0.5), (0.35, 0.4), (0.399, 0.4), (0, 0.05)):
            lamp = {"type": "spot", "intensity": 100, "range": 3,
                    "spot": {"innerConeAngle": inner, "outerConeAngle": outer}}
            model = self.write("a.gltf", gltf_square(
                nodes=[nodes[0], nodes[2], nodes[4]], scenes=[{"nodes": [0, 1, 2]}],
                extensions={"KHR_lights_punctual": {"lights": [lamp, lamp]}}))
            exponent = spot_exponent(inner, outer)
            self.check(model, [("--spot", f"0,0,5:0,0,0:{np.degrees(outer)}", (100, 100, 100),
                                1 / 25, str(exponent))])

    def test_spots_in_one_place(self):
        """Each has the angles of its own, also beside a lamp without any."""
        nodes = json.loads(gltf_square())["nodes"]
        angles = ((0.0, 0.5), (0.35, 0.4))
        lamps = [{"type": "spot", "intensity": 100,
                  "spot": {"innerConeAngle": inner, "outerConeAngle": outer}}
                 for inner, outer in angles]
        lamps.insert(1, {"type": "point", "intensity": 20})

        def at(light):
            return {**nodes[2], "extensions": {"KHR_lights_punctual": {"light": light}}}
        model = self.write("a.gltf", gltf_square(
            nodes=[nodes[0], at(0), at(1), at(2), nodes[4]], scenes=[{"nodes": [0, 1, 2, 3, 4]}],
            extensions={"KHR_lights_punctual": {"lights": lamps}}))
        spots = [("--spot", f"0,0,5:0,0,0:{np.degrees(outer)}", (100, 100, 100), 1 / 25,
                  str(spot_exponent(inner, outer))) for inner, outer in angles]
        self.check(model, [spots[0], ("--point", "0,0,5", (20, 20, 20), 1 / 25), spots[1]])

    def write_balls(self):
        """A coarse ball without normals in each format that has materials."""
        points, quads = ball(12)
        faces = [(a, b, c) for a, b, c, _ in quads] + [(a, c, d) for a, _, c, d in quads]
        self.write("b.mtl", "newmtl grey\nKd 0.5 0.5 0.5\n")
        obj = self.write("b.obj", "\n".join(
            ["mtllib b.mtl", "usemtl grey"] + ["v %f %f %f" % point for point in points]
            + ["f %d %d %d" % tuple(i + 1 for i in face) for face in faces]))
        data = np.array(points, "<f4").tobytes() + np.array(faces, "<u2").tobytes()
        gltf = json.loads(gltf_square(materials=[{"doubleSided": True}]))
        gltf["accessors"][0].update(count=len(points), min=[-1] * 3, max=[1] * 3)
        gltf["accessors"][1].update(count=3 * len(faces))
        gltf["bufferViews"] = [
            {"buffer": 0, "byteLength": 12 * len(points)},
            {"buffer": 0, "byteOffset": 12 * len(points), "byteLength": 6 * len(faces)}]
        gltf["buffers"] = [{"byteLength": len(data), "uri": "data:application/octet-stream;base64,"
                            + base64.b64encode(data).decode()}]
        studio = chunk(0x4110, struct.pack("<H", len(points)) + np.array(points, "<f4").tobytes())
        studio += chunk(0x4120, struct.pack("<H", len(faces)) + np.array(
            [(*face, 0) for face in faces], "<u2").tobytes())
        content = chunk(0x4000, b"mesh\0" + chunk(0x4100, studio))
        return (obj, self.write("b.gltf", json.dumps(gltf)),
                self.write("b.3ds", chunk(0x4D4D, chunk(0x3D3D, content))))

    def test_smooth(self):
        """Meshes without normals get smooth ones, and keep their facets if that is asked for."""
        for model in self.write_balls():
            shades = []
            for more in ((), ("--facets",)):
                image = self.render(model, "a.pfm", *TestModels.CLEAR, *more)[..., 0]
                shades.append(len(np.unique((image[image > 0] / image.max()).round(3))))
            self.assertGreater(shades[0], 3 * shades[1], model)

    def test_seams(self):
        """A box with texture coordinates keeps its edges; a fold of 20 degrees is smooth across a
        seam of them."""
        self.write("a.mtl", "newmtl grey\nKd 0.5 0.5 0.5\n")
        height = np.tan(np.radians(10))

        def fold(rise):
            return self.write("a.obj", "\n".join((
                "mtllib a.mtl", "v -1 -1 0", "v 0 -1 %f" % rise, "v 1 -1 0", "v -1 1 0",
                "v 0 1 %f" % rise, "v 1 1 0", "vt 0 0", "vt 1 0", "vt 1 1", "vt 0 1",
                "usemtl grey", "f 1/1 2/2 5/3 4/4", "f 2/1 3/2 6/3 5/4")))
        options = (*TestModels.CLEAR[:4], "--camera", "0,0,9:0,0,0", "--sun", "1,0,1:3", "--size",
                   "96x72", "--buffer", "Surface")
        flat, sharp = (self.render(fold(rise), "a.pfm", *options)[36, :, 0]
                       for rise in (height, np.tan(np.radians(30))))
        for row, steps in ((flat, False), (sharp, True)):
            lit = row[row > 0]
            jump = np.abs(np.diff(lit)).max() / lit.max()
            self.assertEqual(jump > 0.2, steps, jump)

    def test_cameras(self):
        """The first perspective camera that a node holds; without one all of the model is seen."""
        shape = {"perspective": {"yfov": 0.8, "znear": 0.1}, "type": "perspective"}
        parallel = {"orthographic": {"xmag": 1, "ymag": 1, "znear": 0.1, "zfar": 9},
                    "type": "orthographic"}
        options = (*self.SIZE, "--buffer", "Depth")
        model = self.write("no.gltf", gltf_square(cameras=[], scenes=[{"nodes": [0, 1, 2, 3]}]))
        whole = self.render(model, "a.pfm", *options)
        for number, cameras in ((1, [parallel, shape]), (1, [shape, shape]), (1, [shape])):
            nodes = json.loads(gltf_square())["nodes"]
            nodes[4].update(camera=number, translation=[0, 0, 7])
            model = self.write("a.gltf", gltf_square(cameras=cameras, nodes=nodes))
            image = self.render(model, "a.pfm", *options)
            expected = whole if len(cameras) == 1 else self.render(
                model, "b.pfm", *options, "--camera", f"0,0,7:0,0,0:{np.degrees(0.8)}")
            np.testing.assert_allclose(image, expected, rtol=1e-4)

    def test_inside(self):
        """A camera in the model's middle turns about a point before it, and a lamp there leaves
        the others their share."""
        nodes = json.loads(gltf_square())["nodes"]
        nodes[4].update(translation=[0, 0, 0])
        nodes[1].update(translation=[0, 0, 1e-3])
        model = self.write("a.gltf", gltf_square(nodes=nodes, materials=[{"doubleSided": True}]))
        self.succeed("render", model, "-o", self.path("%d.pfm"), "--orbit", "2", *self.SIZE,
                     "--buffer", "Depth")
        start, back = (read_pfm(self.path(f"{i}.pfm")) for i in range(2))
        self.assertLess(start.max(), 0)
        np.testing.assert_allclose(back[18, 24], 0.2 * 8**0.5, rtol=0.01)
        nodes[4].update(translation=[0.5, 0.2, 4])
        self.check(self.write("a.gltf", gltf_square(nodes=nodes)),
                   [("--point", "0,0,0.001", (40, 20, 10), 1 / (0.3**2 * 8)),
                    ("--spot", f"0,0,5:0,0,0:{np.degrees(0.5)}", (100, 100, 100), 1 / 25,
                     str(spot_exponent(0, 0.5))),
                    ("--sun", "0,1,0", (3, 3, 3), 1)])

    def test_pitched(self):
        """A camera that looks down turns about the world's way up, where the lamp is too."""
        angle = np.arctan(3 / 4) / 2
        nodes = json.loads(gltf_square())["nodes"]
        nodes[4].update(translation=[0, 3, 4], rotation=[-np.sin(angle), 0, 0, np.cos(angle)])
        two_sides = [{"doubleSided": True}]
        model = self.write("a.gltf", gltf_square(nodes=nodes, materials=two_sides))
        self.succeed("render", model, "-o", self.path("%d.pfm"), "--orbit", "2", *self.SIZE,
                     "--buffer", "Depth")
        view = f":0,0,0:{np.degrees(0.8)}"
        expected = self.render(model, "a.pfm", *self.SIZE, "--buffer", "Depth",
                               "--camera", "0,3,-4" + view)
        np.testing.assert_allclose(read_pfm(self.path("1.pfm")), expected, rtol=1e-4)
        self.assertGreater(expected.max(), 4)
        bare = self.write("b.gltf", gltf_square(cameras=[], scenes=[{"nodes": [0, 1, 2, 3]}],
                                                materials=two_sides))
        above = (*self.SIZE, "--light-from", "above")
        np.testing.assert_allclose(
            self.render(model, "b.pfm", *above),
            self.render(bare, "c.pfm", *above, "--camera", "0,3,4" + view), rtol=1e-3, atol=1e-6)

    def test_left(self):
        """Is the left of the file's camera, here of one that looks from behind."""
        nodes = json.loads(gltf_square())["nodes"]
        nodes[4].update(translation=[0, 0, -4], rotation=[0, 1, 0, 0])
        model = self.write("a.gltf", gltf_square(nodes=nodes))
        image = self.render(model, "a.pfm", *self.SIZE, "--light-from", "left")
        self.assertGreater(image[:, :8].mean(), 2 * image[:, -8:].mean())

    def test_unlit(self):
        """Is a radiance, whatever the lamp."""
        for name, extensions, lit in (("a.gltf", {}, True),
                                      ("b.gltf", {"KHR_materials_unlit": {}}, False)):
            model = self.write(name, gltf_square(materials=[{
                "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.6, 0.7, 1]},
                "extensions": extensions}]))
            for power in (1, 3):
                colour = self.render(
                    model, "a.pfm", *TestModels.CLEAR, "--sun", f"0,0,1:{power}")[36, 48]
                expected = np.array([0.5, 0.6, 0.7]) * ((3 + power) / np.pi if lit else 1)
                np.testing.assert_allclose(colour, expected, rtol=2e-3, err_msg=f"{name} {power}")

    def test_vrml(self):
        model = self.write("a.wrl", VRML)
        self.fail_with(["--facets", model], "render", model, "--facets", "-o", self.path("x.png"))
        self.check(model, [("--sun", "0,1,2", (0.5, 0.5, 0.25), 1)])
        image = self.render(model, "a.pfm", *TestModels.CLEAR) / (3 / np.pi)
        middle = image[36, 48]  # on the diagonal of two triangles
        colour = [0.8, 0.2, 0.5] if middle[0] > 0.3 else [0.2, 0.6, 0.9]
        np.testing.assert_allclose(middle, decode(colour), atol=0.03)

    def test_3ds(self):
        model = self.write("a.3ds", studio_square())
        colour = np.array([1, 0.5, 0.25])
        self.check(model, [("--point", "1,2,3", 14 * colour, 1 / 14),
                           ("--spot", "0,0,5:0,0,0:20", 25 * colour, 1 / 25)],
                   "0.5,-4,2:0.5,0,0:30")


if __name__ == "__main__":
    unittest.main(argv=[__file__])
