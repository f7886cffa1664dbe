# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The settings of plotter.airlight.enable(), checked, and how a medium and a pass take them."""

from __future__ import annotations

from dataclasses import dataclass, fields
import math
from typing import Any

import numpy as np
import pyvista as pv

from airlight import vtkAirlightPass, vtkParticipatingMedium

from . import arguments
from .messages import Messages
from .scene import Scene

# Forward, as droplets scatter, but wide enough that lamps beside the view glow.
ANISOTROPY = 0.5

# Of the colour of the background: the sky over fog is brighter than the fog.
AMBIENT_SHARE = 0.55

SHADOWS = {
    "automatic": vtkAirlightPass.AUTOMATIC,
    "planes": vtkAirlightPass.SHADOW_PLANES,
    "map": vtkAirlightPass.SHADOW_MAP,
    "march": vtkAirlightPass.RAY_MARCH,
    "none": vtkAirlightPass.NONE,
}


TONE_MAPPINGS = {
    "clamp": vtkAirlightPass.CLAMP,
    "reinhard": vtkAirlightPass.REINHARD,
    "exponential": vtkAirlightPass.EXPONENTIAL,
    "filmic": vtkAirlightPass.GENERIC_FILMIC,
    "neutral": vtkAirlightPass.NEUTRAL_PBR,
}

COLOR_SPACES = {"linear": vtkAirlightPass.LINEAR, "srgb": vtkAirlightPass.SRGB}


@dataclass
class Settings:
    """The settings of one subplot; None is derived from the scene. See AirlightComponent.enable."""

    visibility: float | None = None
    anisotropy: float | None = None
    albedo: Any = 1.0
    ambient: Any = None
    emission: Any = None
    multiple_scattering: bool = False
    region: Any = None
    density: Any = None
    albedo_array: str | None = None
    emission_array: str | None = None
    scale_height: float | None = None
    reference_height: float | None = None
    shadows: Any = True
    lamp: bool | None = None
    white: float = 1.0
    anti_aliasing: bool | str | None = None
    tone_mapping: str | None = None
    color_space: str = "linear"
    frames: int = 1
    progressive: bool = False

    def __post_init__(self) -> None:
        if self.visibility is not None and self.visibility != math.inf:
            self.visibility = arguments.positive(
                "visibility", self.visibility,
                "the distance at which contrast falls to 2 %, in units of the scene (math.inf: "
                "clear air)")
        if self.anisotropy is not None:
            self.anisotropy = arguments.number(
                "anisotropy", self.anisotropy, lambda g: -0.99 <= g <= 0.99,
                "the mean cosine of the scattering angle, from -0.99 to 0.99")
        self.albedo = arguments.rgb("albedo", self.albedo, "the scattered share of extinction", 1)
        if self.ambient is not None:
            self.ambient = arguments.rgb("ambient", self.ambient, "a radiance")
        if self.emission is not None:
            self.emission = arguments.rgb("emission", self.emission, "radiance per unit of length")
        if self.multiple_scattering not in (True, False):
            raise TypeError(f"multiple_scattering is {self.multiple_scattering!r}: give True or "
                            "False.")
        self.white = arguments.positive("white", self.white, "the radiance that is drawn white")
        if self.lamp not in (None, True, False):
            raise TypeError(f"lamp is {self.lamp!r}: give True, False or None.")
        if self.anti_aliasing not in (None, True, False, "msaa"):
            raise TypeError(f"anti_aliasing is {self.anti_aliasing!r}: give True, False, None or "
                            "'msaa'.")
        if self.tone_mapping is not None:
            self.tone_mapping = arguments.one_of("tone_mapping", self.tone_mapping,
                                                 list(TONE_MAPPINGS))
        self.color_space = arguments.one_of("color_space", self.color_space, list(COLOR_SPACES))
        self.frames = int(arguments.number(
            "frames", self.frames, lambda n: 1 <= n <= 1024 and n == int(n),
            "how many frames make a picture, a whole number from 1 to 1024"))
        if self.progressive not in (True, False):
            raise TypeError(f"progressive is {self.progressive!r}: give True or False.")
        self._check_shadows()
        self._check_region()
        self._check_density()
        self._check_arrays()
        if self.multiple_scattering and (
                self.density is not None or isinstance(self.region, pv.DataSet) or
                (self.scale_height is not None and self.region is not None)):
            raise ValueError("multiple_scattering is True, which needs a uniform medium that is "
                             "everywhere or in bounds, or one with a scale_height that is "
                             "everywhere: leave out density, and a surface as the region.")

    def _check_shadows(self) -> None:
        if isinstance(self.shadows, bool):
            self.shadows = "automatic" if self.shadows else "none"
        self.shadows = arguments.one_of("shadows", self.shadows, list(SHADOWS))

    def _check_region(self) -> None:
        if self.region is None:
            return
        if isinstance(self.region, pv.DataSet):
            if not isinstance(self.region, pv.PolyData):
                raise TypeError(f"region is a {type(self.region).__name__}: give a closed "
                                "PolyData, as extract_surface() returns, or six bounds.")
            return
        self.region = arguments.vector("region", self.region, "xmin, xmax, ymin, ymax, zmin, zmax",
                                       6)
        if any(a > b for a, b in zip(self.region[::2], self.region[1::2])):
            raise ValueError(f"region is {self.region!r}: each minimum has to be at most its "
                             "maximum.")

    def _check_density(self) -> None:
        if self.density is not None:
            if not isinstance(self.density, pv.ImageData):
                raise TypeError(f"density is {self.density!r}: give a pyvista.ImageData whose "
                                "active point scalars are the density.")
            if self.scale_height is not None:
                raise ValueError("density and scale_height are both given: give one of them.")
        if self.scale_height is not None:
            self.scale_height = arguments.positive(
                "scale_height", self.scale_height, "the height over which density falls to 1/e")
        if self.reference_height is not None:
            self.reference_height = arguments.number(
                "reference_height", self.reference_height, lambda _: True,
                "the height (z) at which density is 1, a finite number")
            if self.scale_height is None:
                raise ValueError("reference_height is given without scale_height: give both.")

    def _check_arrays(self) -> None:
        for name in ("albedo_array", "emission_array"):
            array = getattr(self, name)
            if array is None:
                continue
            if not isinstance(array, str):
                raise TypeError(f"{name} is {array!r}: give the name of a point array of density.")
            if self.density is None:
                raise ValueError(f"{name} is {array!r} without a density: give both.")
            if array not in self.density.point_data:
                raise ValueError(f"{name} is {array!r}: give one of the density's point arrays, "
                                 f"{', '.join(map(repr, self.density.point_data.keys()))}.")
            values = np.asarray(self.density.point_data[array])
            most = {"albedo_array": 1 + 1e-6, "emission_array": 1e10}[name]
            if values.dtype == np.uint8:
                values = values / 255
            if not (values.dtype.kind in "fiub" and values.shape[1:] in ((), (1,), (3,)) and
                    np.all((values >= 0) & (values <= most))):
                raise ValueError(f"{name} is {array!r}, an array of {values.dtype} {values.shape}: "
                                 f"give one of one component or three, from 0 to {most:.0f}.")
        if (self.visibility == math.inf and self.density is None and self.region is None and
                any(self.emission or ())):
            raise ValueError("emission in clear air that is everywhere is infinite: give a region, "
                             "a density or a visibility.")
        if self.emission_array is not None and self.emission is None:
            raise ValueError(f"emission_array is {self.emission_array!r} without an emission, of "
                             "which it has factors: give both.")

    def apply_to_medium(self, medium: vtkParticipatingMedium) -> None:
        """Set all that does not depend on the scene. ValueError if the medium refuses it."""
        albedo = np.array(self.albedo)
        with Messages(medium) as messages:
            medium.SetScattering(*albedo)
            medium.SetAbsorption(*(1 - albedo))
            medium.SetPhaseFunctionToHenyeyGreenstein()
            medium.SetAnisotropy(ANISOTROPY if self.anisotropy is None else self.anisotropy)
            if self.visibility == math.inf:
                medium.SetScattering(0, 0, 0)
                medium.SetAbsorption(0, 0, 0)
            elif self.visibility is not None:
                medium.SetVisibility(self.visibility)
            if self.ambient is not None:
                medium.SetAmbientRadiance(*(x / self.white for x in self.ambient))
            medium.SetEmission(*(x / self.white for x in self.emission or (0, 0, 0)))
            medium.SetMultipleScattering(self.multiple_scattering)
            self._apply_region(medium)
            self._apply_density(medium)
        messages.raise_if_any(ValueError)

    def _apply_region(self, medium: vtkParticipatingMedium) -> None:
        if self.region is None:
            medium.SetRegionToUnbounded()
        elif isinstance(self.region, pv.PolyData):
            medium.SetSurface(self.region)
            medium.SetRegionToSurface()
        else:
            medium.SetBounds(*self.region)
            medium.SetRegionToBox()

    def _apply_density(self, medium: vtkParticipatingMedium) -> None:
        medium.SetAlbedoArrayName(self.albedo_array or "")
        medium.SetEmissionArrayName(self.emission_array or "")
        if self.density is not None:
            medium.SetDensityImage(self.density)
            medium.SetDensityToImage()
        elif self.scale_height is not None:
            medium.SetUp(0, 0, 1)
            medium.SetScaleHeight(self.scale_height)
            medium.SetReferenceHeight(self.reference_height or 0.0)
            medium.SetDensityToExponentialHeight()
        else:
            medium.SetDensityToUniform()

    def derive_from_scene(self, medium: vtkParticipatingMedium, scene: Scene) -> None:
        """Set what is None and depends on the scene's size."""
        if self.visibility is None:
            medium.SetVisibility(scene.visibility)
        if self.scale_height is not None and self.reference_height is None:
            medium.SetReferenceHeight(float(scene.low[2]))
        if self.scale_height is not None:
            medium.SetGround(True)
            medium.SetGroundHeight(float(scene.low[2]))

    def derive_ambient(self, medium: vtkParticipatingMedium, background: Any) -> None:
        """Set the ambient radiance, if it is None, from the colour of the background."""
        if self.ambient is None:
            medium.SetAmbientRadiance(*(AMBIENT_SHARE * x for x in background))

    def apply_to_pass(self, render_pass: vtkAirlightPass) -> None:
        """Set all that does not depend on the medium."""
        render_pass.SetShadowTechnique(SHADOWS[self.shadows])
        render_pass.SetSurfaceShadows(self.shadows != "none")
        render_pass.SetSubpixelFrames(self.frames)
        render_pass.MultisamplingOff()
        if not self.progressive:
            render_pass.ProgressiveRefinementOff()
        render_pass.SetOutputColorSpace(COLOR_SPACES[self.color_space])
        if self.tone_mapping is not None:
            render_pass.SetToneMapping(TONE_MAPPINGS[self.tone_mapping])

    def derive_tone_mapping(self, render_pass: vtkAirlightPass, *, is_clear: bool) -> None:
        """Set the tone mapping, if it is None; clear air is to look as without the pass."""
        if self.tone_mapping is None:
            render_pass.SetToneMapping(TONE_MAPPINGS["clamp" if is_clear else "neutral"])

    def as_dict(self) -> dict[str, Any]:
        """The settings as a dict of numbers, words, tuples and copies of data sets."""
        values = {field.name: getattr(self, field.name) for field in fields(self)}
        return {name: value.copy() if isinstance(value, pv.DataSet) else value
                for name, value in values.items()}
