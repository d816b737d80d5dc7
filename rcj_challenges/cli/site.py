"""``rcj-challenge site``: a web site on which teams hand in and are checked by playing."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rcj_challenges.cli.app import ORGANIZE, App, app
from rcj_challenges.core.codes import CANNOT_OPEN
from rcj_challenges.core.errors import RcjError, format_error
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.web.codes import BAD_RESULTS, SITE_EXTRA, SITE_PROBLEMS

if TYPE_CHECKING:
    from rcj_challenges.web.config import SiteConfig

site_app = App(
    "site",
    "Host a web site on which teams hand in and are checked by playing.",
    "rcj-challenge site init club",
    "rcj-challenge site serve club",
)
app.add_typer(site_app, name="site", rich_help_panel=ORGANIZE)

_DEMO_TEAMS = 4
_TIMEOUT_S = 60

Folder = Annotated[Path, typer.Argument(metavar="FOLDER", help="The folder of the site.")]
Trust = Annotated[
    bool, typer.Option("--trust-all-teams", help="Run programs also where they cannot be isolated strictly.")
]


def _ensure_extra() -> None:
    if find_spec("django") is None:
        help_ = 'pip install "rcj-challenges[web]"'
        raise RcjError("a site needs the extra [web], which is not installed", help_, code=SITE_EXTRA)


def opened(folder: Path, *, trust_all_teams: bool = False) -> SiteConfig:
    """Return the settings of a site, with Django set up.

    Raises:
        RcjError: the extra is not installed, or the folder has no site.
    """
    _ensure_extra()
    from rcj_challenges.web.config import load_site, set_up

    config = load_site(folder, trust_all_teams=trust_all_teams)
    set_up(config)
    return config


@site_app.register(ORGANIZE, "rcj-challenge site init club")
def init(
    folder: Folder,
    title: Annotated[str, typer.Option("--title", metavar="TEXT", help="What the pages are called.")] = "Soccer club",
    demo: Annotated[bool, typer.Option("--demo", help="With four sample teams that have handed in.")] = False,
) -> None:
    """Make the folder of a new site."""
    _ensure_extra()
    from rcj_challenges.web.config import make_site, set_up
    from rcj_challenges.web.serving import migrate

    config = make_site(folder, title)
    set_up(config)
    migrate(config)
    if demo:
        from rcj_challenges.web.demo import make_demo, match_samples

        for line in make_demo(dict(list(match_samples().items())[:_DEMO_TEAMS])):
            typer.echo(line)
    typer.echo(f"made {folder}; start it with: rcj-challenge site serve {folder}")


@site_app.register(ORGANIZE, "rcj-challenge site serve club --host 0.0.0.0 --port 8000")
def serve(
    folder: Folder,
    host: Annotated[str, typer.Option("--host", metavar="ADDRESS", help="The address to listen at.")] = "127.0.0.1",
    port: Annotated[int, typer.Option("--port", metavar="N", min=0, max=65535, help="The port; 0: a free one.")] = 8000,
    dispatch: Annotated[
        bool, typer.Option("--dispatch/--no-dispatch", help="Whether checks also run on this computer.")
    ] = True,
    trust_all_teams: Trust = False,
) -> None:
    """Serve the site, and check what teams hand in."""
    config = opened(folder, trust_all_teams=trust_all_teams)
    from rcj_challenges.web import serving

    if dispatch:
        serving.ensure_isolation(config)
    serving.migrate(config)

    def on_start(address: str) -> None:
        typer.echo(f"{config.title}: {address}")
        link = serving.first_link(address)
        if link is not None:
            typer.echo(f"first organizer (this link works once): {link}")

    serving.serve(config, host, port, dispatch=dispatch, on_start=on_start)


@site_app.register(ORGANIZE, "rcj-challenge site worker club")
def worker(folder: Folder, trust_all_teams: Trust = False) -> None:
    """Run a dispatcher: it checks what teams hand in."""
    config = opened(folder, trust_all_teams=trust_all_teams)
    from rcj_challenges.web.serving import work

    work(config)


@site_app.register(ORGANIZE, "rcj-challenge site invite club")
def invite(
    folder: Folder,
    address: Annotated[
        str, typer.Option("--address", metavar="ADDRESS", help="Under which browsers reach the site.")
    ] = "http://localhost:8000",
) -> None:
    """Print a link with which an organizer makes an account, once."""
    opened(folder)
    from rcj_challenges.web.serving import organizer_link

    typer.echo(organizer_link(address.rstrip("/")))


@site_app.register(ORGANIZE, "rcj-challenge site migrate club")
def migrate(folder: Folder) -> None:
    """Bring the database up to date, after an update of this program."""
    config = opened(folder)
    from rcj_challenges.web.serving import migrate as bring_up_to_date

    done = bring_up_to_date(config)
    typer.echo("\n".join(done) if done else "the database is up to date")


@site_app.register(ORGANIZE, "rcj-challenge site backup club backups/monday")
def backup(
    folder: Folder,
    target: Annotated[Path, typer.Argument(metavar="TARGET", help="A new folder, which is a site like this one.")],
) -> None:
    """Copy a site while it runs."""
    config = opened(folder)
    from rcj_challenges.web.backup import back_up

    try:
        back_up(config, target)
    except OSError as error:
        raise RcjError(f"{sanitize(target)}: {format_error(error)}", "choose another disk", code=CANNOT_OPEN) from error
    typer.echo(f"made {target}; check it with: rcj-challenge site doctor {target}")


@site_app.register(ORGANIZE, "rcj-challenge site doctor backups/monday")
def doctor(folder: Folder) -> None:
    """Look for what is missing or damaged in the data of a site.

    Exit status: 0: all is well; 2: it is not.
    """
    config = opened(folder)
    from rcj_challenges.web.backup import problems

    found = list(problems(config))
    for problem in found:
        typer.echo(problem)
    if found:
        raise RcjError(f"{len(found)} problems", "docs/site.md says what to do", code=SITE_PROBLEMS)
    typer.echo("all is well")


@site_app.register(ORGANIZE, "rcj-challenge site rate http://club.lan:8000/api/v1/seasons/1/results --check")
def rate(
    results: Annotated[str, typer.Argument(metavar="FILE|ADDRESS", help="The results that a site publishes.")],
    check: Annotated[bool, typer.Option("--check", help="Only compare the table and the seeds with them.")] = False,
) -> None:
    """Compute the table of a ladder from its published results.

    Exit status: 0: as published; 2: the published table or seeds are not those that follow from the results.
    """
    from rcj_challenges.web.ladder.published import Results, ensure_consistent, fit_of, table_of

    try:
        published = Results.model_validate_json(_read(results))
        table = table_of(published, fit_of(published))
    except ValueError as error:
        message = f"{sanitize(results)}: these are no results of a season"
        raise RcjError(message, "give the address that the page of the ladder links to", code=BAD_RESULTS) from error
    if not check:
        for row in table:
            place = "placing" if row.rank is None else f"{row.rank} ({row.low}-{row.high})"
            typer.echo(f"{place:>14}  {row.value:5} ±{1.96 * row.sd:<4.0f} {row.games:5}  {row.digest[:16]}")
    ensure_consistent(published, table)
    if check:
        typer.echo(f"as published: {len(table)} programs, {len(published.matches)} matches")


def _read(results: str) -> bytes:
    try:
        if results.startswith(("http://", "https://")):
            from urllib.request import urlopen

            with urlopen(results, timeout=_TIMEOUT_S) as answer:  # noqa: S310 - of these two kinds
                return bytes(answer.read())
        return Path(results).read_bytes()
    except OSError as error:
        message = f"{sanitize(results)}: {format_error(error)}"
        raise RcjError(message, "give a file or an address with http or https", code=CANNOT_OPEN) from error
