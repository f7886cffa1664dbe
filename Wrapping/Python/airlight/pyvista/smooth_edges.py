# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""FXAA or multisampling for the subplots in a medium."""

from __future__ import annotations

from typing import Any

# Of a window that has none; more make annotations smoother, and not the medium.
SAMPLES = 4


class SmoothEdges:
    """Chooses between FXAA and a window's multisampling for its subplots.

    VTK's FXAA draws black in a multisampled window. So the samples are switched off while subplots
    have FXAA and none has multisampling, and come back when the last one has released them. In a
    window that is multisampled all the same, these subplots have multisampling, too.
    """

    def __init__(self) -> None:
        self._samples = 0  # of the window before the first subplot came
        self._set = 0  # here
        self._smoothed: set[int] = set()  # by FXAA
        self._sampled: set[int] = set()

    def acquire(self, renderer: Any) -> None:
        """Give a renderer FXAA, unless it has FXAA or SSAA already."""
        if id(renderer) in self._sampled:
            self.release(renderer)
        if renderer.GetRenderWindow() is None or id(renderer) in self._smoothed \
                or renderer.GetUseFXAA() or _has_ssaa(renderer):
            return
        self._remember(renderer.GetRenderWindow())
        self._smoothed.add(id(renderer))
        self._choose(renderer.GetRenderWindow())
        renderer.SetUseFXAA(True)

    def acquire_samples(self, renderer: Any) -> None:
        """Let a renderer have the window's samples, and the window some if it has none."""
        if id(renderer) in self._smoothed:
            self.release(renderer)
        if renderer.GetRenderWindow() is not None:
            self._remember(renderer.GetRenderWindow())
            self._sampled.add(id(renderer))
            self._choose(renderer.GetRenderWindow())

    def update(self, renderer: Any, render_pass: Any) -> None:
        """Leave FXAA out of frames that are multisampled, and below passes on the picture."""
        window = renderer.GetRenderWindow()
        if window is None or id(renderer) not in self._smoothed | self._sampled:
            return
        render_pass.SetMultisampling(window.GetMultiSamples() > 1)
        if id(renderer) in self._smoothed:
            renderer.SetUseFXAA(window.GetMultiSamples() == 0 and
                                renderer.GetPass() is render_pass)

    def release(self, renderer: Any) -> None:
        """Take from a renderer what it got here."""
        if id(renderer) not in self._smoothed | self._sampled:
            return
        if id(renderer) in self._smoothed:
            renderer.SetUseFXAA(False)
        self._smoothed.discard(id(renderer))
        self._sampled.discard(id(renderer))
        if renderer.GetRenderWindow() is not None and not _has_ssaa(renderer):
            self._choose(renderer.GetRenderWindow())

    def _remember(self, window: Any) -> None:
        if not self._smoothed and not self._sampled:
            self._samples = self._set = window.GetMultiSamples()

    def _choose(self, window: Any) -> None:
        if window.GetMultiSamples() != self._set:
            return  # of the user
        if self._sampled:
            self._set = self._samples if self._samples > 1 else SAMPLES
        else:
            self._set = 0 if self._smoothed else self._samples
        window.SetMultiSamples(self._set)


def _has_ssaa(renderer: Any) -> bool:
    render_pass = renderer.GetPass()
    return render_pass is not None and bool(render_pass.IsA("vtkSSAAPass"))
