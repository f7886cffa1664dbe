# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""A client and pvserver on one and two ranks, which draws or sends polygons to the client, show
what ParaView shows in one process."""

import os
import pathlib
import shutil
import socket
import subprocess
import sys
import unittest

import numpy as np

import paraviewtest as test

HERE = pathlib.Path(__file__).resolve().parent
RUN = HERE.parents[1] / "Utilities" / "paraview-test.sh"


def run_scene(*arguments):
    subprocess.run([str(RUN), "--run", str(HERE / "server_scene.py"), *arguments], check=True,
                   timeout=200)


def read(name):
    return np.array([test.read_png(test.OUTPUT / f"{name}-{step}.png")
                     for step in ("thin", "thick", "surface", "image", "media",
                                  "photometry")])


class Server(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        run_scene()
        cls.one = read("by-one")
        for former, latter in zip(cls.one, cls.one[1:]):
            assert np.abs(former - latter).max() > 20, "the fog is seen"

    def check_pictures(self, ranks):
        with socket.socket() as free:
            free.bind(("localhost", 0))
            port = str(free.getsockname()[1])
        command = ["pvserver", "--force-offscreen-rendering", f"--server-port={port}"]
        if ranks > 1:
            command = ["mpirun", "--oversubscribe", "-n", str(ranks), *command]
        # pvpython leaves traces of MPI, with which mpirun does nothing.
        clean = {key: value for key, value in os.environ.items()
                 if not key.startswith(("OMPI_", "PMIX_", "ORTE_"))}
        clean.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
        with subprocess.Popen(command, env=clean, stdout=subprocess.PIPE, text=True) as server:
            self.addCleanup(server.kill)
            while "Accepting" not in server.stdout.readline():
                self.assertIsNone(server.poll(), "pvserver runs")
            run_scene(port)
            server.communicate(timeout=60)  # it ends with its client
            self.assertEqual(server.returncode, 0)
        for name in ("by-server", "by-client"):
            difference = np.abs(read(name) - self.one).max(axis=(1, 2, 3))
            print(f"pvserver of {ranks} ranks, {name}: largest differences {difference}")
            self.assertLessEqual(difference.max(), 1)

    def test_one_rank(self):
        self.check_pictures(1)

    @unittest.skipUnless(shutil.which("mpirun"), "no mpirun")
    def test_two_ranks(self):
        self.check_pictures(2)


if __name__ == "__main__":
    # pvpython loses its window where a script calls sys.exit() with a view open.
    if not unittest.main(argv=[__file__] + sys.argv[1:], exit=False).result.wasSuccessful():
        sys.exit(1)
