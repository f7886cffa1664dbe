# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""ParaView's window as a user opens it: the plugin loaded by its dialog, the view made from the list of
views, data shown, and not one message."""

import numpy as np

import windowtest as window


class Window(window.TestCase):
    def test_first_view(self):
        """A message of any kind would be in the output window's text."""
        played, views = self.play(
            window.load_plugin() + [window.CHECK_MESSAGES] + window.make_view()
            + window.make_source("RTAnalyticSource") + window.make_filter("Contour")
            + [("", "grab", "first"), window.CHECK_MESSAGES])
        self.assertEqual(played.status, 0, played.text)
        for word in ("ERR|", "WARN|", "No proxy that matches", "critical"):
            self.assertNotIn(word, played.text)
        self.assertEqual(set(views), {"first"}, played.text)
        # The view is on the screen as in its screenshot.
        screen, view = played.grabs["first"].astype(float), views["first"][..., :3]
        self.assertGreater(view.std(), 15)
        self.assertLess(view.shape[0] * view.shape[1], screen.shape[0] * screen.shape[1])
        self.assertLess(self.find(screen, view), 3)

    @staticmethod
    def find(screen, view):
        """The mean difference of the screen's best place for a picture; its middle is compared."""
        rows, columns = view.shape[:2]
        middle = view[rows // 4:3 * rows // 4:9, columns // 4:3 * columns // 4:9]
        best = 255.0
        for y in range(screen.shape[0] - rows + 1):
            for x in range(screen.shape[1] - columns + 1):
                part = screen[y + rows // 4:y + 3 * rows // 4:9,
                              x + columns // 4:x + 3 * columns // 4:9]
                best = min(best, np.abs(part - middle).mean())
        return best

    def test_messages_are_seen(self):
        """The check of the output window fails if there is something in it."""
        played, _ = self.play(window.load_plugin() + [
            ("", "activate", "no such thing")] + [window.CHECK_MESSAGES])
        self.assertNotEqual(played.status, 0)


if __name__ == "__main__":
    window.main()
