"""Play-offs for places that decide which team advances."""

from rcj_challenges.tournament.season import FixtureKind, Outcome
from tests.tournament.seasons import by_strength, names, order, play, season, stage, teams_of

STAGES = "  league: {stage: round_robin, play_off: true}\n  final: {stage: round_robin, from: league, places: 1-%s}\n"
POINTS = "tie_breaks: [points]\n"


def level(fixture):
    """All matches are drawn, but those of a play-off."""
    return by_strength(fixture) if "play_off" in fixture.id else Outcome((1.0, 1.0))


def test_two_level_teams_play_a_tie_for_the_place_that_leads_on():
    def outcome(fixture):
        if teams_of(fixture) in (("t02", "t03"), ("t03", "t02")) and "play_off" not in fixture.id:
            return Outcome((1.0, 1.0))
        return by_strength(fixture)

    # t02 and t03 share place 2 behind t01, and two teams lead on.
    league = stage(play(season(STAGES % 2, names(4), POINTS), outcome), "league")
    more = [fixture for fixture in league.fixtures if "play_off" in fixture.id]
    assert [(one.id, one.round) for one in more] == [("league/play_off2/leg1/t02-t03", 4)]
    assert [(row.team, row.place, row.shared) for row in league.places[1:3]] == [("t02", 2, False), ("t03", 3, False)]
    assert league.expected_matches == len(league.fixtures) == 7


def test_three_level_teams_play_each_other():
    state = play(season(STAGES % 2, names(3), POINTS), level)
    league = stage(state, "league")
    assert len([fixture for fixture in league.fixtures if "play_off" in fixture.id]) == 3
    assert [(row.team, row.place) for row in league.places] == [("t01", 1), ("t02", 2), ("t03", 3)]
    assert stage(state, "final").teams == ("t01", "t02")


def test_next_stage_waits_for_the_play_off():
    one = season(STAGES % 2, names(3), POINTS)
    outcomes = {fixture.id: level(fixture) for fixture in one.state({}).open_fixtures()}
    state = one.state(outcomes)
    assert stage(state, "league").status == "running"
    assert stage(state, "final").status == "waiting"
    assert stage(state, "league").places == ()


def test_a_place_that_decides_nothing_stays_shared():
    league = stage(play(season(STAGES % 3, names(3), POINTS), level), "league")
    assert [row.place for row in league.places] == [1, 1, 1]
    assert all(row.shared for row in league.places)


def test_a_drawn_play_off_ends_with_what_decides_ties():
    def outcome(fixture):
        return Outcome((1.0, 1.0)) if fixture.kind is FixtureKind.MATCH else by_strength(fixture)

    stages = "  league: {stage: round_robin, play_off: true}\n  final: {stage: challenge, from: league, places: 1, scenarios: {a: {scenario: shooter}}}\n"
    state = play(season(stages, names(2), POINTS + "drawn: {extra_time: {match.half_s: 60}}\n"), outcome)
    kinds = [fixture.kind.value for fixture in stage(state, "league").fixtures]
    assert kinds == ["match", "match", "extra_time"]
    assert order(stage(state, "league").places) == ["t01", "t02"]


def test_a_tie_for_a_place_that_ends_by_lot_marks_both_teams():
    stages = "  league: {stage: round_robin, play_off: true}\n  final: {stage: challenge, from: league, places: 1, scenarios: {a: {scenario: shooter}}}\n"
    league = stage(play(season(stages, names(2), POINTS), lambda _: Outcome((1.0, 1.0))), "league")
    assert [(row.place, row.by_lot) for row in league.places] == [(1, True), (2, True)]


def test_level_teams_of_a_play_off_of_three_draw_lots_that_are_marked():
    league = stage(play(season(STAGES % 2, names(3), POINTS), lambda _: Outcome((0.0, 0.0))), "league")
    assert [(row.place, row.by_lot) for row in league.places] == [(1, True), (2, True), (3, True)]
