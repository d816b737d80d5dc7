"""A browser for tests of pages: one for all of them, its tabs used again, and no complaint of a page overlooked."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from playwright.sync_api import Browser, ConsoleMessage, Page, Request

WIDE, NARROW = {"width": 1366, "height": 768}, {"width": 390, "height": 844}

COARSE = 0.5
"""Pixels per CSS pixel, as few as the page itself takes where drawing is slow: no test looks at finer things."""

NO_WEBGL = """
  const real = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
    return kind === "webgl2" ? null : real.call(this, kind, ...rest);
  };"""
"""For ``script=``: a browser that cannot draw in three dimensions. That is twice as quick, for tests of other things."""

_NAMES = ("chromium", "chromium-browser", "google-chrome")
_SOFTWARE_GPU = [
    "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist",
    "--disable-gpu-rasterization", "--disable-gpu-compositing",
]  # fmt: skip
"""The software GPU draws the field only. Text and boxes are painted without it, in a quarter less processor time."""
_SAID_BY_THE_SOFTWARE_GPU = "GPU stall"
"""When a picture is read back: no complaint of the page."""


@contextmanager
def opened_browser() -> Iterator[Browser]:
    """Start the system's Chromium, or skip the tests that need it."""
    playwright = pytest.importorskip(
        "playwright.sync_api", reason="playwright is not installed: pages are not tried in a browser"
    )
    chromium = next((path for name in _NAMES if (path := shutil.which(name))), None)
    if chromium is None:
        pytest.skip("no chromium on this machine: pages are not tried in a browser")
    with playwright.sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path=chromium, args=_SOFTWARE_GPU)
        yield browser
        browser.close()


@dataclass
class _Tab:
    """A page of the browser, for one address after the other.

    Attributes:
        page: of a browser context of its own, so that tabs share nothing.
        kind: with what it was made and what stays with it.
        own: how addresses begin that the page may ask for.
        kept: the address that is loaded, if another test may look at the page as well.
        untouched: all that there is to see on a page that is kept, when it has not been touched.
    """

    page: Page
    kind: tuple[Any, ...]
    own: str = ""
    kept: str = ""
    untouched: str = ""


class Stage:
    """The tabs of a browser.

    To open a tab takes a process and a start of the software GPU, and to load a page is a second of processor time for
    shaders and first pictures. So a tab is emptied after a test and used by the next, and a replay that was put back to
    what it was when it was loaded is kept for the next test that wants just this one.

    Attributes:
        complaints: errors and warnings of the pages of this test, and addresses that they should not have asked for.
    """

    def __init__(self, browser: Browser) -> None:
        self._browser = browser
        self._taken: list[_Tab] = []
        self._free: list[_Tab] = []
        self.complaints: list[str] = []

    def open(
        self,
        address: str,
        *,
        ready: str = "body.ready",
        viewport: dict[str, int] = WIDE,
        color_scheme: str = "light",
        script: str = "",
        own: str = "",
        **screen: Any,
    ) -> Page:
        """Load a page in an empty tab.

        Args:
            address: of the page; it may ask for what is below, and for nothing else.
            ready: selector of what is there when the page can be used.
            viewport: width and height in CSS pixels.
            color_scheme: what the reader prefers, light or dark.
            script: runs before those of the page.
            own: how addresses begin that the page may ask for; left out: its own.
            screen: other properties of a browser context, as ``has_touch=True``.
        """
        tab = self._empty_tab(script, screen)
        tab.own = own or address.partition("#")[0]
        tab.page.set_viewport_size(viewport)
        tab.page.emulate_media(media="screen", color_scheme=color_scheme, reduced_motion="reduce")
        tab.page.goto(address)
        tab.page.wait_for_selector(ready)
        return tab.page

    def look_at(self, address: str, half: int, tick: int) -> Page:
        """Show a moment of a replay on a wide screen: of the page that the test before left, if it is the same."""
        tab = next((free for free in self._free if free.kept == address), None)
        if tab is not None:
            self._free.remove(tab)
            self._taken.append(tab)
        else:
            self.open(address)
            tab = self._taken[-1]
            tab.kept, tab.untouched = address, _put_back(tab.page)
        tab.page.evaluate("([half, tick]) => replay.seek(half, tick)", [half, tick])
        settled(tab.page)
        return tab.page

    def clear(self, *, close: bool = False) -> None:
        """Leave all pages; of what tests did to them nothing is there for the next.

        Args:
            close: the tabs as well: a test that failed may have left a key or a button of the mouse down.
        """
        taken, self._taken = self._taken, []
        for tab in taken:
            if close or tab.page.is_closed():
                tab.page.close()
                continue
            tab.page.mouse.move(0, 0)
            if tab.kept and _put_back(tab.page) == tab.untouched:
                for other in [free for free in self._free if free.kept]:
                    self._empty(other)
            else:
                self._empty(tab)
            self._free.append(tab)

    def _empty(self, tab: _Tab) -> None:
        tab.kept = ""
        tab.page.evaluate("sessionStorage.clear()")
        tab.page.goto("about:blank")

    def _empty_tab(self, script: str, screen: dict[str, Any]) -> _Tab:
        kind = (script, *sorted(screen.items()))
        tab = next((free for free in self._free if free.kind == kind and not free.kept), None)
        if tab is None:
            tab = self._new_tab(kind, script, screen)
        else:
            self._free.remove(tab)
        self._taken.append(tab)
        return tab

    def _new_tab(self, kind: tuple[Any, ...], script: str, screen: dict[str, Any]) -> _Tab:
        tab = _Tab(self._browser.new_page(**{"device_scale_factor": COARSE, **screen}), kind)
        if script:
            tab.page.add_init_script(script)

        def said(message: ConsoleMessage) -> None:
            if message.type in ("error", "warning") and _SAID_BY_THE_SOFTWARE_GPU not in message.text:
                self.complaints.append(message.text)

        def asked(request: Request) -> None:
            if not request.url.startswith((tab.own, "data:", "about:blank")):
                self.complaints.append(f"asked for {request.url}")

        tab.page.on("pageerror", lambda error: self.complaints.append(str(error)))
        tab.page.on("console", said)
        tab.page.on("request", asked)
        return tab


def _put_back(page: Page) -> str:
    """Put a replay back to its beginning as a reader would, and return all that there is to see then."""
    page.evaluate(
        """() => {
          const press = (what) => { for (const thing of document.querySelectorAll(what)) thing.click(); };
          const choose = (name, value) => {
            const select = document.getElementById(name);
            select.value = value;
            select.dispatchEvent(new Event("change"));
          };
          replay.seek(1, 0);
          document.activeElement.blur();
          press("#robots [aria-pressed=true], #show input:checked:not([checked]), #show input[checked]:not(:checked)");
          choose("speed", "1");
          choose("heat", "");
          choose("printed-by", "");
          if (document.body.classList.contains("no-panel")) press("#panel");
          press("#filters > :first-child, [data-camera=overview], #tab-events");
        }"""
    )
    settled(page)
    return page.evaluate(
        """() => {
          const { app } = replay, { recording, ...player } = app.player, { field, ...camera } = app.camera;
          const things = [...document.body.querySelectorAll("*")].filter((thing) => thing.checkVisibility());
          return JSON.stringify([
            location.hash, document.documentElement.dataset.theme, document.activeElement.tagName, player, camera,
            app.density, app.frame.trails.length, document.getElementById("app").innerText,
            things.map(({ tagName, value, checked, scrollTop, open, attributes }) =>
              [tagName, value, checked, scrollTop, open, [...attributes].map((one) => [one.name, one.value])]),
          ]);
        }"""
    )


def until(page: Page, condition: str, at_most_s: float = 20) -> None:
    """Wait until something is so. (The page's policy forbids what playwright's own waiting does: to evaluate text.)"""
    page.evaluate(
        f"""() => new Promise((done, fail) => {{
          const latest = performance.now() + {1000 * at_most_s};
          const look = () => {{
            if ({condition}) done();
            else if (performance.now() > latest) fail(new Error("it never came about"));
            else setTimeout(look, 20);
          }};
          look();
        }})"""
    )


def settled(page: Page) -> None:
    """Wait until nothing on the page moves by itself: the page draws only when something changes."""
    until(page, "!replay.app.waiting && !replay.app.camera.goal")


def shown_moment(page: Page) -> tuple[int, int]:
    """Return the half and the tick that a page shows."""
    return page.evaluate("[replay.half, replay.tick]")


def picture(page: Page) -> list[int]:
    """Draw, and return the colours of a grid of 400 points of the picture."""
    return page.evaluate(
        """() => {
          replay.app.draw();
          const gl = replay.app.view.painter.gl, width = gl.drawingBufferWidth, height = gl.drawingBufferHeight;
          const all = new Uint8Array(4 * width * height), picked = [];
          gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, all);
          for (let row = 0; row < 20; row++) for (let column = 0; column < 20; column++) {
            const first = 4 * (Math.floor((row + 0.5) * height / 20) * width + Math.floor((column + 0.5) * width / 20));
            picked.push((all[first] << 16) | (all[first + 1] << 8) | all[first + 2]);
          }
          return picked;
        }"""
    )
