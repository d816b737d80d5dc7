"""What lasts for a half, a phase or the match: scores since its beginning, and what is kept so long."""

from dataclasses import replace

import pytest

from rcj_challenges.expect.scripted_match import ScriptedMatch, half_of
from rcj_challenges.referee.carry_over import CarryOver
from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.halves import by_seat
from rcj_challenges.scenario.load import load_text
from tests.referee.building import once, payloads
from tests.views.sheets import section, sheet

HEAD = "schema_version: 2\nid: legs\ntitle: Legs\nextends: soccersim_v2\n"
GOALS = """
rules:
  goal_of_yellow:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    actions: [{action: score, entrant: yellow}]
  goal_of_blue:
    triggers: [{trigger: enters, entity: ball, zone: yellow_goal}]
    actions: [{action: score, entrant: blue}]
"""
BEST_OF_FIVE = (
    """
match: {halves: 5, half_s: 1.6, called: leg}
counters: {legs: {per: entrants, keep: match}}
"""
    + GOALS
    + """
  leg_won:
    for_each: entrants
    triggers: [{trigger: half_ended}]
    conditions: [{score: each, since: half, above: {score: others, since: half}}]
    actions: [{action: count, counter: legs}]
  match_won:
    triggers: [{trigger: holds, conditions: [{counter: legs, entity: entrants, at_least: 3}]}]
    actions: [{action: end, what: match, reason: three legs}]
"""
)
GOAL_Y_M = {"yellow": 0.8, "blue": -0.8}


def played(text: str, *goals: str) -> list[ScriptedMatch]:
    """Play halves of 50 ticks; in each the ball enters a goal for one of the entrants at tick 10, if one is named."""
    loaded = load_text(HEAD + text)
    carried, found = CarryOver(loaded.scenario), []
    for number, scorer in enumerate(goals, 1):
        half = half_of(loaded.scenario, number)
        half = replace(half, scores=by_seat(carried.scores, half.teams), kept=dict(carried.kept))
        play = ScriptedMatch(loaded.scenario, loaded.roster, half)
        play.play(9)
        if scorer:
            play.place("ball", 0, GOAL_Y_M[scorer])
        while not play.referee.time_is_up and play.output.ended is None:
            play.play()
        play.finish()
        carried.add(half, play.referee)
        found.append(play)
        if play.output.ends_match:
            break
    return found


def test_first_to_win_three_legs():
    legs = played(BEST_OF_FIVE, "yellow", "blue", "yellow", "yellow", "blue")
    assert len(legs) == 4
    assert legs[-1].referee.counters["legs"] == {"blue": 1, "yellow": 3}
    assert legs[-1].referee.scores == {"blue": 1, "yellow": 3}


def test_a_score_since_the_phase_began():
    told = "{action: emit, event: TOLD, payload: {all: {score: yellow}, half: {score: yellow, since: half}, phase: {score: yellow, since: phase}}}"
    text = (
        "match: {halves: 2, half_s: 1.6}\nphases: {late: {}}\n"
        + GOALS.replace("actions", "phases: any\n    actions")
        + "  later: {triggers: [{trigger: time_reached, at_s: 0.64}], actions: [{action: set_phase, phase: late}]}\n"
        + f"  told: {{phases: any, triggers: [{{trigger: half_ended}}], actions: [{told}]}}\n"
    )
    first, second = played(text, "yellow", "yellow")
    assert payloads(first) == [{"all": 1, "half": 1, "phase": 0}]
    assert payloads(second) == [{"all": 2, "half": 1, "phase": 0}]


@pytest.mark.parametrize(("by", "ended_by_rule", "told"), [("", True, 1), ("", False, 1), (", by: time", True, 0),
                         (", by: time", False, 1), (", by: rule", True, 1), (", by: rule", False, 0)])  # fmt: skip
def test_the_end_of_a_half_is_by_time_or_by_a_rule(by, ended_by_rule, told):
    end = "  end: {triggers: [{trigger: time_reached, at_s: 0.64}], actions: [{action: end}]}\n"
    over = f"  over: {{triggers: [{{trigger: half_ended{by}}}], actions: [{{action: emit, event: TOLD}}]}}\n"
    (half,) = played("match: {half_s: 1.6}\nrules:\n" + end * ended_by_rule + over, "")
    assert len(half.events_named("TOLD")) == told


PHASES = "schema_version: 2\nphases: {early: {}, late: {}}\nfirst_phase: early\n"


def to_phase(tick: int, phase: str) -> str:
    return once(tick, f"{{action: set_phase, phase: {phase}}}", name=f"to_{phase}_{tick}", more="phases: any,")


def counted(stage, keep: str, kind: str = "counter") -> list[object]:
    """Return a counter or flag after the phases early, late, early and late; it is counted or set once, in `early`."""
    writes = {"counter": "{action: count, counter: n}", "flag": "{action: set_flag, flag: n}"}[kind]
    play = stage(
        PHASES + f"{kind}s: {{n: {{keep: {keep}}}}}",
        once(5, writes, name="write", more="phases: any,"),
        to_phase(10, "late"), to_phase(20, "early"), to_phase(30, "late"),
    )  # fmt: skip
    found = []
    for _ in range(4):
        play.play(9)
        found.append(getattr(play.referee, f"{kind}s")["n"])
        play.play(1)
    return found


@pytest.mark.parametrize(
    ("keep", "values"),
    [("half", [1, 1, 1, 1]), ("match", [1, 1, 1, 1]), ("phase", [1, 0, 0, 0]), ("late", [1, 0, 0, 0]),
     ("early", [1, 1, 0, 0])],
)  # fmt: skip
def test_counters_and_flags_begin_anew_with_the_phase_that_is_named(stage, keep, values):
    assert counted(stage, keep) == values
    assert counted(stage, keep, "flag") == list(map(bool, values))


@pytest.mark.parametrize(("keep", "runs_out"), [("half", [20]), ("early", [20]), ("late", [30]), ("phase", [30])])
def test_a_timer_begins_anew_with_its_phase(stage, keep, runs_out):
    over = "rules: {over: {phases: any, triggers: [{trigger: timer_expired, timer: t}], actions: [{action: emit, event: TOLD}]}}"
    play = stage(PHASES + f"timers: {{t: {{lasts_s: 0.64, starts: true, keep: {keep}}}}}", over, to_phase(10, "late"))
    play.play(60)
    assert [event.tick for event in play.events_named("TOLD")] == runs_out


@pytest.mark.parametrize(("keep", "over"), [("", [[], []]), (", keep: match", [[], [14]])])
def test_a_timer_goes_on_in_the_next_half(keep, over):
    text = f"match: {{halves: 2, half_s: 1.6}}\ntimers: {{t: {{lasts_s: 2.048, starts: true{keep}}}}}\nrules:\n"
    text += "  over: {triggers: [{trigger: timer_expired, timer: t}], actions: [{action: emit, event: TOLD}]}\n"
    assert [[event.tick for event in half.events_named("TOLD")] for half in played(text, "", "")] == over


@pytest.mark.parametrize(
    ("most", "fired"),
    [("1", [1, 1]), ("{half: 1}", [1, 1]), ("{match: 1}", [1, 0]), ("{phase: 1}", [3, 3]), ("{late: 1}", [2, 2])],
)
def test_a_rule_fires_so_often_in_what_is_named(most, fired):
    text = "match: {halves: 2, half_s: 1.6}\nphases: {late: {}, later: {}}\nrules:\n"
    for tick, phase in ((10, "late"), (20, "later")):
        text += f"  to_{phase}: {{phases: any, triggers: [{{trigger: time_reached, at_s: {tick * 0.032}}}], "
        text += f"actions: [{{action: set_phase, phase: {phase}}}]}}\n"
    text += "  act: {phases: any, triggers: [{trigger: time_reached, at_s: 0.032, every_s: 0.128}], "
    text += f"max_executions: {most}, actions: [{{action: emit, event: TOLD}}]}}\n"
    assert [len(half.events_named("TOLD")) for half in played(text, "", "")] == fired


def test_a_phase_that_does_not_exist_is_refused():
    for text in (
        "counters: {n: {keep: lat}}",
        "rules: {r: {triggers: [{trigger: half_started}], max_executions: {lat: 1}, actions: [{action: end}]}}",
    ):
        with pytest.raises(ScenarioError) as refused:
            load_text(HEAD + "phases: {late: {}}\n" + text)
        assert [problem.code for problem in refused.value.diagnostics] == ["unknown-name"]


def test_the_sheet_says_how_long_it_is_kept():
    text = """
match: {halves: 2, half_s: 60, called: round}
phases: {late: {}}
counters: {a: {keep: phase}, b: {keep: late, initial: 2}, c: {keep: match}}
timers: {t: {lasts_s: 5, starts: true, keep: phase}}
rules:
  it:
    triggers: [{trigger: half_ended, by: time}]
    conditions: [{score: blue, since: half, above: {score: yellow, since: half}}]
    max_executions: {match: 1}
    actions: [{action: score, entrant: blue}]
"""
    course = section(sheet(text), "Course")
    assert "The counter “a” is 0 when a phase begins." in course
    assert "The counter “b” is 2 when the phase “late” begins." in course
    assert "The counter “c” is 0 when the match starts, and goes on from round to round." in course
    assert "The timer “t” lasts 5 s; it starts when a phase begins." in course
    rules = section(sheet(text), "Rules in full")
    assert (
        "When a round is over because its time is up, provided that the score of blue in this round is more than the score of yellow in this round"
        in rules
    )
    assert "(at most once in the match)" in rules
