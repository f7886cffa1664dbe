# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Models with textures, and with materials that VTK's reader does not understand.

Run it like TestAirlightProgram.py.
"""

import base64
import json
import struct
import unittest
import zlib

import numpy as np

from programtest import ProgramTest, read_png

SIZE = ("--size", "64x48", "--no-medium", "--light-from", "front")
SQUARE = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n"


def png(rows):
    """A PNG file of 8-bit RGB texels, by its specification."""
    def chunk(name, data):
        return (struct.pack(">I", len(data)) + name + data
                + struct.pack(">I", zlib.crc32(name + data)))
    texels = np.array(rows, np.uint8)
    lines = b"".join(b"\0" + line.tobytes() for line in texels)
    head = struct.pack(">2I5B", texels.shape[1], texels.shape[0], 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(lines))
            + chunk(b"IEND", b""))


def uri(kind, data):
    return f"data:{kind};base64," + base64.b64encode(data).decode()


def textured_squares():
    """Two squares side by side of one material, whose texture is red on the left, blue on the
    right."""
    corners = np.array([(-2, -1, 0), (-0.1, -1, 0), (-0.1, 1, 0), (-2, 1, 0),
                        (0.1, -1, 0), (2, -1, 0), (2, 1, 0), (0.1, 1, 0)], "<f4")
    places = np.array(2 * [(0, 1), (1, 1), (1, 0), (0, 0)], "<f4")
    triangles = np.array([0, 1, 2, 0, 2, 3], "<u2")
    data = corners.tobytes() + places.tobytes() + triangles.tobytes()

    def points(first):
        return {"bufferView": 0, "byteOffset": 48 * first, "componentType": 5126, "count": 4,
                "type": "VEC3", "min": corners[4 * first:4 * first + 4].min(axis=0).tolist(),
                "max": corners[4 * first:4 * first + 4].max(axis=0).tolist()}

    def mesh(number):
        return {"primitives": [{"attributes": {"POSITION": number, "TEXCOORD_0": 2},
                                "indices": 3, "material": 0}]}

    return json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
        "nodes": [{"mesh": 0}, {"mesh": 1}], "meshes": [mesh(0), mesh(1)],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0},
                                                "metallicFactor": 0}}],
        "textures": [{"source": 0, "sampler": 0}],
        "samplers": [{"magFilter": 9728, "minFilter": 9728}],
        "images": [{"uri": uri("image/png", png([4 * [(255, 0, 0)] + 4 * [(0, 0, 255)]]))}],
        "accessors": [points(0), points(1),
                      {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
                      {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteLength": 96},
                        {"buffer": 0, "byteOffset": 96, "byteLength": 32},
                        {"buffer": 0, "byteOffset": 160, "byteLength": 12}],
        "buffers": [{"byteLength": len(data), "uri": uri("application/octet-stream", data)}]})


class TestMaterials(ProgramTest):
    def test_textured_gltf(self):
        """Both squares show the texture that they share."""
        model = self.write("textured.gltf", textured_squares())
        picture = self.render(model, "textured.png", *SIZE, "--camera", "0,0,6:0,0,0:40")
        row = picture[24]
        for left, right in ((18, 26), (38, 46)):
            for column, seen, unseen in ((left, 0, 2), (right, 2, 0)):
                self.assertGreater(row[column][seen], 0.2, (left, column))
                # Tone mapping makes bright colours paler.
                self.assertLess(row[column][unseen], 0.4 * row[column][seen], (left, column))

    def test_shared_image(self):
        """An image may be that of a colour and of something else at once."""
        options = (*SIZE, "--camera", "0,0,6:0,0,0:40")
        plain = self.render(self.write("a.gltf", textured_squares()), "a.png", *options)
        for part, name in (("pbrMetallicRoughness", "metallicRoughnessTexture"),
                           (None, "normalTexture"), (None, "occlusionTexture")):
            model = json.loads(textured_squares())
            material = model["materials"][0]
            (material[part] if part else material)[name] = {"index": 0}
            shared = self.render(self.write("b.gltf", json.dumps(model)), "b.png", *options)
            np.testing.assert_array_equal(shared, plain, err_msg=name)

    def check_left_out(self, model, reason):
        """The model is drawn in the grey of models without, with a message that says why."""
        code, _, errors = self.run_program("render", model, "-o", self.path("a.png"), *SIZE)
        self.assertEqual(code, 0, errors)
        self.assertIn("warning: the materials are left out: ", errors)
        self.assertIn(reason, errors)
        picture = read_png(self.path("a.png"))
        middle = picture[20:28, 28:36]
        self.assertGreater(middle.min(), 0.1)
        self.assertLess(np.ptp(middle, axis=-1).max(), 0.15)

    def test_unknown_material(self):
        self.write("a.mtl", "newmtl red\nKd 0.8 0.2 0.2\n")
        self.check_left_out(
            self.write("a.obj", "mtllib a.mtl\n" + SQUARE + "usemtl blue\nf 1 2 3\nf 1 3 4\n"),
            "'blue'")

    def test_material_with_spaces(self):
        self.write("b.mtl", "newmtl Hard Shiny\nKd 0.8 0.2 0.2\n")
        self.check_left_out(
            self.write("b.obj",
                       "mtllib b.mtl\n" + SQUARE + "usemtl Hard Shiny\nf 1 2 3\nf 1 3 4\n"),
            "Hard Shiny")

    def test_bad_points_stay_errors(self):
        self.write("c.mtl", "newmtl red\nKd 0.8 0.2 0.2\n")
        model = self.write("c.obj", "mtllib c.mtl\n" + SQUARE + "usemtl red\nf 1 2 30\n")
        code, _, errors = self.run_program("render", model, "-o", self.path("c.png"), *SIZE)
        self.assertEqual(code, 1)
        self.assertIn("c.obj", errors)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
