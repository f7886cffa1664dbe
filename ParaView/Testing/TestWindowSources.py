# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Sources of the view's medium, chosen in ParaView's window."""

import re

import numpy as np

import windowtest as window


def choose(name, source):
    return (f"{window.VIEW}/{name}/1QComboBox0", "activated", source)


class WindowSources(window.TestCase):
    def test_surface(self):
        """A region of a source by two lists, taken back and made again, without any message. It is
        not drawn here: a processor takes minutes for a window of this size."""
        played, views = self.play(
            window.load_plugin() + window.make_view() + window.make_source("CubeSource")
            + [("", "grab", "all"), window.set_view("Region", "Surface"), ("", "grab", "none"),
               window.set_view("Airlight", False), choose("RegionSurface", "Box1"),
               ("", "grab", "surface"), window.UNDO, ("", "grab", "undone"), window.REDO,
               ("", "grab", "redone"), window.CHECK_MESSAGES], timeout=280)
        self.assertEqual(played.status, 0, played.text)
        self.assertNotIn("ERR|", played.text)
        self.assertGreater(np.abs(views["none"] - views["all"]).mean(), 5, "without the medium")
        chosen = {name: len(re.findall(r'<Property name="RegionSurface"[^>]*>\s*<Proxy value', state))
                  for name, state in played.states.items()}
        self.assertEqual(
            chosen, {"all": 0, "none": 0, "surface": 1, "undone": 0, "redone": 1}, played.text)


if __name__ == "__main__":
    window.main()
