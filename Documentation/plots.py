# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Draws the plots of the user guide: python3 plots.py [FOLDER]

Writes guide-*.png into the folder (default: pictures beside this file). The numbers are those of
the package `airlight` itself; needs a display, or xvfb-run.
"""

import math
import pathlib
import sys

from vtkmodules.vtkChartsCore import vtkAxis, vtkChart, vtkChartLegend, vtkChartXY
from vtkmodules.vtkCommonCore import vtkFloatArray
from vtkmodules.vtkCommonDataModel import vtkTable
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter
import vtkmodules.vtkRenderingContextOpenGL2  # noqa: F401 draws charts
import vtkmodules.vtkRenderingFreeType  # noqa: F401 draws their texts
from vtkmodules.vtkViewsContext2D import vtkContextView

import airlight

SIZE = 640, 400
COLOURS = ((31, 119, 180), (214, 95, 20), (44, 140, 60), (150, 60, 160), (90, 90, 90))


def fog(extinction, kind="Isotropic", anisotropy=None):
    """A medium that only scatters, of this extinction per unit length."""
    medium = airlight.vtkParticipatingMedium()
    medium.SetScattering(extinction, extinction, extinction)
    getattr(medium, "SetPhaseFunctionTo" + kind)()
    if anisotropy is not None:
        medium.SetAnisotropy(anisotropy)
    return medium


def steps(first, last, count=200):
    """Numbers at equal distances."""
    return [first + (last - first) * i / (count - 1) for i in range(count)]


def transmittance(medium, distance):
    """The share of light that passes."""
    rgb = [0.0, 0.0, 0.0]
    airlight.vtkAirlight.Transmittance(medium, (0, 0, 0), (0, 0, distance), rgb)
    return rgb[1]


def scattered(medium, lamp, length):
    """Airlight of a lamp of 1 W/sr, seen from the origin along the z-axis."""
    rgb = [0.0, 0.0, 0.0]
    airlight.vtkAirlight.Inscatter(medium, lamp, (1, 1, 1), (0, 0, 0), (0, 0, 1), 0, length, rgb)
    return rgb[1]


def transmittance_plot():
    """How far one sees: the share of light that passes, by distance."""
    x = steps(0, 200)
    curves = {"2 %": [0.02] * len(x)}
    for visibility in (150, 50, 15):
        medium = airlight.vtkParticipatingMedium()
        medium.SetVisibility(visibility)
        curves[f"visibility {visibility} m"] = [transmittance(medium, d) for d in x]
    return x, curves, "distance, m", "transmittance", ("TOP", "RIGHT")


def airlight_plot():
    """What a ray gathers on its way past a lamp, 10 m ahead and 2 m beside it."""
    x = steps(0.01, 40)
    curves = {f"{extinction} per m": [1e4 * scattered(fog(extinction), (2, 0, 10), t) for t in x]
              for extinction in (0.3, 0.1, 0.03)}
    return x, curves, "length of the ray, m", "airlight, 1e-4 W/(m^2 sr)", ("TOP", "LEFT")


def density_plot():
    """The same lamp in fog of every density: no fog glows, nor does the densest."""
    exponents = steps(-3, 0)
    medium = {"isotropic": ("Isotropic", None), "g = 0.8": ("HenyeyGreenstein", 0.8)}
    curves = {f"{name}, lamp {place}": [
        math.log10(scattered(fog(10 ** e, *phase), (2, 0, z), math.inf)) for e in exponents]
        for name, phase in medium.items() for place, z in (("ahead", 10), ("behind", -10))}
    return (exponents, curves, "log10 of the extinction, per m",
            "log10 of the airlight, W/(m^2 sr)", ("BOTTOM", "LEFT"))


def phase_plot():
    """Where scattered light goes."""
    x = steps(0, 180)
    functions = {"isotropic": fog(1), "Rayleigh": fog(1, "Rayleigh"),
                 "Henyey-Greenstein 0.6": fog(1, "HenyeyGreenstein", 0.6),
                 "Henyey-Greenstein 0.85": fog(1, "HenyeyGreenstein", 0.85),
                 "Mie murky": fog(1, "MieMurky")}
    curves = {name: [math.log10(medium.EvaluatePhaseFunction(math.cos(math.radians(d))))
                     for d in x] for name, medium in functions.items()}
    return (x, curves, "scattering angle, degrees", "log10 of the phase function, 1/sr",
            ("TOP", "RIGHT"))


def column(name, values):
    """A column of a table."""
    array = vtkFloatArray()
    array.SetName(name)
    for value in values:
        array.InsertNextValue(value)
    return array


def draw(file, x, curves, x_title, y_title, corner):
    """One chart of some curves over the same x."""
    table = vtkTable()
    table.AddColumn(column(x_title, x))
    for name, values in curves.items():
        table.AddColumn(column(name, values))
    chart = vtkChartXY()
    chart.SetShowLegend(True)
    chart.GetLegend().SetHorizontalAlignment(getattr(vtkChartLegend, corner[1]))
    chart.GetLegend().SetVerticalAlignment(getattr(vtkChartLegend, corner[0]))
    for index in range(len(curves)):
        plot = chart.AddPlot(vtkChart.LINE)
        plot.SetInputData(table, 0, index + 1)
        plot.SetColor(*COLOURS[index], 255)
        plot.SetWidth(2.5)
    for axis, title in ((vtkAxis.BOTTOM, x_title), (vtkAxis.LEFT, y_title)):
        chart.GetAxis(axis).SetTitle(title)
        chart.GetAxis(axis).GetTitleProperties().SetFontSize(14)
        chart.GetAxis(axis).GetLabelProperties().SetFontSize(13)
    view = vtkContextView()
    view.GetRenderer().SetBackground(1, 1, 1)
    view.GetRenderWindow().SetOffScreenRendering(1)
    view.GetRenderWindow().SetMultiSamples(0)
    view.GetRenderWindow().SetSize(*SIZE)
    view.GetScene().AddItem(chart)
    view.GetRenderWindow().Render()
    picture = vtkWindowToImageFilter()
    picture.SetInput(view.GetRenderWindow())
    picture.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(str(file))
    writer.SetInputConnection(picture.GetOutputPort())
    writer.Write()


PLOTS = {"transmittance": transmittance_plot, "airlight": airlight_plot,
         "density": density_plot, "phase": phase_plot}


def main():
    """Writes all plots."""
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else
                          pathlib.Path(__file__).resolve().parent / "pictures")
    folder.mkdir(parents=True, exist_ok=True)
    for name, plot in PLOTS.items():
        draw(folder / f"guide-{name}.png", *plot())


if __name__ == "__main__":
    main()
