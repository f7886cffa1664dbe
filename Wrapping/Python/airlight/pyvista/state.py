# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Media as plain dicts."""

from __future__ import annotations

from typing import Any

from airlight import vtkParticipatingMedium

from .messages import Messages

# Properties with a Set and a Get method; the phase function and the coefficients go first.
PROPERTIES = ("Scattering", "Absorption", "PhaseFunction", "Anisotropy", "PhaseTolerance",
              "AmbientRadiance", "SkyRadiance", "GroundRadiance", "SkyHarmonics", "Emission",
              "MultipleScattering",
              "Ground", "GroundHeight", "GroundAlbedo", "Bounds", "Center", "Radius", "Height", "Axis", "Region",
              "ScaleHeight", "ReferenceHeight", "Up", "Density")

# Those that dicts of earlier versions do not have.
ADDED = {"SkyRadiance", "GroundRadiance", "SkyHarmonics"}


def medium_to_dict(medium: vtkParticipatingMedium) -> dict[str, Any]:
    """The numbers of a medium; ValueError if it has an object that is no number."""
    objects = {
        "a phase function object": medium.GetPhaseFunctionObject(),
        "a phase table": medium.GetPhaseTable(),
        "a surface": medium.GetSurface(),
        "a density image": medium.GetDensityImage(),
    }
    for name, found in objects.items():
        if found is not None:
            raise ValueError(f"medium has {name}, which get_state() cannot keep in a dict: save it "
                             "apart, and enable(medium=...) again.")
    values = {name: getattr(medium, "Get" + name)() for name in PROPERTIES}
    return {name: tuple(value) if isinstance(value, (tuple, list)) else
            float(value) if isinstance(value, float) else int(value)
            for name, value in values.items()}


def medium_from_dict(values: dict[str, Any]) -> vtkParticipatingMedium:
    """A medium from the dict of medium_to_dict(); ValueError if it is none."""
    if not isinstance(values, dict) or set(values) | ADDED != set(PROPERTIES):
        raise ValueError(f"state: medium is {values!r}; give what get_state() returned.")
    medium = vtkParticipatingMedium()
    with Messages(medium) as messages:
        for name in PROPERTIES:
            if name in values:
                getattr(medium, "Set" + name)(values[name])
    messages.raise_if_any(ValueError)
    return medium
