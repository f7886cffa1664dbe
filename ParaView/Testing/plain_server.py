# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""A client whose server has no plugin, and plugins that do not load, for TestServer.py:
plain_server.py PORT FOLDER. ParaView says what is wrong, and goes on."""

import pathlib
import sys

from paraview import simple

import paraviewtest as test

simple.Connect("localhost", int(sys.argv[1]))
test.load_plugin()  # for the client alone
wrong = pathlib.Path(sys.argv[2], "plugin_of_nothing.so")
wrong.write_text("of another ParaView", encoding="utf-8")
for name, action in (
        ("view", lambda: simple.CreateView("AirlightRenderView")),
        ("missing plugin", lambda: simple.LoadPlugin("/no/such.so", remote=False, ns={})),
        ("wrong plugin", lambda: simple.LoadPlugin(str(wrong), remote=False, ns={}))):
    try:
        action()
        print(f"{name}: no error", flush=True)
    except RuntimeError as error:
        print(f"{name}: {error}", flush=True)
view = test.make_view("RenderView")
test.show(view, *test.make_sources())
simple.Render(view)
print("ParaView's own view:", test.picture(view, "plain-server").std() > 5, flush=True)
