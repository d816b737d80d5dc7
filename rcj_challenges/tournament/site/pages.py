"""The pages about the whole season, its stages and its teams."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import groupby
from typing import Any

from markupsafe import Markup

from rcj_challenges.core.amounts import measure_words
from rcj_challenges.core.files import slug
from rcj_challenges.core.grouping import grouped
from rcj_challenges.tournament.season import StageState, Status
from rcj_challenges.tournament.seeds import seed_hash
from rcj_challenges.tournament.site.bracket import bracket_svg
from rcj_challenges.tournament.site.designs import publish_cards
from rcj_challenges.tournament.site.model import MatchView, Season
from rcj_challenges.tournament.site.plots import distribution_plot, form_plot
from rcj_challenges.tournament.site.podium import podiums, publish_certificates
from rcj_challenges.tournament.site.render import Renderer, day
from rcj_challenges.tournament.site.schedule import Heading, appointments, as_csv, as_feed, as_ics
from rcj_challenges.tournament.site.tree import Tree

_ON_OVERVIEW = 8

Cells = dict[tuple[str, str], list[tuple[MatchView, str, str]]]


def publish_overview(tree: Tree, renderer: Renderer, season: Season) -> None:
    """Write the pages about the whole season."""
    stages = season.state.stages
    running = [stage for stage in stages if stage.status == Status.RUNNING]
    current = running or [stage for stage in stages if stage.status == Status.FINISHED][-1:]
    drawn = (stage for stage in stages if stage.ties and stage.status != Status.WAITING)
    renderer.write(
        tree,
        "index.html",
        current=[stage for stage in current if any(match.outcome for match in season.of_stage(stage))],
        brackets=[(stage, _bracket(season, stage, "")) for stage in drawn],
        podiums=podiums(season),
        latest=_few(season.latest),
        coming=_few(season.coming),
    )
    rows = appointments(season)
    zone = season.source.time_zone
    days = [(name, list(some)) for name, some in groupby(rows, key=lambda row: day(row.at, zone))]
    renderer.write(tree, "schedule.html", days=days)
    source = season.source
    heading = Heading(source.id, source.title, source.time_zone, source.now, source.url)
    tree.write("schedule.ics", as_ics(heading, rows))
    tree.write("schedule.csv", "\ufeff" + as_csv(season, rows))  # spreadsheets recognize UTF-8 by this mark
    tree.write("feed.json", as_feed(season))
    teams, cells = _met(season.released)
    renderer.write(tree, "head_to_head.html", teams=_in_order(season, teams), cells=cells)
    renderer.write(
        tree,
        "about.html",
        seed_hash=seed_hash(season.source.seed),
        ruled=[match for match in season.latest if match.played and match.played.rulings],
        withdrawals=season.source.played.withdrawals,
        doubtful=any(match.played and match.played.doubtful for match in season.released),
        versions=_versions(season),
    )


def _few(matches: Sequence[MatchView]) -> Sequence[MatchView]:
    """Return the first of some matches; runs of challenges, of which there are many, only if there is nothing else."""
    return ([match for match in matches if not match.is_challenge] or matches)[:_ON_OVERVIEW]


def _versions(season: Season) -> list[str]:
    found = (match.played.result.get("versions") for match in season.released if match.played)
    text = "rcj-challenges {rcj_challenges}, MuJoCo {mujoco}, {python}, {system} {machine}"
    return sorted({text.format(**versions) for versions in found if versions})


# --- stages ----------------------------------------------------------------------------------------------------------


def publish_stage(tree: Tree, renderer: Renderer, season: Season, stage: StageState) -> None:
    """Write the page of a stage, and its bracket as a picture and to print."""
    name = slug(stage.name)
    matches = season.of_stage(stage)
    renderer.write(
        tree,
        f"stages/{name}.html",
        "stage.html",
        stage=stage,
        matches=matches,
        times=sorted({time.at for time in season.source.rounds if time.stage == stage.name and not time.round}),
        picture=_bracket(season, stage, "../") if stage.ties else None,
        plots=_distributions(season, stage) if stage.is_solo else [],
        rounds=_rounds(stage, matches) if not stage.is_solo else [],
        challenges=_challenges(season, stage) if stage.is_solo else [],
        matrices=_matrices(season, stage),
    )
    if stage.status is Status.FINISHED:
        publish_certificates(tree, renderer, season, stage)
    if stage.ties:
        picture = _bracket(season, stage, "../")
        renderer.write(tree, f"brackets/{name}.html", "bracket.html", stage=stage, picture=picture)
        tree.write(f"brackets/{name}.svg", _bracket(season, stage, None))


def _bracket(season: Season, stage: StageState, root: str | None) -> Markup:
    """Return the bracket of a stage; ``root`` is the way to the site's top, None for a picture without links."""
    linked = [match for match in season.of_stage(stage) if match.outcome and root is not None]
    links = {match.fixture.id: f"{root}matches/{match.slug}/index.html" for match in linked}
    return bracket_svg(stage.ties, lambda teams: season.label(teams.split("+")), stage.title, links, alone=root is None)


def _rounds(stage: StageState, matches: Sequence[MatchView]) -> list[tuple[str, list[MatchView]]]:
    rounds = {tie.id: tie.round_title for tie in stage.ties}
    numbered = ((match.fixture.round, rounds.get(match.fixture.tie), match) for match in matches)
    by_round = grouped(((number, name or f"Round {number}"), match) for number, name, match in numbered)
    return [(name, some) for (_, name), some in sorted(by_round.items(), key=lambda item: item[0][0])]


def _challenges(
    season: Season, stage: StageState
) -> list[tuple[str, list[str], list[int], dict[tuple[str, int], MatchView]]]:
    """Return for each challenge its name, the teams as its table has them, the numbers of its runs, and the runs."""
    ranked = {table.name: [row.team for row in table.rows] for table in stage.tables}
    found: dict[str, dict[tuple[str, int], MatchView]] = {}
    for match in season.of_stage(stage):
        found.setdefault(match.fixture.group, {})[match.teams[0], match.fixture.leg] = match
    return [
        (name, ranked.get(name) or sorted({team for team, _ in runs}), sorted({run for _, run in runs}), runs)
        for name, runs in found.items()
    ]


def _distributions(season: Season, stage: StageState) -> list[tuple[str, Markup]]:
    """Return a picture for each challenge that several runs were played of: all values of its first criterion."""
    played = [match for match in season.of_stage(stage) if match.outcome is not None]
    found = []
    for table in stage.tables:
        runs = [(one.teams[0], _first_value(one)) for one in played if one.fixture.group == table.name]
        values = grouped((team, value) for team, value in runs if value is not None)
        if values:
            shown = {season.name(row.team): values[row.team] for row in table.rows if row.team in values}
            found.append((table.name, distribution_plot(shown, measure_words(table.columns[0]))))
    return found


def _first_value(match: MatchView) -> float | None:
    return next(iter((match.outcome.values or match.outcome.scores) if match.outcome else ()), 0.0)


def _matrices(season: Season, stage: StageState) -> list[tuple[str, list[str], Cells]]:
    """Return the matches between each two teams, group by group; nothing for other stages than these two."""
    matches = season.of_stage(stage) if stage.has_matrices else ()
    groups = grouped((match.fixture.group, match) for match in matches if match.outcome)
    tables = (table for table in stage.tables if table.name in groups)
    return [(table.name, [row.team for row in table.rows], _met(groups[table.name])[1]) for table in tables]


def _met(matches: Iterable[MatchView]) -> tuple[set[str], Cells]:
    """Return the teams of matches of two single teams, and for each ordered pair (match, score, won, drawn or lost)."""
    cells: Cells = {}
    for match in matches:
        sides = match.fixture.sides
        if len(sides) != 2 or match.outcome is None or any(len(side.teams) != 1 for side in sides):
            continue
        first, second = sides[0].teams[0], sides[1].teams[0]
        text = match.scores
        cells.setdefault((first, second), []).append((match, ":".join(text), match.result_for(first)))
        cells.setdefault((second, first), []).append((match, ":".join(reversed(text)), match.result_for(second)))
    return {team for pair in cells for team in pair}, cells


def _in_order(season: Season, teams: Iterable[str]) -> list[str]:
    return sorted(teams, key=lambda team: (season.name(team).casefold(), team))


# --- teams -----------------------------------------------------------------------------------------------------------


def publish_teams(tree: Tree, renderer: Renderer, season: Season) -> None:
    """Write the page of each team, and the list of all."""
    listed = []
    for team in _in_order(season, season.teams):
        matches = season.of_team(team)
        went = [match.result_for(team) for match in matches]
        listed.append((team, went.count("won"), went.count("drawn"), went.count("lost")))
        cards = publish_cards(tree, season, team)
        renderer.write(tree, f"teams/{slug(team)}.html", "team.html", cards=cards, **_team(season, team, matches))
    renderer.write(tree, "teams/index.html", "teams.html", teams=listed)


def _team(season: Season, team: str, matches: Sequence[MatchView]) -> dict[str, Any]:
    form = []
    for match in (match for match in matches if match.result_for(team)):
        others = ", ".join(season.label(side.teams) for side in match.fixture.sides if team not in side.teams)
        form.append((f"against {others}", match.difference_for(team)))
    places = [
        (stage, table, row)
        for stage in season.state.stages
        for table in stage.tables
        for row in table.rows
        if table.has_begun and team in row.team.split("+")
    ]
    results = []
    for stage in season.state.stages:
        own = [match for match in matches if match.stage.name == stage.name]
        runs = grouped((match.fixture.group, match) for match in own if match.is_challenge)
        results.append((stage.title, [match for match in own if not match.is_challenge], runs))
    return {
        "id": team,
        "form": form_plot(form) if form else None,
        "places": places,
        "withdrawals": season.source.played.withdrawals.get(team, ()),
        "faults": season.faults_of(team),
        "submissions": [one for one in season.source.played.submissions if one.team == team],
        "results": results,
    }
