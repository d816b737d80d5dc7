"""The reflog has the format of the original; the referee's log is read back as it was written."""

import json
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.core.changes import CountersChange, HeldChange, PhaseChange, ScoreChange
from rcj_challenges.core.play import Event, Fault, Firing, RefereeOutput
from rcj_challenges.records.lines import json_line
from rcj_challenges.records.referee_log import LoggedTick, read_referee_log
from rcj_challenges.records.reflog import events_of, reflog_lines
from rcj_challenges.records.writer import RecordWriter
from tests.made_up_runs import half_info, made_up_snapshot, small_header, small_scenario


def test_a_line_has_the_keys_order_and_number_format_of_the_original() -> None:
    goal = Event(3560, "GOAL", {"team_name": "Phase Moon", "score_yellow": 1, "score_blue": 0})
    line = reflog_lines([goal], "2021-06-18T00:11:59.888153Z").decode()
    assert line == (
        '{"datetime": "2021-06-18T00:11:59.888153Z", "matchtime": 113.92, "event": "GOAL", '
        '"payload": {"team_name": "Phase Moon", "score_yellow": 1, "score_blue": 0}}\n'
    )


@given(st.text(), st.recursive(st.none() | st.booleans() | st.integers() | st.text(), st.lists, max_leaves=5))
def test_any_name_and_payload_is_one_line_that_reads_back_equal(name: str, value: object) -> None:
    line = json_line({"team_name": name, "value": value})
    assert line.count(b"\n") == 1
    assert json.loads(line) == {"team_name": name, "value": value}


def test_half_a_surrogate_pair_does_not_stop_the_record() -> None:
    assert json.loads(json_line({"team_name": "\ud83d"})) == {"team_name": "\ud83d"}


def test_a_failed_program_is_logged_before_the_rules_of_that_tick() -> None:
    fault = Fault("Y1", "crash", 6, 1, "ZeroDivisionError: division by zero")
    events = events_of(made_up_snapshot(7, 1, faults=(fault,)), RefereeOutput(events=(Event(7, "GOAL"),)))
    assert [event.name for event in events] == ["PROGRAM_FAULT", "GOAL"]
    assert events[0] == Event(
        7, "PROGRAM_FAULT", {"robot_name": "Y1", "kind": "crash", "detail": "ZeroDivisionError: division by zero"}
    )


def test_events_are_in_the_file_as_soon_as_they_happen(tmp_path: Path) -> None:
    scenario = small_scenario(1, 1)
    header = small_header(scenario)
    writer = RecordWriter(tmp_path, header, now=lambda: datetime(2021, 6, 18, 0, 11, 59, 888153, UTC))
    writer.begin_half(half_info(scenario, 1, 10, header))
    kickoff = RefereeOutput(events=(Event(0, "KICKOFF", {"robot_name": "B3"}), Event(0, "MATCH_START")))
    writer.tick(made_up_snapshot(0, 2), kickoff, b"")
    lines = [json.loads(line) for line in (writer.folder / "reflog.jsonl").read_text("utf-8").splitlines()]
    assert [line["event"] for line in lines] == ["KICKOFF", "MATCH_START"]
    assert {line["datetime"] for line in lines} == {"2021-06-18T00:11:59.888153Z"}
    writer.finish()


def test_what_is_written_to_the_referees_log_is_read_back(tmp_path: Path) -> None:
    scenario = small_scenario(1, 1)
    header = small_header(scenario)
    writer = RecordWriter(tmp_path, header)
    writer.begin_half(half_info(scenario, 1, 10, header))
    fired = Firing(1, "stuck", "B1", "no_progress", 0.41, 0.5, {}, None, "B1 made no progress.", place="gate")
    endless = Firing(1, "far", None, "holds", float("inf"), 1.0, {"blue": 0.5}, "phase")
    changes = (
        PhaseChange(1, "pause", waiting_for_kickoff=True),
        ScoreChange(1, {"blue": 0.5, "yellow": 0}),
        CountersChange(1, {"laps": {"B1": 2, "Y1": None}, "best_s": 9.5, "jump_m": None}),
        HeldChange(1, ("B1",)),
    )
    writer.tick(
        made_up_snapshot(0, 2), RefereeOutput(changes=(PhaseChange(0, "play", waiting_for_kickoff=False),)), b""
    )
    event = Event(1, "STUCK", {"robot_name": "B1", "tags": [1, None, "\ud83d"]})
    writer.tick(made_up_snapshot(1, 2), RefereeOutput(events=(event,), firings=(fired, endless), changes=changes), b"")
    writer.end_half(RefereeOutput())
    writer.finish()
    log = read_referee_log(writer.folder)
    assert log.damaged_lines == 0
    assert [one.tick for one in log.ticks] == [0, 1]
    assert log.ticks[1] == LoggedTick(1, 1, (event,), (fired, replace(endless, measured=None)), changes)
    assert log.score({"blue": 0, "yellow": 0}, lambda _: {"blue": "yellow", "yellow": "blue"}) == {
        "blue": 0,
        "yellow": 0.5,
    }


TABLES = {"teams": {"blue": {}, "yellow": {}}, "posts": {"left": {}, "right": {}}}


def test_copy_of_a_rule_is_logged_by_the_name_of_the_rule_and_its_row(tmp_path: Path) -> None:
    rules = {"goal": {"repeat_for": "teams"}, "hit": {"repeat_for": ["teams", "posts"]}, "goal_blue_twice": {}}
    scenario = small_scenario(1, 1)
    header = replace(small_header(scenario), unresolved={"tables": TABLES, "rules": rules})
    writer = RecordWriter(tmp_path, header)
    writer.begin_half(half_info(scenario, 1, 10, header))
    firings = tuple(Firing(0, name, None, "enters") for name in ("goal_blue", "hit_blue_left", "goal_blue_twice"))
    writer.tick(made_up_snapshot(0, 2), RefereeOutput(firings=firings), b"")
    writer.finish()
    lines = [json.loads(line) for line in (writer.folder / "referee.jsonl").read_text("utf-8").splitlines()]
    named = [(line["rule"], line.get("copy")) for line in lines]
    assert named == [("goal", "blue"), ("hit", "blue_left"), ("goal_blue_twice", None)]
    (tick,) = read_referee_log(writer.folder).ticks
    assert tick.firings == firings
    assert [one.copy for one in tick.firings] == ["blue", "blue_left", ""]


@pytest.mark.parametrize(
    "line",
    [
        "{", "[]", '{"kind": "phase"}', '{"half": 0, "tick": 1, "kind": "held", "robots": []}',
        '{"half": 1, "tick": -1, "kind": "held", "robots": []}', '{"half": 1, "tick": 1, "kind": "held", "robots": [1]}',
        '{"half": 1, "tick": 1, "kind": "score", "scores": {"blue": NaN}}',
        '{"half": 1, "tick": 1, "kind": "score", "scores": {"blue": 1' + 400 * "0" + "}}",
        '{"half": 1, "tick": 1, "kind": "counted", "counters": {"laps": "two"}}',
        '{"half": 1, "tick": 1, "kind": "event", "event": "GOAL", "payload": []}',
        '{"half": 1, "tick": 1, "kind": "firing", "rule": "goal", "trigger": "enters", "scored": {"blue": "1"}}',
        '{"half": 1, "tick": 1, "kind": "another"}',
    ],
)  # fmt: skip
def test_damaged_lines_of_the_referees_log_are_counted_and_left_out(line: str, tmp_path: Path) -> None:
    sound = '{"half": 1, "tick": 1, "kind": "held", "robots": ["B1"]}'
    (tmp_path / "referee.jsonl").write_text(f"{sound}\n{line}\n", encoding="utf-8")
    log = read_referee_log(tmp_path)
    assert (len(log.ticks), log.damaged_lines) == (1, 1)
