# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the programs share: running them, and reading what they write.

Environment: AIRLIGHT_PROGRAM, the path of `airlight` (AnimatedFog lies beside it);
AIRLIGHT_SOURCE_DIR, the project's sources; and an X server.
"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOGeometry import vtkOBJWriter, vtkSTLWriter
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOPLY import vtkPLYWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

PROGRAM = os.environ.get("AIRLIGHT_PROGRAM", "airlight")
ANIMATED_FOG = os.path.join(os.path.dirname(PROGRAM), "AnimatedFog")
SOURCE = os.environ.get(
    "AIRLIGHT_SOURCE_DIR", os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
REFERENCE = os.path.join(SOURCE, "Testing", "Data", "Reference")

sys.path.insert(0, REFERENCE)
from compare import metrics, read_pfm  # noqa: E402,F401 the judge of the reference scenes


# A triangle; its data are three corners (0,0,0), (1,0,0), (0,1,0) as floats.
GLTF = """{
 "asset": {"version": "2.0"},
 "scene": 0,
 "scenes": [{"nodes": [0]}],
 "nodes": [{"mesh": 0}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                "min": [0, 0, 0], "max": [1, 1, 0]}],
 "bufferViews": [{"buffer": 0, "byteLength": 36}],
 "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,\
AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]
}
"""

TETRAHEDRON = """v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
f 1 3 2
f 1 2 4
f 2 3 4
f 1 4 3
"""


def scene_file(name):
    return os.path.join(REFERENCE, "scenes", name + ".json")


def reference_file(name, part):
    return os.path.join(REFERENCE, "ref", f"{name}.{part}.pfm")


def read_png(path):
    """float [H, W, C] in 0..1, row 0 = top, as read_pfm() has it."""
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    values = vtk_to_numpy(image.GetPointData().GetScalars())
    return values.reshape(height, width, -1)[::-1] / 255.0


def write_pfm(path, image):
    """image: [H, W, C], row 0 = top."""
    height, width, channels = image.shape
    with open(path, "wb") as file:
        file.write(b"%s\n%d %d\n-1.0\n" % (b"PF" if channels == 3 else b"Pf", width, height))
        file.write(np.ascontiguousarray(image[::-1], "<f4").tobytes())


def write_mesh(mesh, path):
    """A vtkPolyData, in the format that the name says."""
    writer = {".obj": vtkOBJWriter, ".stl": vtkSTLWriter, ".ply": vtkPLYWriter,
              ".vtp": vtkXMLPolyDataWriter}[os.path.splitext(path)[1]]()
    writer.SetInputData(mesh)
    writer.SetFileName(path)
    writer.Write()


def write_models(path):
    """A sphere in every format that VTK writes, and a tetrahedron and a triangle; their names."""
    sphere = vtkSphereSource()
    sphere.Update()
    for name in ("a.obj", "a.stl", "a.ply", "a.vtp"):
        write_mesh(sphere.GetOutput(), path(name))
    for name, text in (("b.obj", TETRAHEDRON), ("b.gltf", GLTF)):
        with open(path(name), "w") as file:
            file.write(text)
    return ["a.obj", "a.stl", "a.ply", "a.vtp", "b.obj", "b.gltf"]


def pixel_rays(camera, width, height):
    """Unit directions [H, W, 3], row 0 = top, through the middles of the pixels.

    camera: as in a scene file.
    """
    eye = np.array(camera["position"], float)
    forward = np.array(camera["focal_point"], float) - eye
    forward /= np.linalg.norm(forward)
    right = np.cross(forward, camera["view_up"])
    right /= np.linalg.norm(right)
    up = np.cross(right, forward)
    half = np.tan(np.radians(camera["view_angle_deg"] / 2))
    x = ((np.arange(width) + 0.5) / width * 2 - 1) * half * width / height
    y = (1 - (np.arange(height) + 0.5) / height * 2) * half
    rays = forward + x[None, :, None] * right + y[:, None, None] * up
    return rays / np.linalg.norm(rays, axis=-1, keepdims=True)


class ProgramTest(unittest.TestCase):
    """Each test has a folder of its own, which stays behind if the test fails."""

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="airlight-")

    def tearDown(self):
        outcome = self._outcome.result
        failed = [test for test, _ in outcome.failures + outcome.errors]
        if not any(self.id() in test.id() for test in failed):
            shutil.rmtree(self.folder)

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, content):
        os.makedirs(os.path.dirname(self.path(name)), exist_ok=True)
        with open(self.path(name), "wb" if isinstance(content, bytes) else "w") as file:
            file.write(content)
        return self.path(name)

    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def run_program(self, *arguments, program=PROGRAM):
        """(exit code, standard output, error output) of the program."""
        done = subprocess.run([program, *arguments], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True, errors="replace", timeout=300,
                              check=False)
        return done.returncode, done.stdout, done.stderr

    def succeed(self, *arguments, program=PROGRAM):
        """Run the program, which must print nothing on the error stream; its standard output."""
        code, output, errors = self.run_program(*arguments, program=program)
        self.assertEqual((code, errors), (0, ""), " ".join(arguments))
        return output

    def fail_with(self, words, *arguments, program=PROGRAM):
        """Run the program, which must end with code 1 and say all the words in a few lines."""
        code, _, errors = self.run_program(*arguments, program=program)
        self.assertEqual(code, 1, f"{arguments}: {errors}")
        self.assertLessEqual(len(errors.strip().split("\n")), 2, errors)
        for word in words:
            self.assertIn(word, errors)
        self.assertNotIn("vtkDebug", errors)
        return errors

    def render(self, scene, output, *options):
        """Render into a file of the test's folder and return what was written."""
        path = self.path(output)
        self.succeed("render", scene, "-o", path, *options)
        return read_png(path) if output.endswith(".png") else read_pfm(path)


def henyey_greenstein(g, cosine):
    return (1 - g * g) / (4 * np.pi * (1 + g * g - 2 * g * cosine)**1.5)


WALL = """ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
element face 1
property list uchar int vertex_indices
end_header
-50 -50 0
50 -50 0
50 50 0
-50 50 0
4 0 1 2 3
"""


class SceneTest(ProgramTest):
    """Small scenes: a camera that looks along -z from aside, a uniform medium and a lamp for the
    options to replace."""

    SIZE = (40, 30)
    CAMERA = {"position": [0.2, 0.1, 5.0], "focal_point": [0.0, 0.0, 0.0], "view_up": [0, 1, 0],
              "view_angle_deg": 50.0}

    def scene_medium(self, **changes):
        return {"sigma_s": [0.2, 0.3, 0.4], "sigma_a": [0, 0, 0.1],
                "phase": {"type": "isotropic"}, **changes}

    def scene(self, surfaces=(), **changes):
        """A scene file with these changes to the medium."""
        lamp = {"type": "point", "position": [1, 1, 2], "intensity": [100, 200, 300]}
        return self.write("scene.json", json.dumps({
            "image": {"width": self.SIZE[0], "height": self.SIZE[1]}, "camera": self.CAMERA,
            "medium": self.scene_medium(**changes), "lights": [lamp], "surfaces": surfaces}))

    def wall_scene(self, albedo):
        """The same before a wall at z = 0."""
        self.write("wall.ply", WALL)
        return self.scene(surfaces=[{"mesh": "wall.ply", "albedo": albedo}])
