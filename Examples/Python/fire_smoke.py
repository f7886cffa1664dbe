# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The smoke of a fire in a hall: a small plume solver, and readers of the output of FDS.

The solver is a sketch for examples, no fire model. Zukoski's correlation gives what the fire's
plume lifts to the ceiling, m = 0.071 Q^(1/3) z^(5/3) kg/s with Q in kW. Under the ceiling the hot
layer spreads as a gravity current, whose depth h diffuses with 1.5 m sqrt(g' h), past walls, and
carries the soot. Below the layer the smoke thins out with 1/e in 0.5 m.
"""

import os

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData

LENGTH, WIDTH, HEIGHT = 24.0, 14.0, 4.0  # m, of the hall, along x, y and z
WALL_X, WALL_END = 13.0, 8.0  # a partition wall from y = 0 to there; beyond it is the passage
FIRE = (6.0, 8.0)
POWER = 300.0  # kW, the convective part of the heat
SOOT = 1.2e-3  # kg/s
STEP = 0.5  # m, of the solver
HOT = 1.6  # m/s^2, reduced gravity g' of the layer
THINNING = 0.5  # m


def solve_layer(seconds):
    """Depth of the layer [m] and its soot [kg/m^3] in the cells of the plan, [y, x]."""
    count = (round(WIDTH / STEP), round(LENGTH / STEP))
    y, x = ((np.arange(n) + 0.5) * STEP for n in count)
    open_x = np.ones((count[0], count[1] - 1))  # between neighbours along x
    open_x[y < WALL_END, round(WALL_X / STEP) - 1] = 0
    source = np.exp(-((x - FIRE[0])**2 + (y[:, None] - FIRE[1])**2) / 1.5**2)
    source /= source.sum() * STEP**2
    depth, mass = np.full(count, 0.02), np.zeros(count)  # m, kg/m^2
    time, dt = 0.0, 0.012
    while time < seconds:
        clear = max(HEIGHT - depth[np.unravel_index(source.argmax(), count)], 0.5)
        lifted = 0.071 * POWER**(1 / 3) * clear**(5 / 3) / 1.0  # m^3/s, of hot gas of 1 kg/m^3
        spread = 1.5 * np.sqrt(HOT * depth)
        share = mass / depth
        depth, mass = depth + dt * lifted * source, mass + dt * SOOT * source
        for axis, gate in ((1, open_x), (0, 1)):
            low = tuple(slice(None, -1) if i == axis else slice(None) for i in (0, 1))
            high = tuple(slice(1, None) if i == axis else slice(None) for i in (0, 1))
            flow = gate * (spread[low] + spread[high]) / 2 * (depth[low] - depth[high])
            flow *= dt / STEP**2
            carried = flow * np.where(flow > 0, share[low], share[high])
            for values, moved in ((depth, flow), (mass, carried)):
                values[low] -= moved
                values[high] += moved
        time += dt
    return np.minimum(depth, HEIGHT), mass / depth


def solve_plume(seconds=60.0):
    """A vtkImageData with point scalars "soot density" [kg/m^3], seconds after ignition."""
    depth, soot = solve_layer(seconds)
    z = np.linspace(0, HEIGHT, 21)
    # Cells become points: the image's points are the cells' corners.
    depth, soot = (np.pad(values, 1, mode="edge") for values in (depth, soot))
    depth, soot = ((v[1:, 1:] + v[1:, :-1] + v[:-1, 1:] + v[:-1, :-1]) / 4 for v in (depth, soot))
    below = np.maximum(HEIGHT - depth - z[:, None, None], 0)
    density = soot * np.exp(-below / THINNING)
    # The plume itself, a cone of Gaussians that carries the soot of the fire upwards.
    y, x = np.arange(depth.shape[0]) * STEP, np.arange(depth.shape[1]) * STEP
    radius = 0.5 + 0.13 * z[:, None, None]
    flow = 0.071 * POWER**(1 / 3) * (z[:, None, None] + 1)**(5 / 3)
    squared = (x - FIRE[0])**2 + (y[:, None] - FIRE[1])**2
    density = np.maximum(density, SOOT / flow * np.exp(-squared / radius**2))

    image = vtkImageData()
    image.SetDimensions(density.shape[::-1])
    image.SetSpacing(STEP, STEP, z[1])
    array = numpy_to_vtk(density.astype(np.float32).ravel(), deep=True)
    array.SetName("soot density")
    image.GetPointData().SetScalars(array)
    return image


def read_plot3d(grid, values):
    """FDS's Plot3D files: name.xyz and name.q. The five quantities of PLOT3D_QUANTITY become
    "Density", "Momentum" (three components) and "StagnationEnergy"."""
    from vtkmodules.vtkIOParallel import vtkMultiBlockPLOT3DReader
    reader = vtkMultiBlockPLOT3DReader()
    reader.SetXYZFileName(grid)
    reader.SetQFileName(values)
    reader.BinaryFileOn()
    reader.HasByteCountOn()  # Fortran's unformatted records
    reader.MultiGridOff()
    reader.IBlankingOn()
    reader.SetByteOrderToLittleEndian()
    reader.Update()
    return reader.GetOutput()


def read_vtkhdf(path):
    """FDS's VTKHDF files, of slices in space or meshes."""
    from vtkmodules.vtkIOHDF import vtkHDFReader
    reader = vtkHDFReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutputDataObject(0)


def read_results(path):
    """The data set of a file of FDS: a .vtkhdf, or a .q beside its .xyz."""
    name, suffix = os.path.splitext(path)
    if suffix == ".q":
        return read_plot3d(name + ".xyz", path)
    if suffix == ".vtkhdf":
        return read_vtkhdf(path)
    raise ValueError(f"'{path}' is neither a .q of Plot3D nor a .vtkhdf")
