# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Lamps in ParaView's window: that of the view, by its check box, and a light that is dragged."""

import numpy as np

import windowtest as window


class WindowLamp(window.TestCase):
    def test_lamp(self):
        """The view's lamp by its check box, taken back and made again; a light of the inspector."""
        played, views = self.play(
            window.load_plugin() + window.make_view() + window.make_source("SphereSource")
            + [("", "grab", "plain"), window.set_view("Lamp", True), ("", "grab", "lamp"),
               window.UNDO, ("", "grab", "undone"), window.REDO, ("", "grab", "redone"),
               window.set_view("Lamp", False),
               ("menubar/menu_View", "activate", "Light Inspector"),
               (f"{window.INSPECTOR}/addLight", "activate", ""), ("", "grab", "light"),
               *window.drag((0.5, 0.5), (0.3, 0.3)), ("", "grab", "dragged"),
               window.CHECK_MESSAGES], timeout=280)
        self.assertEqual(played.status, 0, played.text)
        self.assertNotIn("ERR|", played.text)
        self.assertEqual(len(views), 6, played.text)
        self.assertGreater(np.abs(views["lamp"] - views["plain"]).mean(), 5)
        if window.UNDOES:
            np.testing.assert_array_equal(views["undone"], views["plain"])
        np.testing.assert_array_equal(views["redone"], views["lamp"])
        self.assertEqual(window.read_numbers(played.states["light"], "LightPosition"), [0, 0, 1])
        dragged = window.read_numbers(played.states["dragged"], "LightPosition")
        self.assertGreater(abs(dragged[0]), 0.1)
        self.assertGreater(np.abs(views["dragged"] - views["light"]).mean(), 3)


if __name__ == "__main__":
    window.main()
