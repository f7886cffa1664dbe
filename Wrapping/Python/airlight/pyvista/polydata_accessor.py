# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""``mesh.airlight`` of PolyData: shadows as meshes, and light along lines."""

from __future__ import annotations

from typing import Any

import numpy as np
import pyvista as pv

from airlight import (
    vtkAirlight, vtkLitIntervalsFilter, vtkShadowPlanesFilter, vtkSilhouetteEdgesFilter)

from . import arguments
from .dataset_accessor import DataSetAirlight, update


@pv.register_dataset_accessor("airlight", pv.PolyData)
class PolyDataAirlight(DataSetAirlight):
    """Shadows of a mesh, and light along its lines: ``mesh.airlight``.

    Parameters
    ----------
    dataset : pyvista.PolyData
        The mesh.
    """

    def silhouette(self, light: Any) -> pv.PolyData:
        """Extract the edges that separate light from shadow, seen from a light.

        Parameters
        ----------
        light : pyvista.Light | sequence[float]
            The light, or the position of a point light.

        Returns
        -------
        pyvista.PolyData
            Lines, directed so that their shadow is to the left, seen from the light. Cell data
            ``"Weight"``: 1 at a border, 2 at the silhouette of a closed surface.

        Raises
        ------
        TypeError, ValueError
            If an argument is invalid.
        RuntimeError
            If the mesh has no polygons, or the light is on it.
        """
        return update(self._silhouette(vtkSilhouetteEdgesFilter(), light))

    def shadow_volume(self, light: Any, *, distance: float | None = None, bounds: Any = None,
                      caps: bool = True) -> pv.PolyData:
        """Make the surface of the space that the mesh shades.

        Parameters
        ----------
        light : pyvista.Light | sequence[float]
            The light, or the position of a point light.
        distance : float, optional
            How far the shadow extends behind the silhouette, above 0. None: twice the diagonal of
            the mesh.
        bounds : sequence[float], optional
            The box that the shadow fills (xmin, xmax, ymin, ymax, zmin, zmax), instead of a
            distance.
        caps : bool, default: True
            Whether to close the surface, by the lit part of the mesh and at the far end.

        Returns
        -------
        pyvista.PolyData
            Polygons. Cell data ``"Weight"``: the number of volumes that a polygon bounds;
            ``"Part"``: 0 for the sides, 1 for the mesh, 2 for the far end.

        Raises
        ------
        TypeError, ValueError
            If an argument is invalid.
        RuntimeError
            If the mesh has no polygons, or the light is on it.
        """
        planes = vtkShadowPlanesFilter()
        if distance is not None and bounds is not None:
            raise ValueError("distance and bounds are both given: give one of them.")
        if distance is not None:
            planes.SetFarDistance(arguments.positive("distance", distance, "a length"))
        if bounds is not None:
            box = arguments.vector("bounds", bounds, "xmin, xmax, ymin, ymax, zmin, zmax", 6)
            if any(a >= b for a, b in zip(box[::2], box[1::2])):
                raise ValueError(f"bounds is {bounds!r}: each minimum has to be below its maximum.")
            planes.SetBounds(*box)
            planes.SetExtentToBounds()
        planes.SetLightCap(bool(caps))
        planes.SetFarCap(bool(caps))
        return update(self._silhouette(planes, light))

    def _silhouette(self, algorithm: Any, light: Any) -> Any:
        algorithm.SetInputData(self._dataset)
        if hasattr(light, "IsA"):
            algorithm.SetLight(arguments.lights(light)[0])
        else:
            algorithm.SetLightPosition(*arguments.vector("light", light, "a light or its position"))
        return algorithm

    def lit_intervals(self, medium: Any, light: Any, *, occluders: Any = None) -> pv.PolyData:
        """Cut the lines into their lit parts, in double precision.

        Parameters
        ----------
        medium : vtkParticipatingMedium | AirlightComponent
            The medium.
        light : pyvista.Light
            The light.
        occluders : pyvista.DataSet | sequence[pyvista.DataSet], optional
            Data sets whose surfaces cast shadows.

        Returns
        -------
        pyvista.PolyData
            A line for each part. Cell data: ``"Length"``, ``"Start"`` and ``"End"`` along the
            line, ``"Airlight"`` that the part sends to the line's first point (RGB),
            ``"OpticalDepth"``, ``"Transmittance"`` and ``"SourceCell"``; help() of
            ``airlight.vtkLitIntervalsFilter`` lists all.

        Raises
        ------
        TypeError, ValueError
            If an argument is invalid, or the mesh has no lines.
        RuntimeError
            If the filter reports an error.
        """
        self._count_lines()
        intervals = vtkLitIntervalsFilter()
        intervals.SetInputData(self._dataset)
        intervals.SetLight(arguments.lights(light)[0])
        intervals.SetMedium(arguments.medium(medium))
        for surface in arguments.occluders(occluders):
            intervals.AddOccluderData(surface)
        return update(intervals)

    def transmittance(self, medium: Any) -> pv.PolyData:
        """Compute the share of light that is left along each line, in double precision.

        Parameters
        ----------
        medium : vtkParticipatingMedium | AirlightComponent
            The medium.

        Returns
        -------
        pyvista.PolyData
            A copy with the cell data ``"Transmittance"``: for red, green and blue, from 0 to 1, of
            each line from its first point to its last one; NaN of cells that are no lines.

        Raises
        ------
        TypeError, ValueError
            If the medium is none, or the mesh has no lines.
        """
        medium = arguments.medium(medium)
        rgb = [0.0, 0.0, 0.0]

        def along(points: np.ndarray) -> np.ndarray:
            left = np.ones(3)
            for a, b in zip(points[:-1].tolist(), points[1:].tolist()):
                vtkAirlight.Transmittance(medium, a, b, rgb)
                left *= rgb
            return left
        return self._with_line_data("Transmittance", map(along, self._lines()))

    def inscatter(self, medium: Any, lights: Any, *, occluders: Any = None) -> pv.PolyData:
        """Compute the airlight that each line gathers, with shadows, in double precision.

        Parameters
        ----------
        medium : vtkParticipatingMedium | AirlightComponent
            The medium.
        lights : pyvista.Light | sequence[pyvista.Light]
            The lights.
        occluders : pyvista.DataSet | sequence[pyvista.DataSet], optional
            Data sets whose surfaces cast shadows.

        Returns
        -------
        pyvista.PolyData
            A copy with the cell data ``"Airlight"``: the radiance that the medium along the line
            scatters to its first point, for red, green and blue, without ambient radiance; NaN of
            cells that are no lines.

        Raises
        ------
        TypeError, ValueError
            If an argument is invalid, or the mesh has no lines.
        RuntimeError
            If the filter reports an error.
        """
        total = np.zeros((self._dataset.n_cells, 3))
        for light in arguments.lights(lights):
            parts = self.lit_intervals(medium, light, occluders=occluders)
            if parts.n_cells:
                np.add.at(total, np.asarray(parts.cell_data["SourceCell"]),
                          np.asarray(parts.cell_data["Airlight"]))
        return self._with_line_data("Airlight", total[self._dataset.n_verts:])

    def _count_lines(self) -> int:
        count = self._dataset.n_lines
        if not count:
            raise ValueError("The mesh has no lines: make sight lines by pyvista.Line(), or "
                             "pyvista.line_segments_from_points().")
        return count

    def _lines(self) -> list[np.ndarray]:
        """The points of each line."""
        self._count_lines()
        points = np.asarray(self._dataset.points, dtype=float)
        lines = self._dataset.GetLines()
        offsets = pv.convert_array(lines.GetOffsetsArray())
        ids = pv.convert_array(lines.GetConnectivityArray())
        return [points[ids[a:b]] for a, b in zip(offsets[:-1], offsets[1:])]

    def _with_line_data(self, name: str, values: Any) -> pv.PolyData:
        """A copy whose lines, which VTK numbers after the vertices, have these values."""
        data = np.full((self._dataset.n_cells, 3), np.nan)
        first, count = self._dataset.n_verts, self._count_lines()
        data[first:first + count] = list(values)[:count]
        result = self._dataset.copy(deep=False)
        result.cell_data[name] = data
        return result
