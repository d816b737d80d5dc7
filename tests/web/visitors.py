"""People who look at a site with a browser."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tests.views.browser_stage import NO_WEBGL

if TYPE_CHECKING:
    from playwright.sync_api import Browser, BrowserContext, Page

PHONE, WIDE = {"width": 360, "height": 740}, {"width": 1280, "height": 740}


class Visitor:
    """Somebody with cookies of their own, whose every complaint is kept."""

    def __init__(self, browser: Browser, address: str, **options: Any) -> None:
        self.context: BrowserContext = browser.new_context(base_url=address, **options)
        self.context.add_init_script(NO_WEBGL)
        self.page: Page = self.context.new_page()
        self.complaints: list[str] = []
        self.page.on("pageerror", lambda error: self.complaints.append(str(error)))
        self.page.on("dialog", lambda dialog: self.complaints.append(f"dialog {dialog.message}"))
        self.page.on("console", lambda said: self.complaints.append(said.text) if said.type == "error" else None)
        self.page.on("request", lambda one: None if one.url.startswith(address) else self.complaints.append(one.url))

    def look(self) -> Page:
        """Return the page that is open; it must not be wider than the screen."""
        self.page.wait_for_load_state("domcontentloaded")
        assert self.page.evaluate("document.documentElement.scrollWidth - innerWidth") <= 0, self.page.url
        return self.page


class Visitors:
    """Visitors of a site: the tab of one that has left is used by the next, because to open one takes a second.

    Args:
        browser: that all use.
        address: of the site.
    """

    def __init__(self, browser: Browser, address: str) -> None:
        self._browser, self._address = browser, address
        self._here: list[Visitor] = []
        self._left: list[Visitor] = []

    def come(self, viewport: dict[str, int] = WIDE, color_scheme: Any = "light") -> Visitor:
        """Return a visitor who is not signed in."""
        visitor = self._left.pop() if self._left else Visitor(self._browser, self._address)
        self._here.append(visitor)
        visitor.page.set_viewport_size(viewport)  # type: ignore[arg-type]  # the same, in other types
        visitor.page.emulate_media(media="screen", color_scheme=color_scheme)
        return visitor

    def leave(self) -> list[str]:
        """Send all away; return their complaints."""
        complaints = []
        for visitor in self._here:
            visitor.page.goto("about:blank")
            visitor.context.clear_cookies()
            complaints += [one for one in visitor.complaints if one != "about:blank"]
            visitor.complaints.clear()
        self._left += self._here
        self._here = []
        return complaints

    def close(self) -> None:
        """Close all tabs."""
        for visitor in self._here + self._left:
            visitor.context.close()
