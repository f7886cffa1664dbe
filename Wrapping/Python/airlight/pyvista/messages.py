# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""VTK's errors as exceptions."""

from __future__ import annotations

from typing import Any


class Messages:
    """Collects what VTK objects report as errors, for an exception in their place.

    Parameters
    ----------
    *objects : vtkObject
        The objects to listen to, as long as the ``with`` block lasts.

    Examples
    --------
    >>> import airlight
    >>> from airlight.pyvista.messages import Messages
    >>> medium = airlight.vtkParticipatingMedium()
    >>> with Messages(medium) as messages:
    ...     medium.SetVisibility(-1)
    >>> "Visibility -1" in messages.text
    True
    """

    def __init__(self, *objects: Any) -> None:
        self._objects = objects
        self._tags: list[int] = []
        self._found: list[str] = []

    def __enter__(self) -> Messages:
        found = self._found

        def keep(_caller, _event, text):
            found.append(text)
        keep.CallDataType = "string0"  # type: ignore[attr-defined] VTK reads it
        self._tags = [each.AddObserver("ErrorEvent", keep) for each in self._objects]
        return self

    def __exit__(self, *_exception) -> None:
        for each, tag in zip(self._objects, self._tags):
            each.RemoveObserver(tag)

    @property
    def text(self) -> str:
        """What was reported, a message a line, without VTK's file names; empty if nothing was."""
        return "\n".join(self._strip(message) for message in self._found)

    @staticmethod
    def _strip(message: str) -> str:
        lines = [line for line in message.strip().splitlines() if line.strip()]
        if lines and lines[0].startswith("ERROR: In "):
            lines = lines[1:]
        if lines and lines[0].startswith("vtk") and "): " in lines[0]:
            lines[0] = lines[0].split("): ", 1)[1]
        return " ".join(lines)

    def raise_if_any(self, error: type[Exception] = RuntimeError) -> None:
        """Raise what was reported, if anything was."""
        if self._found:
            raise error(self.text)
