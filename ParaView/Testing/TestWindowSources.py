# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Sources as media, chosen in ParaView's window: of the view's medium, and data as media."""

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
        undone = 0 if window.UNDOES else 1
        expected = {"all": 0, "none": 0, "surface": 1, "undone": undone, "redone": 1}
        self.assertEqual(chosen, expected, played.text)

    def test_medium(self):
        """Data as a medium by the list of representations, taken back and made again."""
        played, views = self.play(
            window.load_plugin() + window.make_view() + window.make_source("RTAnalyticSource")
            + [("", "grab", "outline"),
               (window.REPRESENTATION, "activated", "Medium"), ("", "grab", "medium"),
               window.UNDO, ("", "grab", "undone"), window.REDO, ("", "grab", "redone"),
               window.CHECK_MESSAGES], timeout=280)
        self.assertEqual(played.status, 0, played.text)
        self.assertNotIn("ERR|", played.text)
        for name in ("undone", "redone"):
            same = views["outline" if name == "undone" and window.UNDOES else "medium"]
            self.assertLess(np.abs(views[name] - same).max(), 2, name)
        darker = views["outline"].mean(axis=2) - views["medium"].mean(axis=2)
        rows, columns = darker.shape
        middle = darker[3 * rows // 8:5 * rows // 8, 3 * columns // 8:5 * columns // 8]
        self.assertGreater(middle.mean(), 10, "the medium is seen")
        self.assertLess(np.abs(darker[:, :columns // 8]).mean(), 3, "and nowhere else")


if __name__ == "__main__":
    window.main()
