# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""``mesh.airlight`` of every data set: radiance and irradiance at its points."""

from __future__ import annotations

from typing import Any

import pyvista as pv

from airlight import vtkAirlightProbeFilter

from . import arguments
from .messages import Messages

# All data sets but PolyData, which has an accessor of its own; PyVista warns of two in one line of
# inheritance.
TARGETS = (pv.ImageData, pv.RectilinearGrid, pv.StructuredGrid, pv.UnstructuredGrid,
           pv.ExplicitStructuredGrid, pv.PointSet)


class DataSetAirlight:
    """Light in a medium at the points of a data set: ``mesh.airlight``.

    Parameters
    ----------
    dataset : pyvista.DataSet
        The data set.
    """

    def __init__(self, dataset: pv.DataSet) -> None:
        self._dataset = dataset

    def probe(self, medium: Any, lights: Any = (), *, viewpoint: Any = (0.0, 0.0, 0.0),
              occluders: Any = None, scattered: bool = False) -> pv.DataSet:
        """Compute radiance, transmittance and irradiance at the points, in double precision.

        Parameters
        ----------
        medium : vtkParticipatingMedium | AirlightComponent
            The medium.
        lights : pyvista.Light | sequence[pyvista.Light], optional
            The lights.
        viewpoint : sequence[float], default: (0.0, 0.0, 0.0)
            The position of the eye.
        occluders : pyvista.DataSet | sequence[pyvista.DataSet], optional
            Data sets whose surfaces cast shadows; in the coordinates of this one.
        scattered : bool, default: False
            Whether to compute the irradiance by light that the medium scattered, too. It needs
            point normals.

        Returns
        -------
        pyvista.DataSet
            A copy with these point data, RGB: ``"Radiance"``, what the medium between the point
            and the eye sends to the eye; ``"Transmittance"`` from the point to the eye;
            ``"DirectIrradiance"``, on the side of the point's normal, or of a small sphere if
            there are no normals; ``"ScatteredIrradiance"``.

        Raises
        ------
        TypeError, ValueError
            If an argument is invalid.
        RuntimeError
            If the filter reports an error, as the message says.
        """
        probe = vtkAirlightProbeFilter()
        probe.SetInputData(self._dataset)
        probe.SetMedium(arguments.medium(medium))
        for light in arguments.lights(lights):
            probe.AddLight(light)
        for surface in arguments.occluders(occluders):
            probe.AddOccluderData(surface)
        probe.SetViewpoint(*arguments.vector("viewpoint", viewpoint, "the position of the eye"))
        probe.SetScatteredIrradiance(bool(scattered))
        return update(probe)


def update(algorithm: Any) -> pv.DataSet:
    """Run a filter and return its output; RuntimeError if it reports an error."""
    with Messages(algorithm) as messages:
        algorithm.Update()
    messages.raise_if_any()
    output = pv.wrap(algorithm.GetOutput())
    return output.copy(deep=False)


for _target in TARGETS:
    pv.register_dataset_accessor("airlight", _target)(DataSetAirlight)
