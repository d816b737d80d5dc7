"""Renders pages: Jinja2 with escaping everywhere, texts that can be translated, times with their zone."""

from __future__ import annotations

from datetime import datetime
from typing import Any

from django.http import HttpRequest, HttpResponse
from django.middleware.csrf import get_token
from django.shortcuts import render
from django.urls import reverse
from django.utils import timezone, translation
from django.utils.functional import SimpleLazyObject
from django.utils.translation import gettext
from jinja2 import Environment, StrictUndefined

from rcj_challenges.core.amounts import plain
from rcj_challenges.core.sanitize import sanitize, sanitize_block
from rcj_challenges.core.timing import s_from_ticks
from rcj_challenges.views.sentences import clock
from rcj_challenges.web.accounts import Viewer, viewer_of
from rcj_challenges.web.config import current_site

_LOCAL = frozenset({"localhost", "127.0.0.1"})


def environment(**options: Any) -> Environment:
    """Return Jinja's environment."""
    options |= {"autoescape": True, "trim_blocks": True, "lstrip_blocks": True, "undefined": StrictUndefined}
    made = Environment(extensions=["jinja2.ext.i18n"], **options)  # noqa: S701 - it is on
    made.install_gettext_callables(translation.gettext, translation.ngettext, newstyle=True)  # type: ignore[attr-defined]
    made.filters.update(
        time=format_time, shown=sanitize, block=sanitize_block, bytes=_format_bytes, score=plain, clock=_format_ticks
    )
    made.globals |= {"url": reverse, "site_title": current_site().title}
    return made


def format_time(at: datetime | None) -> str:
    """Format a time in the site's zone, with the zone."""
    return "" if at is None else timezone.localtime(at).strftime("%Y-%m-%d %H:%M:%S %Z")


def _format_ticks(ticks: int) -> str:
    return clock(s_from_ticks(ticks))


def _format_bytes(size: int) -> str:
    return f"{size / 1_000_000:.1f} MB" if size >= 100_000 else f"{size / 1000:.1f} kB"


def public_address(request: HttpRequest, path: str) -> tuple[str, bool]:
    """Return an address of this site, and whether other computers reach it.

    Where the site is looked at on its own computer, it is that of another name in ``hosts``.
    """
    name, _, port = request.get_host().partition(":")
    if name not in _LOCAL:
        return request.build_absolute_uri(path), True
    others = [host for host in current_site().hosts if host not in _LOCAL and host[0] not in ".*["]
    if not others:
        return request.build_absolute_uri(path), False
    return f"{request.scheme}://{others[0]}{':' * bool(port)}{port}{path}", True


def page(
    request: HttpRequest, template: str, viewer: Viewer | None = None, status: int = 200, **values: Any
) -> HttpResponse:
    """Render a page for a viewer."""
    seen_by = viewer_of(request) if viewer is None else viewer
    shared = {
        "viewer": seen_by,
        # Where it is not used no cookie is set, so a page for all is the same for all.
        "token": SimpleLazyObject(lambda: get_token(request)),
        "path": request.path,
        "LANG": translation.get_language(),
    }
    return render(request, template, shared | values, status=status)


def message_page(request: HttpRequest, status: int, text: str, title: str = "") -> HttpResponse:
    """Render a page with a message, by itself that something was not done."""
    return page(request, "message.html", status=status, title=title or gettext("Not done"), text=text)
