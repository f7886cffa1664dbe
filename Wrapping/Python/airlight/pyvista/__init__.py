# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Airlight in PyVista: ``plotter.airlight`` and ``mesh.airlight``.

    import pyvista as pv
    pl = pv.Plotter()
    pl.add_mesh(pv.Sphere())
    pl.airlight.enable()
    pl.show()

PyVista finds the component and the accessors by the entry points of the package: nothing has to be
imported. If Airlight is on the path but not installed by pip, ``import airlight.pyvista`` registers
them. Documentation/pyvista.md is the manual.
"""

from .requirements import require_pyvista

require_pyvista()

from .component import AirlightComponent  # noqa: E402 PyVista is checked first
from .dataset_accessor import DataSetAirlight  # noqa: E402
from .polydata_accessor import PolyDataAirlight  # noqa: E402

__all__ = ["AirlightComponent", "DataSetAirlight", "PolyDataAirlight"]
