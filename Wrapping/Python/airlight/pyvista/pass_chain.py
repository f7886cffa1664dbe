# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Where the medium's pass stands among the other passes of a renderer."""

from __future__ import annotations

from typing import Any
import warnings

from vtkmodules.vtkRenderingOpenGL2 import vtkRenderStepsPass

# Passes that work on the finished picture, and passes that work on surfaces, which the medium then
# covers. PyVista wraps both around its base. See Documentation/composition.md.
OUTSIDE = ("vtkSSAAPass", "vtkDepthOfFieldPass", "vtkGaussianBlurPass", "vtkOpenGLFXAAPass",
           "vtkToneMappingPass")
INSIDE = ("vtkSSAOPass", "vtkEDLShading")  # innermost first
SHADOWS = ("vtkShadowMapPass", "vtkShadowMapBakerPass")
PLAIN = ("vtkRenderStepsPass",)


def _steps(render_pass: Any) -> list:
    """The passes that a pass draws by: its delegate, or the members of a sequence."""
    found = []
    if render_pass.IsA("vtkSequencePass"):
        passes = render_pass.GetPasses()
        if passes is not None:
            found = [passes.GetItemAsObject(i) for i in range(passes.GetNumberOfItems())]
    elif hasattr(render_pass, "GetDelegatePass"):
        found = [render_pass.GetDelegatePass()]
    return [step for step in found if step is not None]


def _contains(render_pass: Any, wanted: Any) -> bool:
    return render_pass is wanted or any(_contains(step, wanted) for step in _steps(render_pass))


def _leaves(render_pass: Any) -> list:
    """The names of the passes that a base draws by."""
    if render_pass is None:
        return []
    if render_pass.GetClassName() in ("vtkCameraPass", "vtkSequencePass"):
        return [name for step in _steps(render_pass) for name in _leaves(step)]
    return [render_pass.GetClassName()]


class PassChain:
    """Keeps the medium's pass in a renderer whose other passes come and go.

    PyVista replaces the renderer's pass when an effect is switched on or off. ``install()`` puts
    the medium's pass back: below effects on the picture (SSAA, depth of field, blur, FXAA, tone
    mapping), and above effects on surfaces (SSAO, eye-dome lighting), which become its delegates.
    """

    def __init__(self) -> None:
        self._top: Any = None
        self._foreign: Any = None
        self._delegates: list = []
        self._steps: Any = None
        self._warned: set[str] = set()
        self.refused: str | None = None

    def install(self, renderer: Any, render_pass: Any) -> None:
        """Put the pass in its place, if it is not there."""
        top = renderer.GetPass()
        if top is not None and _contains(top, render_pass):
            self.refused = None
            return
        outside, inside, base = self._take_apart(top)
        reason = self._refuse(base)
        if reason:
            if self._top is not top:
                self.forget()
            self.refused = reason
            self._warn(reason)
            return
        self.refused = None
        self._foreign = top
        self._delegates = [(each, each.GetDelegatePass()) for each in (*outside, *inside)]
        self._compose(renderer, render_pass, outside, inside)
        if any(name in SHADOWS for name in _leaves(base)):
            self._warn("VTK's shadow maps (enable_shadows) are left out in a medium: Airlight "
                       "casts the shadows on surfaces itself. disable_shadows() ends this warning.")

    def remove(self, renderer: Any, render_pass: Any) -> None:
        """Give the renderer the passes that it would have without the medium."""
        render_pass.SetDelegatePass(None)
        if self._top is not None and renderer.GetPass() is self._top:
            for each, delegate in self._delegates:
                each.SetDelegatePass(delegate)
            renderer.SetPass(self._foreign)
        elif renderer.GetPass() is render_pass:
            renderer.SetPass(None)
        self.forget()
        self.refused = None

    def forget(self) -> None:
        """Give up what was installed, without changing the renderer."""
        self._top = self._foreign = self._steps = None
        self._delegates = []

    @staticmethod
    def _take_apart(top: Any) -> tuple[list, list, Any]:
        """Effects on the picture, outermost first, effects on surfaces, and the pass below."""
        outside, inside = [], []
        step = top
        while step is not None and step.GetClassName() in OUTSIDE + INSIDE:
            (outside if step.GetClassName() in OUTSIDE else inside).append(step)
            step = step.GetDelegatePass()
        return outside, inside, step

    @staticmethod
    def _refuse(base: Any) -> str | None:
        unknown = [name for name in _leaves(base) if name not in PLAIN + SHADOWS]
        if not unknown:
            return None
        return (f"The renderer has a pass that Airlight does not know how to compose with "
                f"({unknown[0]}): the scene is drawn without the medium. Call SetPass(None) of "
                f"the renderer, or build a chain of passes that has plotter.airlight.render_pass "
                f"in it.")

    def _compose(self, renderer: Any, render_pass: Any, outside: list, inside: list) -> None:
        delegate = None
        for name in INSIDE:
            for each in (p for p in inside if p.GetClassName() == name):
                if delegate is None:
                    self._steps = delegate = vtkRenderStepsPass()
                each.SetDelegatePass(delegate)
                delegate = each
        render_pass.SetDelegatePass(delegate)
        top = render_pass
        for each in reversed(outside):
            each.SetDelegatePass(top)
            top = each
        self._top = top
        renderer.SetPass(top)

    def _warn(self, text: str) -> None:
        """Once for each text."""
        if text not in self._warned:
            self._warned.add(text)
            warnings.warn(text, UserWarning, stacklevel=2)
