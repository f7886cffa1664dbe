# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""Examples/trame/fog.py in a headless Chromium: what its controls do to the picture.

Each picture of the browser is compared with one that this process renders of the same scene with
the same values: the browser has to show exactly what the pass draws.
"""

import io
import os
import pathlib
import signal
import socket
import subprocess
import sys
import time

import numpy as np
import pytest

from conftest import EXAMPLES, load_example, need_packages, need_program

need_packages("trame", "trame_vtk", "trame_vuetify", "playwright", "PIL")

from PIL import Image  # noqa: E402
from playwright.sync_api import sync_playwright  # noqa: E402
from vtkmodules.util.numpy_support import vtk_to_numpy  # noqa: E402
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter  # noqa: E402

import airlight  # noqa: E402

EXAMPLE = EXAMPLES / "trame" / "fog.py"
PATIENCE = 90  # s, for a picture on a busy machine
SAME = 2.5  # of 255, the mean difference that JPEG and scaling may make


class Reference:
    """The scene of the example, rendered here."""

    def __init__(self):
        self.example = load_example(EXAMPLE)
        self.hall = self.example.FoggyHall()
        self.hall.fog_pass.RecordBuffersOn()
        self.window = self.hall.make_window()
        self.values = dict(self.example.START)

    def draw(self, size, **changes):
        """The picture with the values so far, of which some change; top row first, 0 to 255."""
        self.values.update(changes)
        self.hall.update(**self.values)
        self.window.SetSize(size)
        self.window.Render()
        shot = vtkWindowToImageFilter()
        shot.SetInput(self.window)
        shot.ReadFrontBufferOff()
        shot.Update()
        scalars = vtk_to_numpy(shot.GetOutput().GetPointData().GetScalars())
        return scalars.reshape(size[1], size[0], 3)[::-1].astype(float)


    def surface_share(self):
        """The part of the picture's light that comes from surfaces; the rest is airlight."""
        total = {name: vtk_to_numpy(self.hall.fog_pass.GetBuffer(name).GetPointData().GetScalars())
                 .sum() for name in ("Airlight", "Radiance")}
        return 1 - total["Airlight"] / total["Radiance"]


class Browser:
    """A page with the application."""

    def __init__(self, page, port):
        self.page = page
        self.problems = []
        page.on("console", lambda message: self.problems.append(message.text)
                if message.type in ("error", "warning") else None)
        page.on("pageerror", lambda error: self.problems.append(str(error)))
        # With a sessionURL, trame's page does not look for a launcher of servers first.
        page.goto(f"http://127.0.0.1:{port}/?sessionURL=ws://127.0.0.1:{port}/ws")
        self.image = page.locator(".v-main img").first
        self.image.wait_for(timeout=1000 * PATIENCE)

    @property
    def size(self):
        box = self.image.bounding_box()
        return round(box["width"]), round(box["height"])

    def picture(self):
        data = self.image.screenshot()
        return np.asarray(Image.open(io.BytesIO(data)).convert("RGB"), dtype=float)

    def wait_for(self, expected, name):
        """The picture, as soon as it is the expected one."""
        end = time.monotonic() + PATIENCE
        while True:
            picture = self.picture()
            same_size = picture.shape == expected.shape
            difference = np.abs(picture - expected).mean() if same_size else np.inf
            if difference < SAME or time.monotonic() > end:
                break
            time.sleep(0.2)
        if "AIRLIGHT_KEEP" in os.environ:  # a folder for the pictures, to look at them
            folder = pathlib.Path(os.environ["AIRLIGHT_KEEP"])
            self.page.screenshot(path=folder / f"trame-{name}.png")
        assert difference < SAME, f"{name}: {picture.shape} {expected.shape} {difference}"
        return picture

    def click_slider(self, index, share):
        """Clicks on the track of a slider, at a share of its length; the slider's value then."""
        box = self.page.locator(".v-slider-track").nth(index).bounding_box()
        self.page.mouse.click(box["x"] + share * box["width"], box["y"] + box["height"] / 2)
        return self.slider(index)

    def slider(self, index):
        return float(self.page.get_by_role("slider").nth(index).get_attribute("aria-valuenow"))

    def choose(self, title):
        self.page.locator(".v-select").click()
        self.page.get_by_role("option", name=title).click()


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def wait_for_server(server, port):
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end and server.poll() is None:
        with socket.socket() as probe:
            if probe.connect_ex(("127.0.0.1", port)) == 0:
                return
        time.sleep(0.1)
    server.kill()
    pytest.fail(f"the application does not listen: {server.communicate()[0]}")


@pytest.fixture(name="application")
def fixture_application():
    """The running server; what it prints, and how it ends, is checked afterwards."""
    port = free_port()
    command = [sys.executable, EXAMPLE, "--server", "--port", str(port)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True) as server:
        try:
            wait_for_server(server, port)
            yield port
            assert server.poll() is None, "the server ended by itself"
            server.send_signal(signal.SIGINT)
            output, _ = server.communicate(timeout=30)
        finally:
            server.kill()
    assert server.returncode == 0, output
    for word in ("Traceback", "ERR|", "WARN|", "rror:", "arning:"):
        assert word not in output, output


@pytest.fixture(name="browser")
def fixture_browser(application):
    program = need_program("chromium", "chromium", "chromium-browser", "google-chrome")
    with sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=program, args=["--no-sandbox"])
        browser = Browser(chromium.new_page(viewport={"width": 1000, "height": 600}), application)
        yield browser
        chromium.close()


def contrast(picture):
    """How much neighbouring pixels differ, as a share of the brightness."""
    return np.abs(np.diff(picture, axis=1)).mean() / picture.mean()


def brightest_row(picture):
    grey = picture[:-4].sum(axis=2)  # not the border of the page below
    return np.argwhere(grey > 0.97 * grey.max())[:, 0].mean()


def test_controls(browser):
    reference = Reference()
    size = browser.size
    assert min(size) > 400  # the view fills the page beside the controls

    start = browser.wait_for(reference.draw(size), "start")
    assert start.std() > 20 and 40 < start.mean() < 200  # neither uniform, black nor white
    assert np.mean(start.min(axis=2) > 250) < 0.05

    # Thicker fog by a click on the slider: more airlight, less contrast.
    share = reference.surface_share()
    visibility = browser.click_slider(0, 0.08)
    assert 5 < visibility < 15
    thick = browser.wait_for(reference.draw(size, visibility=visibility), "thick")
    assert 0 < reference.surface_share() < 0.5 * share
    assert contrast(thick) < 0.8 * contrast(start)

    # Clearer air by a key.
    browser.page.get_by_role("slider").nth(0).press("End")
    assert browser.slider(0) == 80
    clear = browser.wait_for(reference.draw(size, visibility=80), "clear")
    assert reference.surface_share() > 1.5 * share
    assert contrast(clear) > 1.2 * contrast(start)

    # A brighter lamp, and a dark one.
    intensity = browser.click_slider(1, 0.9)
    assert 100 < intensity < 120
    bright = browser.wait_for(reference.draw(size, intensity=intensity), "bright")
    assert bright.mean() > 1.15 * clear.mean()
    browser.page.get_by_role("slider").nth(1).press("Home")
    assert browser.slider(1) == 10
    dark = browser.wait_for(reference.draw(size, intensity=10), "dark")
    assert dark.mean() < 0.6 * clear.mean()

    # A lower lamp: the brightest place moves down.
    intensity = browser.click_slider(1, 0.5)
    high = browser.wait_for(reference.draw(size, intensity=intensity), "high")
    height = browser.click_slider(2, 0.2)
    assert 1.2 < height < 1.6
    low = browser.wait_for(reference.draw(size, height=height), "low")
    assert brightest_row(low) > brightest_row(high) + 0.05 * size[1]

    # Without shadows the hall is brighter; the map and the planes have about the same shadows.
    browser.choose("None")
    bare = browser.wait_for(
        reference.draw(size, technique=int(airlight.vtkAirlightPass.NONE)), "no-shadows")
    assert bare.mean() > 1.05 * low.mean()
    browser.choose("Shadow map")
    shadow_map = browser.wait_for(
        reference.draw(size, technique=int(airlight.vtkAirlightPass.SHADOW_MAP)), "shadow-map")
    assert np.abs(shadow_map - low).mean() < 0.3 * np.abs(bare - low).mean()

    # The mouse turns the camera, the button turns it back.
    box = browser.image.bounding_box()
    x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
    browser.page.mouse.move(x, y)
    browser.page.mouse.down()
    browser.page.mouse.move(x + 60, y, steps=5)
    browser.page.mouse.up()
    end = time.monotonic() + PATIENCE
    while np.abs(browser.picture() - shadow_map).mean() < 2 * SAME:
        assert time.monotonic() < end, "dragging did not turn the view"
        time.sleep(0.2)
    browser.page.get_by_role("button", name="Reset view").click()
    browser.wait_for(reference.draw(size), "reset")

    assert browser.problems == []


def test_drag(browser):
    """Many values in a row, faster than frames: the last one is drawn."""
    reference = Reference()
    size = browser.size
    browser.wait_for(reference.draw(size), "drag-start")
    thumb = browser.page.get_by_role("slider").nth(0).bounding_box()
    x, y = thumb["x"] + thumb["width"] / 2, thumb["y"] + thumb["height"] / 2
    browser.page.mouse.move(x, y)
    browser.page.mouse.down()
    for step in range(60):
        browser.page.mouse.move(x + step, y)
    browser.page.mouse.up()
    visibility = browser.slider(0)
    assert visibility > 35
    browser.wait_for(reference.draw(size, visibility=visibility), "drag-end")
    assert browser.problems == []


def test_reference_differs():
    """The comparison can fail: values next to each other on a slider give other pictures."""
    reference = Reference()
    size = (700, 500)
    start = reference.draw(size)
    for changes in ({"visibility": 12}, {"intensity": 90}, {"height": 1.4},
                    {"technique": int(airlight.vtkAirlightPass.NONE)}):
        other = reference.draw(size, **{**reference.example.START, **changes})
        assert np.abs(other - start).mean() > 2 * SAME, changes
