# SPDX-FileCopyrightText: Copyright (c) Airlight developers
# SPDX-License-Identifier: BSD-3-Clause
"""The built documentation site: links, pictures and pages, and how Chromium shows it.

AIRLIGHT_SITE is the folder of the site (default: build/site/html). Utilities/site.sh --test runs
this file after a build. Tests with a browser need Chromium and chromedriver, and are skipped
without.
"""

import functools
import http.server
import os
import pathlib
import re
import shutil
import sys
import threading
import urllib.parse

import pytest
from PIL import Image

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "Documentation" / "site"))
import links  # noqa: E402

SITE = pathlib.Path(os.environ.get("AIRLIGHT_SITE", ROOT / "build" / "site" / "html")).resolve()
CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
DRIVER = shutil.which("chromedriver")
SIZES = {"desk": (1280, 900), "phone": (390, 844)}

if not (SITE / "index.html").exists():
    pytest.skip("there is no site; Utilities/site.sh builds one", allow_module_level=True)


PAGES = [path.relative_to(SITE).as_posix() for path in links.Site(SITE).pages]

# Files

@pytest.fixture(scope="module")
def site():
    return links.Site(SITE)


def test_links(site):
    count, wrong, _ = site.problems()
    assert not wrong
    assert count > 1000


def test_checker_finds_faults(tmp_path):
    """The checker of links sees each kind of fault."""
    (tmp_path / "a.html").write_text(
        '<p id="here"><a href="#here">1</a><a href="b.html#there">2</a><a href="#gone">3</a>'
        '<a href="c.html">4</a><a href="../x.html">5</a><img src="p.png">6'
        '<a href="https://example.invalid/">7</a><a href="b.html#gone">8</a>'
        '<a href="/a.html">9</a>')
    (tmp_path / "b.html").write_text('<h1 id="there">b</h1><img src="a.html"/>')
    count, wrong, external = links.Site(tmp_path).problems()
    assert count == 9
    assert [text.split()[1].rstrip(":") for text in wrong] == [
        "#gone", "c.html", "../x.html", "p.png", "b.html#gone", "/a.html"]
    assert list(external) == ["https://example.invalid/"]


def test_pictures(site):
    """Each picture opens and is not of one colour."""
    seen = set()
    for page, content in site.pages.items():
        for link in content.pictures:
            file, _ = site.resolve(page, link)
            if file in seen or file is None or file.suffix == ".svg":
                continue
            seen.add(file)
            with Image.open(file) as picture:
                picture.load()
                if {"doxygen", "_static"} & set(file.parts):
                    continue  # ornaments
                assert min(picture.size) > 50, file
                colours = picture.convert("L").getextrema()
                assert colours[0] < colours[1], file
    assert len(seen) > 20


def test_index_is_complete():
    """The site has each page that the index of the documentation lists, and each that there is."""
    index = (ROOT / "Documentation" / "README.md").read_text(encoding="utf-8")
    listed = re.findall(r"\]\(([\w-]+)\.md\)", index)
    assert len(listed) > 5
    shown = (SITE / "documentation.html").read_text(encoding="utf-8")
    for name in listed:
        assert f"{name}.html" in PAGES
        assert f'href="{name}.html"' in shown
    for path in (ROOT / "Documentation").glob("*.md"):
        assert path.name == "README.md" or f"{path.stem}.html" in PAGES
    for name in ("index", "changelog", "contributing", "genindex", "search", "doxygen/index"):
        assert f"{name}.html" in PAGES


def test_gallery_is_complete():
    """A page for each example; those that draw have pictures that were drawn for the site."""
    drawn = 0
    for path in sorted((ROOT / "Examples").glob("*/*.py")):
        kind = path.parent.name.lower()
        if path.parent.name == "Data":
            continue
        page = f"examples/{kind}/{path.stem}.html"
        assert page in PAGES
        text = (SITE / page).read_text(encoding="utf-8")
        article = text.split("<article", 1)[1].split("</article>", 1)[0]
        run = "made without running" not in article
        writes = rf"""["']-o["']|{path.stem}\.py \[?FOLDER"""
        if run and re.search(writes, path.read_text(encoding="utf-8")):
            assert "<img" in article, page
            drawn += 1
    assert drawn >= 6


def test_python_classes():
    """A page for each public class with its methods, and links to the C++ page and back."""
    headers = [path for folder in ("Module", "Filters", "Rendering")
               for path in (ROOT / folder).glob("vtk*.h")]
    assert len(headers) > 15
    found = 0
    for header in headers:
        page = f"python/{header.stem}.html"
        if page not in PAGES:
            assert header.stem == "vtkOpenVDBDensityReader"  # not in every wheel
            continue
        text = (SITE / page).read_text(encoding="utf-8")
        assert f'id="airlight.{header.stem}"' in text
        assert f"doxygen/class{header.stem}.html" in text
        found += 1
    assert found > 15
    text = (SITE / "python/vtkParticipatingMedium.html").read_text(encoding="utf-8")
    assert 'id="airlight.vtkParticipatingMedium.SetVisibility"' in text
    assert "meteorological" in text


# The browser

@pytest.fixture(scope="module")
def address():
    """The site, served on this machine."""
    class Quiet(http.server.SimpleHTTPRequestHandler):
        def log_message(self, *_):
            pass

    server = http.server.ThreadingHTTPServer(
        ("127.0.0.1", 0), functools.partial(Quiet, directory=str(SITE)))
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    yield f"http://127.0.0.1:{server.server_address[1]}/"
    server.shutdown()
    server.server_close()


@pytest.fixture(scope="module", params=SIZES)
def browser(request):
    if not CHROMIUM or not DRIVER:
        pytest.skip("Chromium or chromedriver is missing (Debian: chromium, chromium-driver)")
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
    width, height = SIZES[request.param]
    options = webdriver.ChromeOptions()
    options.binary_location = CHROMIUM
    for word in ("--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
                 "--disable-dev-shm-usage"):
        options.add_argument(word)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    driver = webdriver.Chrome(options=options, service=Service(DRIVER))
    # A window cannot be as narrow as a phone: the page's width is set instead.
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
        "width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 600})
    driver.width = width
    yield driver
    driver.quit()


LOOK = """
const done = arguments[0];
const wait = [...document.images].map(i => {
  i.loading = "eager";
  return i.decode().catch(() => null);
});
Promise.all(wait).then(() => done({
  broken: [...document.images].filter(i => !i.naturalWidth).map(i => i.src),
  page: document.documentElement.scrollWidth,
  width: document.documentElement.clientWidth,
  height: document.documentElement.scrollHeight,
  text: document.body.innerText.length,
  cut: [...document.querySelectorAll("article p code, article li code")].filter(
    code => !code.closest("pre, table") &&
      code.getBoundingClientRect().right > document.documentElement.clientWidth
  ).map(code => code.innerText),
}));
"""


def test_pages_in_browser(browser, address):
    """No page has an error on the console or a broken picture, or scrolls sideways."""
    wrong = []
    for name in PAGES:
        if name.startswith("doxygen/search/"):
            continue  # frames of the search box
        browser.get(address + urllib.parse.quote(name))
        found = browser.execute_async_script(LOOK)
        # Doxygen's pages have no icon; the browser looks for one by itself.
        wrong += [f"{name}: {entry['message']}" for entry in browser.get_log("browser")
                  if entry["level"] == "SEVERE" and "/favicon.ico" not in entry["message"]]
        if found["broken"]:
            wrong.append(f"{name}: broken pictures: {found['broken']}")
        if found["page"] > max(found["width"], browser.width):
            wrong.append(f"{name}: {found['page']} pixels wide in a window of {browser.width}")
        if found["cut"]:
            wrong.append(f"{name}: cut off: {found['cut']}")
        if found["text"] < 20:
            wrong.append(f"{name}: is empty")
    assert not wrong, "\n".join(wrong)


def test_search(browser, address):
    """The site's search finds a class."""
    from selenium.webdriver.common.by import By
    from selenium.webdriver.support.ui import WebDriverWait
    browser.get(address + "search.html?q=vtkLitIntervalsFilter")
    WebDriverWait(browser, 20).until(
        lambda driver: driver.find_elements(By.CSS_SELECTOR, "#search-results li a"))
