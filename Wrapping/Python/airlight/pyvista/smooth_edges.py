# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""FXAA for the subplots in a medium, where the window's multisampling has no effect."""

from __future__ import annotations

from typing import Any


class SmoothEdges:
    """Switches a window's multisampling off while a subplot has FXAA.

    VTK's FXAA draws black in a multisampled window. The samples come back when the last subplot
    has released them.
    """

    def __init__(self) -> None:
        self._samples: int | None = None
        self._users: set[int] = set()

    def acquire(self, renderer: Any) -> None:
        """Give a renderer FXAA, unless it has FXAA or SSAA already."""
        window = renderer.GetRenderWindow()
        if window is None or id(renderer) in self._users or renderer.GetUseFXAA() \
                or _has_ssaa(renderer):
            return
        if not self._users:
            self._samples = window.GetMultiSamples()
        self._users.add(id(renderer))
        window.SetMultiSamples(0)
        renderer.SetUseFXAA(True)

    def update(self, renderer: Any, render_pass: Any) -> None:
        """Leave FXAA out of frames that are multisampled, and below passes on the picture."""
        window = renderer.GetRenderWindow()
        if id(renderer) in self._users and window is not None:
            renderer.SetUseFXAA(window.GetMultiSamples() == 0 and
                                renderer.GetPass() is render_pass)

    def release(self, renderer: Any) -> None:
        """Take FXAA from a renderer that got it here."""
        if id(renderer) not in self._users:
            return
        self._users.discard(id(renderer))
        renderer.SetUseFXAA(False)
        window = renderer.GetRenderWindow()
        if not self._users and window is not None and window.GetMultiSamples() == 0 \
                and not _has_ssaa(renderer):
            window.SetMultiSamples(self._samples or 0)


def _has_ssaa(renderer: Any) -> bool:
    render_pass = renderer.GetPass()
    return render_pass is not None and bool(render_pass.IsA("vtkSSAAPass"))
