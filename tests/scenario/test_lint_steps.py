"""Lint of sequences that shall keep their steps and lose them all the same."""

from __future__ import annotations

import pytest

from rcj_challenges.scenario.lint.table import lint
from rcj_challenges.scenario.load import load_text

HEAD = """schema_version: 1
id: it
title: It
extends: soccersim_v2
match: {half_s: 60}
spots: {checkpoint: {x_m: 0, y_m: 0}}
sequences: {way: {%s, steps: [blue_goal, yellow_goal], when_placed: goes_on}}
phases: {pause: {lasts_s: 3}, before: {lasts_s: 3}}
first_phase: %s
placements: {all_back: [{entity: robots, at: start}]}
rules:
  done: {%striggers: [{trigger: sequence_completed, sequence: way}], actions: [{action: score, entrant: blue}], says: So.}
"""
FALLS = "  %s: {phases: %s, triggers: [{trigger: tips_over, entity: robots}], actions: [%s], says: Fell.}\n"
PUT = "{action: place, entity: Y1, at: {spot: checkpoint}}"
BACK = "{action: place, layout: all_back}"
PAUSE = "{action: set_phase, phase: pause}"


def found(rules: str, whose: str = "entity: Y1", phases: str = "", first: str = "play") -> list[str]:
    """Return what is said about steps that are not kept."""
    text = HEAD % (whose, first, phases) + rules
    return [str(one) for one in lint(load_text(text, file="it.yaml")) if one.kind == "steps_kept_in_vain"]


def falls(*actions: str, name: str = "fell", phases: str = "[play]") -> str:
    return FALLS % (name, phases, ", ".join(actions))


class TestStepsThatAreNotKept:
    @pytest.mark.parametrize(("whose", "put"), [("entity: Y1", PUT), ("per: yellow", PUT), ("per: robots", BACK)])
    def test_who_is_placed_with_a_pause_in_which_nobody_follows_loses_them(self, whose, put):
        (text,) = found(falls(put, PAUSE), whose)
        assert text == (
            f"it.yaml:7:{HEAD.splitlines()[6].index('goes_on') + 1 + len(whose) - 2}: warning: sequences.way.when_placed: when "
            "rule 'fell' has placed its entity the steps are lost all the same: no rule that names this sequence lives in "
            "phase 'pause', and it begins anew after that; add 'pause' to the phases of one of the rules that name it, or "
            "write phases: any there [steps_kept_in_vain]"
        )

    def test_so_does_who_is_placed_in_that_pause(self):
        assert found(falls(PAUSE) + falls(PUT, name="back", phases="[pause]"))
        begins = "  back: {phases: any, triggers: [{trigger: phase_entered, phase: pause}], actions: [%s], says: So.}\n"
        assert found(falls(PAUSE) + begins % PUT)

    @pytest.mark.parametrize("phases", ["phases: any, ", "phases: [play, pause], "])
    def test_a_rule_that_follows_it_there_keeps_them(self, phases):
        assert found(falls(PUT, PAUSE), phases=phases) == []

    @pytest.mark.parametrize("more", [PUT, "{action: remove, entity: Y1, for_s: 1}"])
    def test_one_that_is_placed_without_a_pause_has_them_kept(self, more):
        assert found(falls(PUT, PAUSE) + falls(more, name="other")) == []

    def test_somebody_elses_placements_do_not_count(self):
        assert found(falls(PUT, PAUSE), "entity: Y2") == []
        assert found(falls(PUT, PAUSE), "per: blue") == []

    def test_what_comes_before_any_step_loses_none(self):
        puts = "  begin: {phases: %s, triggers: [{trigger: half_started}], actions: [%s], says: So.}\n"
        assert found(puts % ("[before]", BACK), first="before") == []
        assert found(puts % ("[play]", f"{BACK}, {PAUSE}")) == []
        assert found(falls(PUT, phases="[before]"), first="before") == []
