# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Keys and mouse buttons pressed in other programs' windows, through the X server."""

import ctypes
import ctypes.util
import time


class KeyEvent(ctypes.Structure):
    """XKeyEvent, as long as an XEvent. XButtonEvent has the button in place of the keycode."""

    _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
                ("display", ctypes.c_void_p), ("window", ctypes.c_ulong), ("root", ctypes.c_ulong),
                ("subwindow", ctypes.c_ulong), ("time", ctypes.c_ulong), ("x", ctypes.c_int),
                ("y", ctypes.c_int), ("x_root", ctypes.c_int), ("y_root", ctypes.c_int),
                ("state", ctypes.c_uint), ("keycode", ctypes.c_uint), ("same_screen", ctypes.c_int),
                ("padding", ctypes.c_long * 24)]


class WindowAttributes(ctypes.Structure):
    """XWindowAttributes."""

    _fields_ = [("place", ctypes.c_int * 6), ("visual", ctypes.c_void_p), ("root", ctypes.c_ulong),
                ("kinds", ctypes.c_int * 4), ("planes", ctypes.c_ulong * 2),
                ("save_under", ctypes.c_int), ("colormap", ctypes.c_ulong),
                ("map_installed", ctypes.c_int), ("map_state", ctypes.c_int),
                ("all_event_masks", ctypes.c_long), ("masks", ctypes.c_long * 2),
                ("override_redirect", ctypes.c_int), ("screen", ctypes.c_void_p)]


class Keyboard:
    """Keys sent to a window of the X server, found by its name, as soon as it listens to keys."""

    def __init__(self, name, patience):
        self.x11 = ctypes.CDLL(ctypes.util.find_library("X11"))
        self.x11.XOpenDisplay.restype = ctypes.c_void_p
        self.x11.XDefaultRootWindow.restype = ctypes.c_ulong
        self.x11.XStringToKeysym.restype = ctypes.c_ulong
        self.display = ctypes.c_void_p(self.x11.XOpenDisplay(None))
        self.root = self.x11.XDefaultRootWindow(self.display)
        end = time.monotonic() + patience
        while not (found := self.find(self.root, name)):
            if time.monotonic() > end:
                raise TimeoutError(f"no window {name}")
            time.sleep(0.1)
        self.window = found

    def listens(self, window):
        attributes = WindowAttributes()
        self.x11.XGetWindowAttributes(self.display, ctypes.c_ulong(window),
                                      ctypes.byref(attributes))
        return attributes.all_event_masks & 1  # KeyPressMask

    def find(self, window, name):
        title = ctypes.c_char_p()
        if self.x11.XFetchName(self.display, ctypes.c_ulong(window), ctypes.byref(title)):
            if (title.value or b"").decode() == name and self.listens(window):
                return window
        root, parent = ctypes.c_ulong(), ctypes.c_ulong()
        children, count = ctypes.POINTER(ctypes.c_ulong)(), ctypes.c_uint()
        self.x11.XQueryTree(self.display, ctypes.c_ulong(window), ctypes.byref(root),
                            ctypes.byref(parent), ctypes.byref(children), ctypes.byref(count))
        below = (self.find(children[i], name) for i in range(count.value))
        return next((child for child in below if child), None)

    def press(self, name):
        key = self.x11.XStringToKeysym(name.encode())
        code = self.x11.XKeysymToKeycode(self.display, ctypes.c_ulong(key))
        self.send(2, 1, code)  # KeyPress
        self.send(3, 2, code)  # KeyRelease
        self.x11.XFlush(self.display)

    def drag(self, start, end):
        """Press the left button at a place, move the mouse and release it; from the top left.

        Windows ask the server for the mouse's place when it moves, so it moves once.
        """
        self.send(4, 4, 1, start)  # ButtonPress
        self.x11.XWarpPointer(self.display, ctypes.c_ulong(0), ctypes.c_ulong(self.window), 0, 0, 0,
                              0, *end)
        self.send(5, 8, 1, end, 256)  # ButtonRelease, Button1Mask
        self.x11.XFlush(self.display)

    def send(self, kind, mask, code, place=(9, 9), state=0):
        x, y = place
        event = KeyEvent(kind, 0, 1, self.display, self.window, self.root, 0, 0, x, y, x, y, state,
                         code, 1)
        self.x11.XSendEvent(self.display, ctypes.c_ulong(self.window), 1, ctypes.c_long(mask),
                            ctypes.byref(event))
