# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""A client whose server loses a rank, and that draws with another, for TestServer.py:
lost_server.py PORT PROCESS PORT, of the server, of its rank that dies, and of the other server."""

import os
import signal
import sys
import time

from paraview import simple

import paraviewtest as test


def draw(port, name):
    simple.Connect("localhost", port)
    simple.LoadPlugin(os.environ["AIRLIGHT_PLUGIN"], remote=True, ns=vars(simple))
    test.load_plugin()
    view = test.make_view()
    view.RemoteRenderThreshold = 0
    view.VisibilityDistance = 20
    test.add_lamp(view)
    test.show(view, *test.make_sources())
    simple.Render(view)
    test.place_camera(view)
    test.picture(view, name)
    return view


first = draw(int(sys.argv[1]), "before-loss")
os.kill(int(sys.argv[2]), signal.SIGKILL)
time.sleep(3)  # until mpirun has ended the other rank
print("without the server", flush=True)
# Not rendered: ParaView's client then copies a picture of no size, and ends.
for distance in range(10, 16):  # the first is still sent
    first.VisibilityDistance = distance
    time.sleep(0.5)
del first
print("going on with another", flush=True)
draw(int(sys.argv[3]), "after-loss")
