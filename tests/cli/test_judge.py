"""``rcj-challenge judge``: what people and programs are output of a recorded match that is judged again."""

import json

import pytest

from rcj_challenges.cli.commands import load_app
from rcj_challenges.records.chunks import ChunkWriter, read_chunks
from tests.cli.conftest import ONE_ROBOT, STAND

GIFT = """\
schema_version: 2
id: gift
title: A gift
extends: match
params: {gift_at_s: 1}
match: {halves: 1, half_s: 3}
placements:
  before_the_goal: [{entity: ball, at: {point: [0, 0.5]}, kick: {towards: {point: [0, 0.8]}, speed_mps: 1}}]
rules:
  gift:
    triggers: [{trigger: time_reached, at_s: {param: gift_at_s}}]
    actions: [{action: place, layout: before_the_goal}]
    says: The ball rolls into the goal.
"""


@pytest.fixture(scope="module")
def records(tmp_path_factory):
    """The folder of one record: a half of 3 s in which yellow gets a goal, at about 1.3 s."""
    folder = tmp_path_factory.mktemp("judged")
    (folder / "gift.yaml").write_text(GIFT, "utf-8")
    team = folder / "team.py"
    team.write_text(STAND, "utf-8")
    teams = ["--blue", str(team), "--yellow", str(team), "--team-name", "blue=Hanse", "--team-name", "yellow=Alster"]
    runs = folder / "runs"
    arguments = ["run", str(folder / "gift.yaml"), *teams, *ONE_ROBOT, "--quiet", "--no-replay", "--out", str(runs)]
    assert load_app()(arguments, standalone_mode=False) == 0
    return runs


@pytest.fixture
def judge(records, capsys, monkeypatch):
    """Run the command on that record, or others; returns the exit code and what was printed."""
    monkeypatch.setenv("COLUMNS", "200")

    def run(*arguments, runs=records):
        capsys.readouterr()
        code = load_app()(["judge", *map(str, arguments), "--runs", str(runs)], standalone_mode=False)
        return code, capsys.readouterr().out

    return run


def copied(record, folder):
    """Copy the files of a record into a folder and return where it is."""
    other = folder / record.name
    other.mkdir()
    for file in record.iterdir():
        if file.is_file():
            (other / file.name).write_bytes(file.read_bytes())
    return other


def test_the_newest_record_is_judged_by_its_own_rules_and_the_same_comes_out(judge):
    code, output = judge()
    assert code == 0
    assert "recorded: Hanse 0 : 1 Alster\n" in output
    assert "judged:   Hanse 0 : 1 Alster\n" in output
    assert "events as recorded" in output
    assert "Poses remain" not in output


def test_with_a_changed_rule_both_scores_and_the_difference_are_printed(judge):
    code, output = judge("--set", "rules.goal_in_blue.actions[0].points=2")
    assert code == 0
    assert "judged:   Hanse 0 : 2 Alster\n" in output
    assert "GOAL: score_yellow 1 -> 2\n" in output
    assert "Poses remain those of the record" in output


def test_another_scenario_judges_and_its_params_can_be_set(judge, records):
    file = records.parent / "stricter.yaml"
    file.write_text(
        "schema_version: 2\nid: stricter\ntitle: S\nextends: gift.yaml\nrules: {goal_in_blue: null}\n", "utf-8"
    )
    code, output = judge("--scenario", file, "--set", "gift_at_s=0.5")
    assert code == 0
    assert "judged:   Hanse 0 : 0 Alster\n" in output
    assert "GOAL: only in the record" in output


def test_json_has_both_scores_all_events_and_the_differences(judge):
    code, output = judge("--json", "--set", "rules.goal_in_blue.actions[0].points=2")
    (one,) = json.loads(output)["records"]
    assert code == 0
    assert one["recorded"]["score"] == {"blue": 0, "yellow": 1}
    assert one["judged"]["score"] == {"blue": 0, "yellow": 2}
    assert [event["event"] for event in one["judged"]["events"]].count("GOAL") == 1
    goal = next(difference for difference in one["differences"] if difference["event"] == "GOAL")
    assert (goal["recorded"]["score_yellow"], goal["judged"]["score_yellow"]) == (1, 2)


def test_a_record_that_its_own_rules_judge_otherwise_is_reported_with_exit_code_1(judge, records, tmp_path):
    (record,) = records.iterdir()
    other = copied(record, tmp_path)
    log = other / "referee.jsonl"
    log.write_text(log.read_text("utf-8").replace('"score_yellow": 1', '"score_yellow": 7'), "utf-8")
    code, output = judge(runs=tmp_path)
    assert code == 1
    assert "score_yellow 7 -> 1" in output
    assert "By its own rules the same should come out" in output


def test_without_the_referees_log_the_events_of_the_result_are_compared(judge, records, tmp_path):
    (record,) = records.iterdir()
    copy = copied(record, tmp_path)
    (copy / "referee.jsonl").unlink()
    code, output = judge(copy)
    assert (code, judge(record)[1].replace(record.name, copy.name)) == (0, output)


def cut_off(record, folder):
    """Make a record of it as a kill leaves one: poses up to 1.6 s, and a log that goes on for another 0.8 s."""
    other = copied(record, folder)
    whole = read_chunks(other / "trajectory.chunks")
    (other / "trajectory.chunks").unlink()
    header = {name: value for name, value in whole.header.items() if name != "record"}
    cut = ChunkWriter(other / "trajectory.chunks", header, 0)
    for head, body in whole.chunks[:4]:  # the half, its start, and twice 25 ticks
        cut.append(cut.pack(head, body))
    cut.close()
    log = other / "referee.jsonl"
    late = {"kind": "event", "half": 1, "tick": 70, "matchtime": 2.24, "event": "LATE", "payload": {}}
    kept = [line for line in log.read_text("utf-8").splitlines() if json.loads(line)["tick"] <= 50]
    log.write_text("\n".join([*kept, json.dumps(late), ""]), "utf-8")
    result = json.loads((other / "result.json").read_text("utf-8"))
    result |= {
        "complete": False,
        "digest": "",
        "halves": [],
        "events": [],
        "ranking": [],
        "score": {"blue": 0, "yellow": 0},
    }
    (other / "result.json").write_text(json.dumps(result), "utf-8")
    return other


def test_the_score_that_a_killed_match_could_not_write_is_read_from_the_log(judge, records, tmp_path):
    (record,) = records.iterdir()
    other = cut_off(record, tmp_path)
    code, output = judge(record, other)
    assert code == 0
    assert "recorded: Hanse 0 : 1 Alster  (not complete)\n" in output
    assert "LATE" not in output
    assert "(the record ends before the match does)" in output
    assert "2 records judged, 0 of them with another score\n" in output


def test_files_in_records_are_taken_for_them_and_a_problem_names_the_folder(judge, records, tmp_path):
    """So that a shell finds all records of a cup, and nothing else that lies beside them."""
    (record,) = records.iterdir()
    broken = copied(record, tmp_path)
    (broken / "trajectory.chunks").write_bytes(b"")
    code, output = judge(record / "result.json", broken / "result.json", "--json")
    good, bad = json.loads(output)["records"]
    assert code == 2
    assert (good["record"], bad["record"]) == (record.name, record.name)
    assert "damaged" in bad["problem"]


def test_of_several_the_others_are_judged_where_one_cannot_be(judge, records, capsys):
    (record,) = records.iterdir()
    capsys.readouterr()
    code = load_app()(["judge", str(record), "none", "--runs", str(records)], standalone_mode=False)
    printed = capsys.readouterr()
    assert code == 2
    assert "Hanse 0 : 1 Alster" in printed.out
    assert "1 record judged, 0 of them with another score; 1 could not be judged" in printed.out
    assert "no record 'none'" in printed.err
