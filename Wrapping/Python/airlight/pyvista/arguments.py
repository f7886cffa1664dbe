# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Checks of arguments: each error names the parameter, the value and what to give."""

from __future__ import annotations

from collections.abc import Sequence
import math
from typing import Any

import numpy as np
import pyvista as pv

from airlight import vtkParticipatingMedium


def number(name: str, value: Any, accepted, expected: str) -> float:
    """A finite number for which ``accepted(number)`` is true; ``expected`` says what that is."""
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, float, np.number)):
        raise TypeError(f"{name} is {value!r}, a {type(value).__name__}: give {expected}.")
    value = float(value)
    if not (math.isfinite(value) and accepted(value)):
        raise ValueError(f"{name} is {value!r}: give {expected}.")
    return value


def positive(name: str, value: Any, meaning: str) -> float:
    """A finite number above 0."""
    return number(name, value, lambda x: x > 0, f"{meaning}, a finite number above 0")


def vector(name: str, value: Any, meaning: str, size: int = 3) -> tuple[float, ...]:
    """Some finite numbers, three by default."""
    expected = f"{meaning}, {size} finite numbers"
    try:
        values = np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        raise TypeError(f"{name} is {value!r}: give {expected}.") from None
    if values.shape != (size,) or not np.isfinite(values).all():
        raise ValueError(f"{name} is {value!r}: give {expected}.")
    return tuple(values.tolist())


def direction(name: str, value: Any) -> tuple[float, ...]:
    """A direction of length 1."""
    values = np.array(vector(name, value, "a direction"))
    length = np.linalg.norm(values)
    if length == 0:
        raise ValueError(f"{name} is {value!r}: give a direction, not (0, 0, 0).")
    return tuple((values / length).tolist())


def rgb(name: str, value: Any, meaning: str, largest: float = math.inf) -> tuple[float, ...]:
    """A number for all channels, three numbers, or a colour as PyVista takes it."""
    limit = "at least 0" if math.isinf(largest) else f"from 0 to {largest:g}"
    expected = f"{meaning}: a number {limit}, three of them, or a colour"
    if isinstance(value, (str, pv.Color)):
        try:
            return tuple(pv.Color(value).float_rgb)
        except ValueError:
            raise ValueError(f"{name} is {value!r}: give {expected}.") from None
    if isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{name} is {value!r}: give {expected}.")
    try:
        values = np.asarray(value, dtype=float)
    except (TypeError, ValueError):
        raise TypeError(f"{name} is {value!r}: give {expected}.") from None
    if values.shape not in ((), (3,)):
        raise ValueError(f"{name} is {value!r}: give {expected}.")
    values = np.broadcast_to(values, 3)
    if not (np.isfinite(values).all() and (values >= 0).all() and (values <= largest).all()):
        raise ValueError(f"{name} is {value!r}: give {expected}.")
    return tuple(values.tolist())


def one_of(name: str, value: Any, choices: Sequence[str]) -> str:
    """One of some words."""
    if value not in choices:
        raise ValueError(f"{name} is {value!r}: give one of {', '.join(map(repr, choices))}.")
    return value


def medium(value: Any) -> vtkParticipatingMedium:
    """A medium, or the medium of something that has one, as plotter.airlight does."""
    found = getattr(value, "medium", value)
    if not isinstance(found, vtkParticipatingMedium):
        raise TypeError(f"medium is {value!r}: give an airlight.vtkParticipatingMedium, or the "
                        "plotter.airlight of a plotter in a medium.")
    return found


def lights(value: Any) -> list:
    """One light or several."""
    values = list(value) if isinstance(value, (list, tuple, set)) else [value]
    for light in values:
        if not hasattr(light, "IsA") or not light.IsA("vtkLight"):
            raise TypeError(f"light is {light!r}: give a pyvista.Light, as plotter.airlight."
                            "add_lamp() returns it, or several.")
    return values


def occluders(value: Any) -> list[pv.PolyData]:
    """The surfaces of a data set, of several, or of none."""
    if value is None:
        return []
    if isinstance(value, pv.PolyData):
        return [value]
    if isinstance(value, pv.DataSet):
        return [value.extract_surface(algorithm="dataset_surface")]
    if isinstance(value, (pv.MultiBlock, list, tuple)):
        return [surface for part in value for surface in occluders(part)]
    raise TypeError(f"occluders is {value!r}: give a data set that casts shadows, or several.")
