# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Data as volumes, which ParaView draws by volumes within volumes: in the medium, casting shadows,
and as media themselves."""

import sys
import unittest

import numpy as np
from paraview import simple

import paraviewtest as test

OPACITY = 0.5  # per unit of length


def show_volume(view, colour):
    """A cube of the side 2, evenly filled."""
    source = simple.Wavelet(WholeExtent=[-1, 1, -1, 1, -1, 1])
    display = simple.Show(source, view)
    display.SetRepresentationType("Volume")
    simple.ColorBy(display, ("POINTS", "RTData"))
    colours = simple.GetColorTransferFunction("RTData")
    colours.RGBPoints = [0, *colour, 500, *colour]
    opacity = simple.GetOpacityTransferFunction("RTData")
    opacity.Points = [0, OPACITY, 0.5, 0, 500, OPACITY, 0.5, 0]
    display.ScalarOpacityUnitDistance = 1
    return display


class Volumes(test.ClearViewTestCase):
    NAME = "volume"

    def setUp(self):
        super().setUp()
        self.view.UseFXAA = 0

    def test_in_the_medium(self):
        """Dimmed by the medium before it."""
        show_volume(self.view, (0.9, 0.9, 0.9))
        clear = self.picture("clear")
        self.view.Absorption = [0.5] * 3
        self.view.Region = "Box"
        self.view.RegionBounds = [-3, 3, -3, 3, 1.5, 2.5]
        depth = 0.5 * test.lengths_in_box((-3, -3, 1.5), (3, 3, 2.5))
        fog = self.picture("fog")
        self.assertGreater(clear.max(), 0.5)
        self.assertLess(np.abs(fog - clear * np.exp(-depth)).max(), 2.5 / 255)

    def test_shadow(self):
        """On a floor below it."""
        show_volume(self.view, (0.5, 0.5, 0.5))
        floor = simple.Plane(Origin=[-3, -1.3, 3], Point1=[3, -1.3, 3], Point2=[-3, -1.3, -3])
        test.show(self.view, floor)
        test.add_lamp(self.view, position=(0, 3, 0))
        lit = self.picture("lit")
        self.view.VolumeShadows = 1
        shaded = self.picture("shaded")
        darker = (lit - shaded) / np.maximum(lit, 0.01)
        below = np.s_[int(0.82 * test.SIZE[1]):, int(0.35 * test.SIZE[0]):int(0.65 * test.SIZE[0])]
        self.assertGreater(darker[below].max(), 0.5)
        self.assertLess(np.abs(lit - shaded)[:int(0.3 * test.SIZE[1])].max(), 2 / 255)

    def test_scatters(self):
        """A medium of the same opacity, in place of what ray casting makes of it, and back."""
        self.view.Background = [1, 1, 1]
        show_volume(self.view, (0, 0, 0))
        cast = self.picture("cast")
        self.view.VolumesScatter = 1
        medium = self.picture("medium")
        depth = -np.log(1 - OPACITY) * test.lengths_in_box((-1, -1, -1), (1, 1, 1))
        slope = np.abs(np.gradient(depth)).sum(axis=0)
        self.assertLess((np.abs(medium - np.exp(-depth)) - slope).max(), 1.5 / 255)
        self.assertLess(np.abs(medium - cast)[slope < 0.02].max(), 0.03)
        self.view.VolumesScatter = 0
        self.assertLess(np.abs(self.picture("again") - cast).max(), 1.5 / 255)

    def test_anisotropy(self):
        """As the same data as a medium with the phase function of Henyey and Greenstein."""
        display = show_volume(self.view, (1, 1, 1))
        test.add_lamp(self.view, position=(0.3, 0.5, -3.0), intensity=8)
        self.view.VolumesScatter = 1
        evenly = self.picture("evenly")
        self.view.VolumesAnisotropy = 0.7
        forward = self.picture("forward")
        self.view.VolumesScatter = 0
        display.Visibility = 0
        ones = simple.Calculator(Input=simple.Wavelet(WholeExtent=[-1, 1, -1, 1, -1, 1]),
                                 ResultArrayName="ones", Function="1")
        medium = simple.Show(ones, self.view)
        medium.Representation = "Medium"
        medium.MediumDensityArray = ["POINTS", "ones"]
        medium.MediumThickness = "Coefficients"
        medium.MediumScattering = [-np.log(1 - OPACITY)] * 3
        medium.MediumPhaseFunction = "Henyey-Greenstein"
        medium.MediumAnisotropy = 0.7
        expected = self.picture("forward-medium")
        print(f"anisotropy: {np.abs(forward - expected).max()} from the medium's, "
              f"{np.abs(forward - evenly).max()} from even scattering")
        self.assertLess(np.abs(forward - expected).max(), 2.5 / 255)
        self.assertGreater((forward - evenly).max(), 0.1)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
