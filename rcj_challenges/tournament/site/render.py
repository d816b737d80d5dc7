"""From templates to pages: Jinja2 with escaping on, links that work from disk, one policy for all pages."""

from __future__ import annotations

from datetime import datetime, tzinfo
from importlib.resources import files
from typing import Any
from urllib.parse import quote

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup
from rich.cells import cell_len, chop_cells

from rcj_challenges.core.amounts import measure_words, number_words
from rcj_challenges.core.files import slug
from rcj_challenges.core.sanitize import sanitize, sanitize_block
from rcj_challenges.tournament.season import humanized
from rcj_challenges.tournament.site.model import Season, group_title
from rcj_challenges.tournament.site.public import fault_moment, fault_words
from rcj_challenges.tournament.site.schedule import page_of
from rcj_challenges.tournament.site.tree import Tree
from rcj_challenges.views.sentences import clock

POLICY = (
    "default-src 'none'; style-src 'self'; img-src 'self' data:; base-uri 'none'; form-action 'none'; frame-src 'none'"
)
"""No script runs on a page, and nothing is loaded from anywhere else. Premieres have a policy of their own."""


class Renderer:
    """Fills the templates with a season."""

    def __init__(self, season: Season) -> None:
        self._environment = Environment(
            loader=PackageLoader("rcj_challenges.tournament.site"),
            autoescape=True,
            undefined=StrictUndefined,
            trim_blocks=True,
            lstrip_blocks=True,
        )
        zone = season.source.time_zone
        self._environment.filters |= {
            "block": sanitize_block,
            "clock": clock,
            "day": lambda at: day(at, zone),
            "fault": fault_words,
            "hour": lambda at: f"{at.astimezone(zone):%H:%M %Z}",
            "measure": measure_words,
            "moment": fault_moment,
            "number": number_words,
            "shown": sanitize,
            "slug": slug,
            "time": lambda at: time_element(at, zone),
            "url": quote,
            "words": humanized,
        }
        shared = {"season": season, "source": season.source, "page_of": page_of, "group_title": group_title}
        self._environment.globals |= shared

    @property
    def style(self) -> str:
        """The style sheet of all pages."""
        return (files("rcj_challenges.tournament.site") / "templates" / "style.css").read_text("utf-8")

    def write(self, tree: Tree, path: str, template: str = "", **context: Any) -> None:
        """Write a page with relative links; its template is that of the same name if none is given."""
        page = self._environment.get_template(template or path)
        tree.write(path, page.render(root="../" * path.count("/"), path=path, policy=POLICY, **context))


def day(at: datetime, zone: tzinfo) -> str:
    """Return ``Sat 26 June 2021``."""
    local = at.astimezone(zone)
    return f"{local:%a} {local.day} {local:%B %Y}"


def time_element(at: datetime, zone: tzinfo) -> Markup:
    """Return a time in the tournament's zone, which it names, as HTML that machines read."""
    local = at.astimezone(zone)
    text = f"{day(at, zone)}, {local:%H:%M} {local:%Z}"
    return Markup('<time datetime="{}">{}</time>').format(local.isoformat(timespec="minutes"), text)


def fitted(text: str, max_width: int) -> str:
    """Return a text that is cut to a width, about in characters; those of East Asia and emoji count twice."""
    return text if cell_len(text) <= max_width else f"{chop_cells(text, max_width - 1)[0]}…"
