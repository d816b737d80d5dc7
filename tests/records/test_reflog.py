"""The reflog has the format of the original."""

import json
import struct
from datetime import UTC, datetime
from pathlib import Path

from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.facts.play import Event, Fault, Firing, RefereeOutput
from rcj_challenges.records.lines import json_line
from rcj_challenges.records.reflog import events_of, reflog_lines
from rcj_challenges.records.testing import half_info, made_up_snapshot, small_header, small_scenario
from rcj_challenges.records.writer import RecordWriter


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


def test_a_failed_program_stands_before_what_the_rules_said_in_that_tick() -> None:
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


def test_the_referees_log_tells_what_was_measured_and_every_change_of_phase(tmp_path: Path) -> None:
    scenario = small_scenario(1, 1)
    header = small_header(scenario)
    writer = RecordWriter(tmp_path, header)
    writer.begin_half(half_info(scenario, 1, 10, header))
    fired = Firing(1, "stuck", "B1", "no_progress", 0.41, 0.5, {}, None, "B1 made no progress.")
    endless = Firing(1, "far", None, "holds", float("inf"), 1.0, {}, "phase")
    writer.tick(made_up_snapshot(0, 2), RefereeOutput(), struct.pack("<d", 0))
    writer.tick(made_up_snapshot(1, 2), RefereeOutput(firings=(fired, endless), phase="pause"), struct.pack("<d", 1))
    writer.tick(made_up_snapshot(2, 2), RefereeOutput(phase="pause"), struct.pack("<d", 2))
    writer.end_half(RefereeOutput())
    writer.finish()
    lines = [json.loads(line) for line in (writer.folder / "referee.jsonl").read_text("utf-8").splitlines()]
    assert [(line["kind"], line["tick"]) for line in lines] == [
        ("phase", 0), ("firing", 1), ("firing", 1), ("phase", 1),
    ]  # fmt: skip
    assert lines[1] == {
        "half": 1, "kind": "firing", "tick": 1, "rule": "stuck", "entity": "B1", "trigger": "no_progress",
        "measured": 0.41, "limit": 0.5, "scored": {}, "suppressed": None, "says": "B1 made no progress.",
    }  # fmt: skip
    assert lines[2]["measured"] is None
    assert lines[2]["suppressed"] == "phase"
