# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Whether VTK's own window can draw here."""

import ctypes
import functools
import os

# What VTK 9.4 and later load where there is neither X server nor EGL.
OSMESA = ("libOSMesa.so", "libOSMesa.so.8", "libOSMesa.so.6")


def _load(*names):
    """The first of these libraries that there is, or None."""
    for name in names:
        try:
            return ctypes.CDLL(name)
        except OSError:
            pass
    return None


@functools.lru_cache(maxsize=None)
def _has_x_server(_display):
    library = _load("libX11.so.6")
    if library is None:
        return True  # VTK has one of its own
    library.XOpenDisplay.restype = ctypes.c_void_p
    # The connection stays open: a server without -noreset starts anew when its last one closes, and
    # refuses VTK meanwhile.
    return bool(library.XOpenDisplay(None))


def require_screen(window):
    """Raises RuntimeError where this window's first frame would end the program.

    VTK does that where it finds no X server and, from 9.4 on, neither libEGL nor libOSMesa.

    window: a vtkRenderWindow that has drawn nothing yet.
    """
    kind = window.GetClassName()
    display = os.environ.get("DISPLAY", "")
    if kind == "vtkXOpenGLRenderWindow":
        missing = None if _has_x_server(display) else "no X server"
    elif kind == "vtkOSOpenGLRenderWindow":
        missing = None if _load(*OSMESA) else "no X server, and neither libEGL nor libOSMesa"
    else:
        missing = None
    if missing:
        raise RuntimeError(
            f"VTK has nothing to draw with: {missing} (DISPLAY={display}, "
            f"VTK_DEFAULT_OPENGL_WINDOW={os.environ.get('VTK_DEFAULT_OPENGL_WINDOW', '')}). Without "
            "a screen, take airlight.headless_window(), or run under xvfb-run. Debian and Ubuntu: "
            "apt install libegl1 libgl1-mesa-dri xvfb")
