"""Swiss stages: the pairing of teams, and the table that decides it."""

from collections import Counter
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.tournament.formats.swiss_pairing import Player, pair
from rcj_challenges.tournament.season import Outcome
from tests.tournament.seasons import by_chance, by_strength, names, order, play, season, stage, teams_of

SWISS = "  swiss: {{stage: swiss, rounds: {}}}\n"


@st.composite
def fields_of_teams(draw):
    """Draw a number of teams, a number of rounds that they allow, and a seed for the scores."""
    teams = draw(st.integers(2, 24))
    return teams, draw(st.integers(1, min(9, -(-teams // 2)))), draw(st.integers(0, 10**6))


@given(fields_of_teams())
def test_swiss_has_no_rematch_no_second_bye_and_even_sides(drawn):
    count, rounds, seed = drawn
    swiss = play(season(SWISS.format(rounds), names(count)), by_chance(seed)).stages[0]
    by_round = {number: [one for one in swiss.fixtures if one.round == number] for number in range(1, rounds + 1)}
    byes = dict(swiss.byes)
    for number, fixtures in by_round.items():
        present = [team for one in fixtures for team in teams_of(one)] + ([byes[number]] if number in byes else [])
        assert sorted(present) == names(count)
    met = [frozenset(teams_of(one)) for one in swiss.fixtures]
    assert len(met) == len(set(met)) == rounds * (count // 2) == swiss.expected_matches
    assert len(byes) == (rounds if count % 2 else 0)
    assert max(Counter(byes.values()).values(), default=0) <= 1
    assert max(map(abs, balances(swiss.fixtures).values())) <= 2


def balances(fixtures):
    found = Counter()
    for one in fixtures:
        first, second = teams_of(one)
        found[first] += 1
        found[second] -= 1
    return found


@pytest.mark.parametrize("count", [4, 7, 16, 33])
def test_largest_allowed_number_of_rounds_needs_no_rematch(count):
    rounds = -(-count // 2)
    swiss = play(season(SWISS.format(rounds), names(count)), by_strength).stages[0]
    met = [frozenset(teams_of(one)) for one in swiss.fixtures]
    assert len(met) == len(set(met)) == rounds * (count // 2)
    assert max(Counter(team for _, team in swiss.byes).values(), default=0) <= 1


def test_teams_with_equal_points_meet():
    swiss = play(season(SWISS.format(3), names(8)), by_strength).stages[0]
    points = Counter()
    for number in (1, 2, 3):
        for one in (fixture for fixture in swiss.fixtures if fixture.round == number):
            winner, loser = sorted(teams_of(one))
            assert points[winner] == points[loser]
        for one in (fixture for fixture in swiss.fixtures if fixture.round == number):
            points[min(teams_of(one))] += 3
    assert order(swiss.places)[0] == "t01"


def test_a_bye_counts_as_a_win_without_goals():
    swiss = play(season(SWISS.format(2), names(3)), by_strength).stages[0]
    for row in swiss.tables[0].rows:
        byes = sum(team == row.team for _, team in swiss.byes)
        assert (row.played, row.points) == (2 - byes, 3 * (row.won + byes))


def test_next_round_is_drawn_when_the_last_match_of_a_round_is_over():
    one = season(SWISS.format(2), names(6))
    outcomes = {fixture.id: by_strength(fixture) for fixture in one.state({}).open_fixtures()}
    *most, last = outcomes
    assert [fixture.id for fixture in one.state({key: outcomes[key] for key in most}).open_fixtures()] == [last]
    assert {fixture.round for fixture in one.state(outcomes).open_fixtures()} == {2}


def test_state_does_not_depend_on_the_order_of_outcomes_nor_on_states_before():
    one = season(SWISS.format(4), names(9))
    last = play(one, by_chance(3))
    backwards = dict(reversed(last.outcomes.items()))
    assert season(SWISS.format(4), names(9)).state(backwards) == one.state(last.outcomes) == last


def test_first_round_is_drawn_from_the_seed():
    def first(seed):
        one = season(SWISS.format(1), names(16))
        tournament = one.loaded.tournament.model_copy(update={"seed": seed})
        object.__setattr__(one.loaded, "tournament", tournament)
        return [teams_of(fixture) for fixture in type(one)(one.loaded).state({}).open_fixtures()]

    assert first(1) == first(1) != first(2)


def test_swiss_places_lead_into_a_knock_out():
    stages = SWISS.format(3) + "  final: {stage: knock_out, from: swiss, places: 1-2}\n"
    state = play(season(stages, names(6)), by_strength)
    assert stage(state, "final").teams == tuple(order(stage(state, "swiss").places)[:2])
    assert stage(state, "final").ties[0].winner == "t01"


# --- pairing one round -------------------------------------------------------------------------------------------------


def paired(*players):
    """Return the pairs; each player is its points, and how often more it was on the first seat than on the second."""
    found, _ = pair([Player(str(i), points, balance, set(), False) for i, (points, balance) in enumerate(players)], 1)
    return sorted("".join(sorted(teams)) for teams in found), found


def test_of_teams_with_equal_points_those_meet_that_want_other_seats():
    pairs, seated = paired((3, 1), (3, 1), (3, -1), (3, -1))
    assert pairs == ["02", "13"]
    assert {first for first, _ in seated} == {"2", "3"}


def test_equal_points_come_before_equal_seats():
    assert paired((3, 1), (3, 1), (0, -1), (0, -1))[0] == ["01", "23"]


def test_seats_that_differ_by_more_than_two_come_before_equal_points():
    assert paired((3, 2), (3, 2), (0, -2), (0, -2))[0] == ["02", "13"]


def test_of_all_equal_pairings_that_of_the_nearest_in_the_table_is_taken():
    assert paired((3, 1), (3, 1), (3, 1), (3, -1), (3, -1), (3, -1))[0] == ["03", "14", "25"]


def matchings(rest):
    """Return all ways to pair; with an odd number one is paired with None."""
    if len(rest) < 2:
        return [[]]
    first, *others = rest
    return [[(first, one), *more] for one in others for more in matchings([two for two in others if two != one])]


def badness(players, pairs):
    """Return what is bad about a pairing, the gravest first."""
    rank = {None: len(players)}
    points = {number: Fraction(player.points) for number, player in enumerate(players)}
    points[None] = points[len(players) - 1]
    met = [(players[one], players[other]) for one, other in pairs if other is not None]
    sides = [
        x for one, other in met for x in (min(one.balance, other.balance) + 1, max(one.balance, other.balance) - 1)
    ]
    return (
        sum(other.team in one.met for one, other in met),
        sum(players[one].had_bye for one, other in pairs if other is None),
        sum(max(0, abs(side) - 2) for side in sides),
        sum((points[one] - points[other]) ** 2 for one, other in pairs),
        sum(max(0, abs(side) - 1) for side in sides),
        sum((one - rank.get(other, other)) ** 2 for one, other in pairs),
    )


@st.composite
def middles(draw):
    """Draw teams in the middle of a stage, some of whose opponents have left."""
    count = draw(st.integers(2, 10))
    met = {frozenset(pair) for pair in draw(st.lists(st.tuples(st.integers(0, 12), st.integers(0, 12)), max_size=30))}
    unit = draw(st.sampled_from([1, 0.5, 0.1, 1 / 3, 1_000_000]))
    players = [
        Player(
            f"t{number}",
            draw(st.integers(0, 6)) * unit,
            draw(st.integers(-2, 2)),
            {f"t{one}" for pair in met if number in pair for one in pair - {number}},
            draw(st.booleans()),
        )
        for number in range(count)
    ]
    return sorted(players, key=lambda one: -one.points)


@given(middles())
def test_no_pairing_is_better(players):
    found, bye = pair(players, 1)
    by_id = {player.team: number for number, player in enumerate(players)}
    indices = [*range(len(players)), *([None] if len(players) % 2 else [])]
    ours = [tuple(sorted(by_id[team] for team in teams)) for teams in found] + ([(by_id[bye], None)] if bye else [])
    assert badness(players, ours) == min(badness(players, pairs) for pairs in matchings(indices))


def test_two_winners_meet_and_the_teams_that_drew_meet_losers():
    one = season(SWISS.format(3), names(6))
    first = [fixture.id for fixture in one.state({}).open_fixtures()]
    state = one.state(dict(zip(first, (Outcome((0.0, 1.0)), Outcome((0.0, 1.0)), Outcome((0.0, 0.0))), strict=True)))
    points = {row.team: row.points for row in state.stages[0].tables[0].rows}
    assert sorted(sorted(points[team] for team in teams_of(fixture)) for fixture in state.open_fixtures()) == [
        [0, 1], [0, 1], [3, 3],
    ]  # fmt: skip


@given(st.integers(0, 10**6))
def test_opponents_that_have_left_count_with_the_points_they_have_and_matches_not_played_not_at_all(seed):
    head = "tie_breaks: [points, buchholz]\n"
    outcomes, outcome = {}, by_chance(seed)
    first = season(SWISS.format(3), names(7), head).state({}).fixtures[:2]
    outcomes[first[0].id] = outcome(first[0])
    left = {teams_of(one)[0]: {"swiss": 1} for one in first}  # the first of them has played before
    swiss = play(season(SWISS.format(3), names(7), head, left), outcome, outcomes).stages[0]
    rows = swiss.tables[0].rows
    assert {*left} < {row.team for row in rows}
    points = {row.team: row.points for row in rows}
    buchholz = Counter()
    for one, other in (teams_of(fixture) for fixture in swiss.fixtures if fixture.id in outcomes):
        buchholz[one] += points[other]
        buchholz[other] += points[one]
    keys = [(row.points, buchholz[row.team]) for row in rows]
    assert keys == sorted(keys, reverse=True)
    assert [row.shared for row in rows] == [keys.count(key) > 1 for key in keys]
