# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""A lamp or a sun in physical units, as a PyVista light."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
import pyvista as pv

from airlight import vtkAirlight, vtkAirlightLight, vtkAirlightPass

from . import arguments
from .messages import Messages

# The units of lamps and of suns, and the system that each belongs to.
LAMP_UNITS = {"W/sr": "radiometric", "cd": "photometric"}
SUN_UNITS = {"W/m^2": "radiometric", "lx": "photometric"}


# What a lamp that is no point has, in states; those of older versions have none of it.
EXTENTS = ("radius", "size", "angular_diameter", "visible")


class Lamp:
    """A lamp at a position, or a sun, and the light that draws it.

    Parameters
    ----------
    light : pyvista.Light
        The light, whose position and direction are set.
    power : tuple[float, float, float]
        Radiant intensity or irradiance for red, green and blue.
    unit : str
        A key of LAMP_UNITS or SUN_UNITS.
    is_sun : bool
        Whether the light is directional.
    is_derived : bool
        Whether Airlight made it because no light of the scene scatters.
    """

    def __init__(self, light: pv.Light, power: tuple[float, ...], unit: str, *,
                 is_sun: bool = False, is_derived: bool = False) -> None:
        self.light = light
        self.power = power
        self.unit = unit
        self.is_sun = is_sun
        self.is_derived = is_derived

    @property
    def system(self) -> str:
        """The system of the unit, "radiometric" or "photometric"."""
        return {**LAMP_UNITS, **SUN_UNITS}[self.unit]

    def expose(self, white: float) -> None:
        """Give the light its power, for a radiance of ``white`` that is drawn white."""
        rgb = [value / white for value in self.power]
        light = self.light
        if self.is_sun:
            vtkAirlight.SetIrradiance(light, rgb)
            return
        cone, is_on = light.cone_angle, light.on
        vtkAirlight.SetRadiantIntensity(light, rgb)
        light.cone_angle = cone
        light.on = is_on

    def as_dict(self) -> dict[str, Any]:
        """Numbers and words from which ``from_dict`` makes the lamp again."""
        light = self.light
        return {
            "kind": "sun" if self.is_sun else "lamp",
            "position": tuple(light.position),
            "focal_point": tuple(light.focal_point),
            "power": tuple(self.power),
            "unit": self.unit,
            "cone_angle": float(light.cone_angle),
            "exponent": float(light.exponent),
            "ies": vtkAirlightLight.GetPhotometry(light) or None,
            **get_extent(light),
            "on": bool(light.on),
        }

    @classmethod
    def from_dict(cls, values: dict[str, Any]) -> Lamp:
        """The lamp of a dict of ``as_dict``; ValueError if it is none."""
        try:
            is_sun = values["kind"] == "sun"
            unit = arguments.one_of("unit", values["unit"], list(SUN_UNITS if is_sun
                                                                 else LAMP_UNITS))
            light = pv.Light(position=arguments.vector("position", values["position"], "a point"),
                             focal_point=arguments.vector("focal_point", values["focal_point"],
                                                          "a point"),
                             positional=not is_sun, cone_angle=values["cone_angle"],
                             exponent=values["exponent"])
            lamp = cls(light, arguments.rgb("power", values["power"], "a power"), unit,
                       is_sun=is_sun)
            light.on = values["on"]
            ies = values["ies"]
            set_extent(light, **{name: values[name] for name in EXTENTS if name in values})
        except KeyError as error:
            raise ValueError(f"state: a lamp has no {error}; give what get_state() returned.") \
                from None
        if ies:
            read_photometry(light, ies)
        return lamp


def get_extent(light: pv.Light) -> dict[str, Any]:
    """The extent of a lamp, by the names of EXTENTS."""
    size = [0.0, 0.0]
    vtkAirlightLight.GetSize(light, size)
    return {"radius": vtkAirlightLight.GetRadius(light), "size": tuple(size),
            "angular_diameter": vtkAirlightLight.GetAngularDiameter(light),
            "visible": vtkAirlightLight.GetVisible(light)}


def set_extent(light: pv.Light, radius: Any = 0.0, size: Any = (0.0, 0.0),
               angular_diameter: Any = 0.0, visible: Any = False) -> None:
    """Give a lamp its extent, checked."""
    if visible not in (True, False):
        raise TypeError(f"visible is {visible!r}: give True or False.")
    radius = arguments.number("radius", radius, lambda x: 0 <= x <= 1e100,
                              "the radius of the lamp, a finite number, at least 0")
    width, height = arguments.vector("size", size, "width and height of the lamp", 2)
    angular_diameter = arguments.number(
        "angular_diameter", angular_diameter, lambda x: 0 <= x < 180,
        "the diameter of a sun's disc in degrees, at least 0 and below 180")
    if visible and not (radius > 0 or (width > 0 and height > 0) or angular_diameter > 0):
        raise ValueError("visible is True, and nothing is seen of a point: give the lamp a radius, "
                         "or the sun an angular_diameter, above 0.")
    with Messages(light) as messages:
        vtkAirlightLight.SetRadius(light, radius)
        vtkAirlightLight.SetSize(light, width, height)
        vtkAirlightLight.SetAngularDiameter(light, angular_diameter)
        vtkAirlightLight.SetVisible(light, bool(visible))
    messages.raise_if_any(ValueError)


def read_photometry(light: pv.Light, ies: Any) -> None:
    """Let a light emit as a photometric file says; an exception names what is wrong with it."""
    file = os.fspath(ies)
    with open(file, "rb"):
        pass  # Python says why a file cannot be read
    reporter = vtkAirlightPass()
    with Messages(reporter) as messages:
        read = reporter.SetLightPhotometry(light, str(file))
    messages.raise_if_any(ValueError)
    if not read:
        raise ValueError(f"ies is {file!r}: give a photometric file of IES LM-63.")


def make_lamp(position: Any, intensity: Any, unit: str | None, color: Any, target: Any,
              direction: Any, cone_angle: Any, exponent: Any, ies: Any,
              radius: Any, derive: Any, visible: Any = False) -> Lamp:
    """A lamp from the arguments of AirlightComponent.add_lamp(), checked.

    ``derive(position)`` returns the intensity for None.
    """
    position = arguments.vector("position", position, "where the lamp is")
    if target is not None and direction is not None:
        raise ValueError("target and direction are both given: give one of them.")
    aim = (0.0, 0.0, -1.0)
    if target is not None:
        target = arguments.vector("target", target, "the point that the lamp aims at")
        if target == position:
            raise ValueError(f"target is {target!r}, the position of the lamp: give another point.")
        aim = tuple(np.subtract(target, position).tolist())
    elif direction is not None:
        aim = arguments.direction("direction", direction)
    if cone_angle is None:
        cone_angle = 180.0
    else:
        cone_angle = arguments.number(
            "cone_angle", cone_angle, lambda x: 0 < x < 90,
            "the angle in degrees between a spotlight's axis and its edge, above 0 and below 90")
        if target is None and direction is None:
            raise ValueError("cone_angle is given without a direction: give target or direction.")
    exponent = arguments.number("exponent", exponent, lambda x: 0 <= x <= 128,
                                "the exponent of the cosine in a cone, from 0 to 128")
    color = arguments.rgb("color", color, "a colour")
    light = pv.Light(position=position, focal_point=np.add(position, aim), positional=True,
                     cone_angle=cone_angle, exponent=exponent)
    set_extent(light, radius=radius, visible=visible)
    if ies is not None:
        read_photometry(light, ies)
        if intensity is None:
            intensity = vtkAirlightLight.GetPhotometryMaximum(light)
            unit = unit or "cd"
    unit = arguments.one_of("unit", unit or "W/sr", list(LAMP_UNITS))
    if intensity is None:
        intensity = derive(np.array(position))
    power = arguments.rgb("intensity", intensity, f"an intensity in {unit}")
    return Lamp(light, tuple(np.multiply(power, color).tolist()), unit)


def make_sun(direction: Any, irradiance: Any, unit: str, color: Any,
             angular_diameter: Any = 0.0, visible: Any = False) -> Lamp:
    """A sun from the arguments of AirlightComponent.add_sun(), checked."""
    direction = arguments.direction("direction", direction)
    unit = arguments.one_of("unit", unit, list(SUN_UNITS))
    color = arguments.rgb("color", color, "a colour")
    power = arguments.rgb("irradiance", irradiance, f"an irradiance in {unit}")
    light = pv.Light(position=np.negative(direction), focal_point=(0, 0, 0), positional=False)
    set_extent(light, angular_diameter=angular_diameter, visible=visible)
    return Lamp(light, tuple(np.multiply(power, color).tolist()), unit, is_sun=True)
