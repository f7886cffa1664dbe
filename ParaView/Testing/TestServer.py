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


STEPS = ("thin", "thick", "surface", "image", "media", "photometry", "translucent",
         "transparent")


def run_scene(*arguments):
    subprocess.run([str(RUN), "--run", str(HERE / "server_scene.py"), *arguments], check=True,
                   timeout=200)


def read(name):
    """The pictures of a run; colours of the last one times its opacity."""
    found = [test.read_png(test.OUTPUT / f"{name}-{step}.png") for step in STEPS]
    found[-1][..., :3] *= found[-1][..., 3:] / 255
    return found


def find_children(process):
    """The numbers of the processes that a process has started."""
    found = []
    for path in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = path.read_text(encoding="utf-8").rpartition(")")[2].split()
        except OSError:
            continue  # it has ended meanwhile
        if int(fields[1]) == process:
            found.append(int(path.parent.name))
    return sorted(found)


class Server(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        run_scene()
        cls.one = read("by-one")
        for former, latter in zip(cls.one, cls.one[1:-1]):
            assert np.abs(former - latter).max() > 20, "the fog is seen"

    def serve(self, ranks):
        """A server that waits for its client: the process and its port."""
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
        server = subprocess.Popen(command, env=clean, stdout=subprocess.PIPE, text=True)
        self.addCleanup(server.stdout.close)
        self.addCleanup(server.wait)
        self.addCleanup(server.kill)
        while "Accepting" not in server.stdout.readline():
            self.assertIsNone(server.poll(), "pvserver runs")
        return server, port

    def check_pictures(self, ranks):
        server, port = self.serve(ranks)
        run_scene(port)
        server.communicate(timeout=60)  # it ends with its client
        self.assertEqual(server.returncode, 0)
        for name in ("by-server", "by-client"):
            difference = [np.abs(found - one).max() for found, one in zip(read(name), self.one)]
            print(f"pvserver of {ranks} ranks, {name}: largest differences {difference}")
            self.assertLessEqual(max(difference[:-1]), 1)
            # The opacity is the difference of two pictures.
            self.assertLessEqual(difference[-1], 2)

    def test_one_rank(self):
        self.check_pictures(1)

    @unittest.skipUnless(shutil.which("mpirun"), "no mpirun")
    def test_two_ranks(self):
        self.check_pictures(2)

    @unittest.skipUnless(shutil.which("mpirun"), "no mpirun")
    def test_lost_rank(self):
        """An error and no waiting; another server then gives the same picture."""
        server, port = self.serve(2)
        _, other = self.serve(1)
        done = subprocess.run(
            [str(RUN), "--run", str(HERE / "lost_server.py"), port,
             str(find_children(server.pid)[-1]), other],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stdout)
        server.communicate(timeout=60)
        self.assertNotEqual(server.returncode, 0, "it ends with its rank")
        lost = done.stdout.partition("without the server")[2].partition("going on")[0]
        if test.VERSION < (5, 12):  # later ParaView says nothing
            self.assertIn("Socket error", lost)
        before, after = (test.read_png(test.OUTPUT / f"{name}-loss.png")
                         for name in ("before", "after"))
        self.assertGreater(before.std(), 5)
        self.assertLessEqual(np.abs(after - before).max(), 1)

    def test_without_plugin(self):
        """A server that has not loaded it, and files that are no plugin: errors, and all goes on."""
        server, port = self.serve(1)
        done = subprocess.run(
            [str(RUN), "--run", str(HERE / "plain_server.py"), port, str(test.OUTPUT)],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=120)
        self.assertEqual(done.returncode, 0, done.stdout)
        server.communicate(timeout=60)
        for part in ("No proxy that matches: group=views and proxy=AirlightRenderView",
                     "view: ('Failed to create requested view', 'AirlightRenderView')",
                     "missing plugin: Problem loading plugin /no/such.so",
                     "wrong plugin: Problem loading plugin", "ParaView's own view: True"):
            self.assertIn(part, done.stdout)


if __name__ == "__main__":
    # pvpython loses its window where a script calls sys.exit() with a view open.
    if not unittest.main(argv=[__file__] + sys.argv[1:], exit=False).result.wasSuccessful():
        sys.exit(1)
