# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The version of PyVista that the component and the accessors need."""

from __future__ import annotations

import re

MINIMUM = (0, 48)
REMEDY = "install it with: pip install 'pyvista>=0.48'"


def _parse(version: str) -> tuple[int, ...]:
    return tuple(int(part) for part in re.findall(r"\d+", version)[:2])


def require_pyvista():
    """Import PyVista, which has to be new enough.

    Returns
    -------
    module
        The module ``pyvista``.

    Raises
    ------
    ImportError
        If PyVista is missing, or older than 0.48, the first version with components of plotters
        and accessors of data sets. The message names the version found and the remedy.
    """
    try:
        import pyvista
    except ImportError as error:
        raise ImportError(f"airlight.pyvista needs PyVista 0.48 or newer, and importing it failed "
                          f"({error}): {REMEDY}") from error
    version = getattr(pyvista, "__version__", "0")
    if _parse(version) < MINIMUM:
        raise ImportError(f"airlight.pyvista needs PyVista 0.48 or newer, and this is PyVista "
                          f"{version}, which has no components of plotters: {REMEDY}. With this "
                          f"version, use renderer.SetPass(airlight.vtkAirlightPass()).")
    return pyvista
