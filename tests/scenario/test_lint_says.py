"""Lint of sentences and payloads: what is to be filled in is something that the referee knows when the rule fires."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from rcj_challenges.referee.script import ScriptedPlay, half_of
from rcj_challenges.scenario.lint.table import Finding, lint
from rcj_challenges.scenario.load import load_text

BODY = """schema_version: 1
id: told
title: Told
extends: soccersim_v2
match: {half_s: 60}
zones: {a: {shape: rect, x_min_m: 0.3}, b: {shape: rect, x_max_m: -0.3}}
gates: {line: {from_m: [0, 0], to_m: [0.1, 0]}, nose: {from_m: [0, 0], to_m: [0.1, 0], anchor: Y1}}
counters: {n: {}}
timers: {alone: {lasts_s: 2, starts: true}, many: {lasts_s: 2, per: robots, starts: true}}
sequences: {way: {entity: Y1, steps: [a, b], wrong_step: break}, own: {per: yellow, steps: [a, b], wrong_step: break}}
obstacles: {crate: {shape: box, centre_m: [0, 0.6], size_m: [0.1, 0.1], movable: true}}
groups: {loose: [ball, crate]}
result: {rank: [{counter: n}]}
"""


def told(trigger: str, says: str = "", payload: str = "", more: str = "") -> list[Finding]:
    """Return what lint finds in the sentence and the payload of a rule."""
    rule = (
        f"rules:\n  r:\n    triggers: [{trigger}]\n    actions: [{{action: emit, event: TOLD, payload: {{{payload}}}}}]\n"
        f'    says: "{says or "It is so."}"\n{more}'
    )
    found = lint(load_text(BODY + rule, file="it.yaml"))
    return [finding for finding in found if finding.kind in KINDS]


KINDS = {"placeholder_unknown", "placeholder_never_filled", "placeholder_at_times_empty", "word_never_filled"}

ENTERS = "{trigger: enters, entity: %s, zone: a}"
IN_A = "{condition: in_zone, entity: %s, zone: a}"
NOT_IN_A = "{condition: any_of, negate: true, conditions: [{condition: in_zone, entity: %s, zone: a}]}"
HOLDS = "{trigger: holds, condition: {condition: %s}, for_s: 1}"
FOR_EACH = "    for_each: robots\n"

ABOUT = [
    (ENTERS % "Y1", True),
    ("{trigger: leaves, entity: robots, zone: a}", True),
    ("{trigger: touches, entity: Y1, other: walls}", True),
    ("{trigger: program_fault}", True),
    ("{trigger: sequence_completed, sequence: way}", True),
    ("{trigger: sequence_broken, sequence: way}", True),
    ("{trigger: sequence_completed, sequence: own}", True),
    ("{trigger: sequence_broken, sequence: own, entity: Y2}", True),
    ("{trigger: timer_expired, timer: many}", True),
    ("{trigger: timer_expired, timer: alone}", False),
    (HOLDS % "in_zone, entity: Y1, zone: a", True),
    (HOLDS % "in_zone, entity: yellow, zone: a", False),
    (HOLDS % "distance, entity: Y1, to: [0, 0], at_most: 1", True),
    (HOLDS % "distance, entity: Y1, to: centre, at_most: 1", True),
    (HOLDS % "distance, entity: Y1, to: ball, at_most: 1", False),
    (HOLDS % "distance, entity: Y1, to: a, at_most: 1", True),
    (HOLDS % "distance, entity: Y1, to: line, at_most: 1", True),
    (HOLDS % "distance, entity: Y2, to: nose, at_most: 1", False),
    (HOLDS % "looks, entity: Y1, towards: centre, within_rad: 3.1", True),
    (HOLDS % "looks, entity: Y1, heading_rad: 1.57", True),
    (HOLDS % "looks, entity: Y1, towards: ball, within_rad: 3.1", False),
    (HOLDS % f"any_of, conditions: [{IN_A % 'Y1'}, {IN_A % 'Y1'}]", True),
    (HOLDS % f"any_of, conditions: [{IN_A % 'Y1'}, {IN_A % 'Y2'}]", False),
    (HOLDS % f"all_of, conditions: [{IN_A % 'Y1'}, {IN_A % 'Y1'}]", True),
    (HOLDS % f"all_of, conditions: [{IN_A % 'Y1'}, {NOT_IN_A % 'Y2'}]", False),
    (HOLDS % "counter, counter: n, at_most: 1", False),
    ("{trigger: half_started}", False),
    ("{trigger: half_ended}", False),
    ("{trigger: time_reached, at_s: 1}", False),
    ("{trigger: phase_entered, phase: play}", False),
    ("{trigger: event, event: TOLD}", False),
]
MEASURES = [
    ("{trigger: stays_in, entity: Y1, zone: a, limit_s: 1}", "both"),
    ("{trigger: displaced, entity: Y1, distance_m: 1}", "both"),
    ("{trigger: no_progress, entity: Y1, distance_m: 1, within_s: 1}", "both"),
    ("{trigger: tips_over, entity: Y1}", "both"),
    ("{trigger: time_reached, at_s: 1}", "both"),
    ("{trigger: timer_expired, timer: alone}", "both"),
    (HOLDS % "in_zone, entity: yellow, zone: a", "both"),
    ("{trigger: sequence_completed, sequence: way}", "measured"),
    ("{trigger: sequence_broken, sequence: way}", "measured"),
    (ENTERS % "Y1", "neither"),
    ("{trigger: touches, entity: Y1, other: walls}", "neither"),
    ("{trigger: half_started}", "neither"),
    ("{trigger: program_fault}", "neither"),
    ("{trigger: tells, entity: Y1, is_a: number}", "measured"),
    ("{trigger: tells, entity: Y1, is_a: position}", "neither"),
]


class TestUnknownBlanks:
    def test_it_stays_as_written_and_the_finding_says_where_and_what_is_filled_in(self):
        (finding,) = told(ENTERS % "Y1", "{entty} is there")
        assert str(finding) == (
            "it.yaml:18:11: warning: rules.r.says: '{entty}' is not filled in, it stays as written; did you mean 'entity'? "
            "what is filled in is {entity}, {each}, {other}, {team}, {measured}, {limit}, {points}, and params by their names "
            "[placeholder_unknown]"
        )

    @pytest.mark.parametrize(
        ("blank", "meant"),
        [
            ("robot", "entity"), ("robot_name", "entity"), ("each_name", "each"), ("gate", "each"), ("Entity", "entity"), (" entity ", "entity"),
            ("team_name", "team"), ("limits", "limit"), ("measure", "measured"), ("n", ""), ("", ""), ("half_s", ""),
        ],
    )  # fmt: skip
    def test_the_nearest_one_is_named(self, blank, meant):
        (finding,) = told(ENTERS % "Y1", f"{{{blank}}} is there")
        assert finding.kind == "placeholder_unknown"
        assert finding.problem.message.endswith(f"did you mean '{meant}'?" if meant else "stays as written")

    def test_params_are_filled_in_by_their_names_and_named_among_what_is(self):
        params = "params: {goal_points: 3, reach_m: 0.2}\n"
        assert told(ENTERS % "Y1", "{goal_points} points", more=params) == []
        (finding,) = told(ENTERS % "Y1", "{goal_point} points", more=params)
        assert finding.problem.message.endswith("did you mean 'goal_points'?")
        assert finding.remedy.endswith("{limit}, {points}, {goal_points}, {reach_m}")

    def test_each_is_told_once(self):
        assert len(told(ENTERS % "Y1", "{foo} {bar} {foo}")) == 2

    def test_a_single_brace_is_no_blank(self):
        assert told(ENTERS % "Y1", "entity} and {measured") == []


class TestABlankThatOneTriggerFillsAndAnotherDoesNot:
    TIME = "{trigger: time_reached, at_s: 1}"
    STAYS = "{trigger: stays_in, entity: Y1, zone: a, limit_s: 1}"

    @pytest.mark.parametrize(
        ("triggers", "blank", "message"),
        [
            (
                f"{ENTERS % 'Y1'}, {TIME}",
                "entity",
                "'time_reached' sets the rule off, which is about nobody in particular",
            ),
            (
                f"{ENTERS % 'Y1'}, {ENTERS % 'ball'}",
                "team",
                "'enters' sets the rule off, which is about no robot of a team",
            ),
            (f"{STAYS}, {ENTERS % 'Y1'}", "measured", "'enters' sets the rule off, which measures nothing"),
            (f"{ENTERS % 'Y1'}, {STAYS}", "limit", "'enters' sets the rule off, which has no limit"),
        ],
    )
    def test_it_is_named_with_the_trigger_that_leaves_it_empty(self, triggers, blank, message):
        (finding,) = told(triggers, f"{{{blank}}} is it")
        assert finding.kind == "placeholder_at_times_empty"
        assert finding.problem.message == f"'{{{blank}}}' stays empty when {message}"
        assert finding.remedy == "give that trigger a rule of its own, or leave it out"

    def test_where_both_fill_it_or_the_rule_knows_whom_it_is_for_nothing_is_said(self):
        assert told(f"{self.STAYS}, {self.TIME}", "{measured} of {limit}") == []
        assert told(f"{self.STAYS}, {ENTERS % 'Y2'}", "{entity}") == []
        assert told(f"{ENTERS % 'each'}, {self.TIME}", "{entity} of {team}", more=FOR_EACH) == []

    def test_a_param_that_a_blank_hides_is_named(self):
        (finding,) = told(ENTERS % "Y1", "After {limit} strokes", more="params: {limit: 8}\n")
        assert finding.remedy == (
            "leave it out, or use a trigger that measures, such as stays_in, or give the param 'limit' another name: "
            "it is not meant here"
        )


class TestWhoItIsAbout:
    @pytest.mark.parametrize(("trigger", "known"), ABOUT)
    def test_an_entity_is_known_if_a_trigger_finds_one(self, trigger, known):
        found = told(trigger, "{entity} of {team}", "who: {word: entity_name}, robot: {word: robot_name}")
        kinds = ["placeholder_never_filled", "placeholder_never_filled", "word_never_filled", "word_never_filled"]
        assert sorted(finding.kind for finding in found) == ([] if known else kinds)

    @pytest.mark.parametrize(("trigger", "known"), [entry for entry in ABOUT if not entry[1]])
    def test_with_for_each_it_is_always_known(self, trigger, known):
        assert told(trigger, "{entity} of {team}", "robot: {word: robot_name}", FOR_EACH) == []

    def test_with_one_trigger_that_finds_one_it_is_not_always_empty(self):
        findings = told(f"{{trigger: half_started}}, {ENTERS % 'Y1'}", "{entity} of {team}")
        assert [finding.kind for finding in findings] == ["placeholder_at_times_empty"] * 2

    @pytest.mark.parametrize("entity", ["ball", "crate", "loose"])
    def test_what_is_no_robot_has_a_name_and_no_team(self, entity):
        trigger = ENTERS % entity
        assert told(trigger, "{entity}", "who: {word: entity_name}") == []
        words = "a: {word: robot_name}, b: {word: team_name}, c: {word: entrant}, d: {word: score}"
        found = told(trigger, "{team}", words)
        assert sorted(finding.kind for finding in found) == ["placeholder_never_filled", *["word_never_filled"] * 4]
        assert {finding.problem.message.partition(": ")[2] for finding in found} == {"this rule is never about a robot"}

    def test_a_robot_that_nobody_drives_has_no_team(self):
        idle = "entrants: {yellow: {robots: {Y3: null}}}\nrobots: {Y3: {idle: true}}\n"
        (finding,) = told(ENTERS % "Y3", "{entity} of {team}", "who: {word: robot_name}", idle)
        assert finding.problem.message == "'{team}' stays empty: this rule is never about a robot of a team"

    def test_a_named_team_is_known_always(self):
        assert (
            told("{trigger: half_started}", payload="a: {word: team_name, of: blue}, b: {word: score, of: blue}") == []
        )

    def test_words_of_the_match_are_known_always(self):
        words = "a: {word: time_s}, b: {word: halftime}, c: {word: phase}, d: {word: seed_id}, e: {word: match_id}"
        assert told("{trigger: half_started}", payload=words) == []

    def test_the_finding_stands_at_the_word(self):
        (finding,) = told("{trigger: half_started}", payload="a: {word: score}")
        assert (finding.problem.line, finding.problem.path) == (17, "rules.r.actions[0] (emit)")
        assert finding.problem.message.startswith("'score' is always 0: no trigger of this rule is about one entity")
        assert finding.remedy.startswith("say whose with 'of', or")


class TestWhatIsMeasured:
    @pytest.mark.parametrize(("trigger", "known"), MEASURES)
    def test_it_is_known_if_a_trigger_measures(self, trigger, known):
        missing = {"both": [], "measured": ["limit"], "neither": ["measured", "limit"]}[known]
        found = [finding.problem.message.partition(" ")[0] for finding in told(trigger, "{measured} of {limit}")]
        assert sorted(found) == sorted(f"'{{{name}}}'" for name in missing)
        found = told(trigger, payload="measured: {word: measured}, limit: {word: limit}")
        assert sorted(finding.problem.message.partition(" ")[0] for finding in found) == sorted(
            f"'{n}'" for n in missing
        )

    def test_with_one_trigger_that_measures_it_is_not_always_empty(self):
        both = f"{ENTERS % 'Y1'}, {{trigger: stays_in, entity: Y1, zone: b, limit_s: 1}}"
        assert {finding.kind for finding in told(both, "{measured} of {limit}")} == {"placeholder_at_times_empty"}


BLANKS = ("entity", "team", "measured", "limit")
PLAYED = [trigger for trigger, _ in ABOUT + MEASURES if "broken" not in trigger and "displaced" not in trigger]


@pytest.mark.parametrize("trigger", [trigger for trigger in dict.fromkeys(PLAYED) if "phase_entered" not in trigger])
def test_what_lint_calls_empty_is_what_the_referee_leaves_empty(trigger):
    says = "|".join(f"{{{blank}}}" for blank in BLANKS)
    emits = "  boot: {triggers: [{trigger: time_reached, at_s: 1}], actions: [{action: emit, event: TOLD}]}\n"
    rules = f"rules:\n{emits}  r: {{triggers: [{trigger}], actions: [{{action: end}}], says: '{says}'}}\n"
    loaded = load_text(BODY.replace("half_s: 60", "half_s: 4") + rules)
    play = ScriptedPlay(loaded.scenario, loaded.roster, half_of(loaded.scenario, 1, 1), {})
    play.place("Y1", 0, -0.3)
    play.play()
    play.glide("Y1", (0.5, 0), 10)
    play.touch("Y1", "walls")
    play.tip("Y1")
    play.fail("Y2")
    play.tell("Y1", "3")
    for _ in range(60):
        play.play()
    play.tell("Y1", "3 4")
    play.glide("Y1", (-0.5, 0), 10)
    while play.verdict.ended is None and not play.referee.time_is_up:
        play.play()
    play.finish()
    (sentence, *_) = (firing.says for firing in play.firings if firing.rule == "r")
    empty = {f"'{{{blank}}}'" for blank, text in zip(BLANKS, sentence.split("|"), strict=True) if not text}
    assert {f.problem.message.partition(" ")[0] for f in lint(loaded) if f.kind in KINDS} == empty


def test_the_table_of_measures_names_each_trigger_that_measures_and_no_other():
    page = (Path(__file__).resolve().parents[2] / "docs" / "authoring.md").read_text(encoding="utf-8")
    table = page.partition("### What a trigger measures")[2].partition("\n## ")[0]
    rows = [line.split("|")[1:4] for line in table.splitlines() if line.startswith("| `")]
    known = {word: limit.strip() != "none" for words, _, limit in rows for word in re.findall(r"`(\w+)`", words)}
    measures = {
        word: known_too == "both"
        for trigger, known_too in MEASURES
        if known_too != "neither"
        for word in re.findall(r"trigger: (\w+)", trigger)
    }
    assert known == measures


class TestPoints:
    def found(self, *points: str) -> list[str]:
        actions = ", ".join(f"{{action: score, entrant: yellow, points: {number}}}" for number in points)
        rule = (
            f"triggers: [{{trigger: half_started}}], actions: [{actions or '{action: end}'}], says: '{{points}} points'"
        )
        found = lint(load_text(BODY + f"rules: {{r: {{{rule}}}}}\n"))
        return [finding.problem.message for finding in found if finding.kind in KINDS]

    def test_a_rule_that_gives_points_can_say_how_many(self):
        assert self.found("3") == []
        assert self.found("2", "2") == []
        assert self.found("{counter: n}") == []

    def test_one_that_gives_none_or_not_one_number_cannot(self):
        assert self.found() == ["'{points}' is no single number: this rule gives no points"]
        several = "'{points}' is no single number: this rule gives points more than once, and not as many"
        assert self.found("3", "1") == self.found("3", "{counter: n}") == [several]

    def test_a_param_that_only_a_sentence_names_is_used(self):
        rule = "triggers: [{trigger: half_started}], actions: [{action: end}], says: 'Over; {told} {points}.'"
        text = f"params: {{told: a, points: 3}}\nrules: {{r: {{{rule}}}}}\n"
        unused = [finding for finding in lint(load_text(BODY + text)) if finding.kind == "param_never_used"]
        # A blank goes before a param of its name.
        assert [finding.problem.path for finding in unused] == ["params.points"]
