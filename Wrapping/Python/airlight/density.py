# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The density image of any data set, as airlight.density_image()."""

from .vtkAirlight import vtkAirlightDensityImage


def density_image(dataset, array="", dimensions=(0, 0, 0), component=None, factor=1.0,
                  pass_arrays=False):
    """A vtkImageData for vtkParticipatingMedium.SetDensityImage(), of any data set.

        smoke = airlight.density_image(simulation, "soot", (128, 128, 64), factor=8700)
        medium.SetDensityImage(smoke)
        medium.SetDensityToImage()

    Parameters
    ----------
    dataset : vtkDataObject
        A vtkDataSet or a composite one (multi-block, AMR).
    array : str, default: ""
        The array of densities, of points or cells. Empty: the active scalars.
    dimensions : (int, int, int), default: (0, 0, 0)
        Points along each axis. (0, 0, 0): those of an image as they are, 64 x 64 x 64 of other
        data.
    component : int or str, optional
        Of an array that has several, by number or name.
    factor : float, default: 1
        Densities are multiplied by it.
    pass_arrays : bool, default: False
        Whether the data's other arrays are sampled, too, such as colours for
        vtkParticipatingMedium.SetAlbedoArrayName().

    Raises ValueError if there is no such array or component, or values are negative, NaN or
    infinite.
    """
    source = vtkAirlightDensityImage()
    messages = []

    def keep(_caller, _event, text):
        messages.append(text)
    keep.CallDataType = "string0"  # VTK reads it
    source.AddObserver("ErrorEvent", keep)
    source.SetInputDataObject(dataset)
    source.SetArrayName(array)
    source.SetDimensions(dimensions)
    source.SetFactor(factor)
    source.SetPassArrays(pass_arrays)
    if isinstance(component, str):
        source.SetComponentName(component)
    elif component is not None:
        source.SetComponent(component)
    if not messages:
        source.Update()
    if messages:
        lines = [line for line in messages[0].splitlines() if "ERROR: In " not in line]
        raise ValueError(" ".join(lines).split("): ", 1)[-1].strip())
    return source.GetOutput()
