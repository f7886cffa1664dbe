# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""A series of density images, as Documentation/density.md plays it: steps of a pipeline with times,
in the functions on rays and in the pass."""

import math
import unittest

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as Pipeline
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow
import vtkmodules.vtkRenderingOpenGL2  # pylint: disable=unused-import # noqa

import airlight

SIZE = 5  # points a side, 1 apart
TIMES = (0.0, 0.4, 2.0, 3.6)


class Puff(VTKPythonAlgorithmBase):
    """A cube whose density is 1 + the time of the step, and which moves along x."""

    def __init__(self):
        super().__init__(nInputPorts=0, outputType="vtkImageData")

    def RequestInformation(self, request, inputs, outputs):  # VTK's name
        info = outputs.GetInformationObject(0)
        info.Set(Pipeline.WHOLE_EXTENT(), 0, SIZE - 1, 0, SIZE - 1, 0, SIZE - 1)
        info.Set(Pipeline.TIME_STEPS(), TIMES, len(TIMES))
        info.Set(Pipeline.TIME_RANGE(), (TIMES[0], TIMES[-1]), 2)
        return 1

    def RequestData(self, request, inputs, outputs):
        info = outputs.GetInformationObject(0)
        time = info.Get(Pipeline.UPDATE_TIME_STEP())
        image = vtkImageData.GetData(info)
        image.SetDimensions(SIZE, SIZE, SIZE)
        image.SetOrigin(time, 0, 0)
        values = numpy_to_vtk(np.full(SIZE ** 3, 1 + time), deep=True)
        values.SetName("soot")
        image.GetPointData().SetScalars(values)
        return 1


def make_smoke(puff):
    density = airlight.vtkAirlightDensityImage()
    density.SetInputConnection(puff.GetOutputPort())
    density.Update()
    smoke = airlight.vtkParticipatingMedium()
    smoke.SetScattering(0, 0, 0)
    smoke.SetAbsorption(0.1, 0.1, 0.1)
    smoke.SetDensityImage(density.GetOutput())
    return density, smoke


class TestDensitySeries(unittest.TestCase):
    ORDER = (0.0, 2.0, 0.4, 3.6, 0.0)  # and back

    def check(self, transmittance, time):
        self.assertAlmostEqual(transmittance, math.exp(-0.1 * (1 + time) * (SIZE - 1)), delta=1e-6)

    def test_rays(self):
        puff = Puff()  # VTK does not hold it
        density, smoke = make_smoke(puff)
        for time in self.ORDER:
            density.UpdateTimeStep(time)
            for place, dense in ((time + 2, time), (time - 1, -1), (time + SIZE, -1)):
                transmittance = [0, 0, 0]
                airlight.vtkAirlight.Transmittance(
                    smoke, (place, 2, -5), (place, 2, 10), transmittance)
                self.check(transmittance[0], dense)

    def test_pass(self):
        puff = Puff()  # VTK does not hold it
        density, smoke = make_smoke(puff)
        render_pass = airlight.vtkAirlightPass()
        render_pass.AddMedium(smoke)
        render_pass.RecordBuffersOn()
        renderer = vtkRenderer()
        renderer.SetPass(render_pass)
        window = vtkRenderWindow()
        window.SetSize(90, 30)
        window.AddRenderer(renderer)
        camera = renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetParallelScale(3)  # 5 pixels a unit
        camera.SetPosition(3, 2, 20)
        camera.SetFocalPoint(3, 2, 0)
        camera.SetClippingRange(1, 40)
        for time in self.ORDER:
            density.UpdateTimeStep(time)
            window.Render()
            values = render_pass.GetBuffer("Transmittance").GetPointData().GetScalars()
            row = vtk_to_numpy(values)[:, 0].reshape(30, 90)[15]
            places = 3 + (np.arange(90) + 0.5 - 45) / 5
            inside = (places > time) & (places < time + SIZE - 1)
            self.assertEqual(inside.sum(), 5 * (SIZE - 1))
            self.check(row[inside].min(), time)
            self.check(row[inside].max(), time)
            self.assertEqual(row[~inside].min(), 1)


if __name__ == "__main__":
    unittest.main(argv=[__file__])
