"""Playing a tournament: everything once, and nothing lost."""

import pytest

from rcj_challenges.core.diagnostics import DiagnosticError
from rcj_challenges.tournament.admission import take_submissions
from rcj_challenges.tournament.fixtures import JobMaker
from rcj_challenges.tournament.rulings import withdraw
from rcj_challenges.tournament.season import Status
from tests.tournament.store_helpers import LEAGUE, SUPER_TEAMS, FakeExecutor, Home, Silent, code_of


def test_all_stages_are_played_to_the_end_and_a_second_run_plays_nothing(tmp_path):
    home = Home(tmp_path)
    state, executor = home.play()
    assert [stage.status for stage in state.stages] == [Status.FINISHED, Status.FINISHED]
    assert len({job.id for job in executor.jobs}) == len(executor.jobs) == 4
    assert home.play()[1].jobs == []
    assert home.state().outcomes == state.outcomes


def test_a_run_that_was_interrupted_goes_on_where_it_was_and_ends_with_the_same_tables(tmp_path):
    whole, broken = Home(tmp_path / "whole"), Home(tmp_path / "broken")
    whole.play()
    with pytest.raises(KeyboardInterrupt):
        broken.play(executor=FakeExecutor(None, {1: "stop"}))
    assert len(broken.state().outcomes) == 1
    _, executor = broken.play()
    assert len(executor.jobs) == 3
    assert broken.tables() == whole.tables()


def test_a_match_lost_to_a_machine_failure_does_not_count_and_the_next_run_plays_it(tmp_path):
    home, observer = Home(tmp_path), Silent()
    state, executor = home.play(executor=FakeExecutor(None, {1: "died"}), observer=observer)
    assert [kind for kind, _ in observer.seen] == ["played", "not_played", "played"]
    assert len(state.outcomes) == 2
    assert state.stages[0].status is Status.RUNNING
    _, again = home.play()
    assert again.jobs[0].id == executor.jobs[1].id
    assert len(home.state().outcomes) == 4


def test_a_computer_that_cannot_go_on_ends_the_run_and_what_was_played_stays(tmp_path):
    home = Home(tmp_path)
    with pytest.raises(DiagnosticError) as error:
        home.play(executor=FakeExecutor(None, {1: "host"}))
    assert code_of(error) == "cannot-go-on"
    assert len(home.state().outcomes) == 1


def test_a_match_in_which_a_time_limit_decides_is_played_once_more_alone(tmp_path):
    home, observer = Home(tmp_path), Silent()
    _, executor = home.play(executor=FakeExecutor(None, {0: ["timed", "ok"]}), observer=observer)
    first = observer.seen[0][1]
    assert observer.seen[0] == ("again", first)
    assert observer.seen[3] == ("doubtful", first), "after all that is played side by side"
    assert executor.jobs[3].id == executor.jobs[0].id


def test_a_match_that_ends_alike_when_it_is_played_alone_is_not_doubtful(tmp_path):
    home, observer = Home(tmp_path), Silent()
    home.play(executor=FakeExecutor(None, {0: ["timed", "timed"]}), observer=observer)
    assert [kind for kind, _ in observer.seen] == ["again", "played", "played", "played", "played"]


def test_the_second_time_counts_and_the_match_stays_marked_as_doubtful(tmp_path):
    home = Home(tmp_path)
    _, executor = home.play(executor=FakeExecutor(None, {0: ["timed", "other"]}))
    with home.opened(writing=False) as tournament:
        assert tournament.store.jobs()[executor.jobs[0].id].doubtful
        assert tournament.store.doubtful_fixtures() == [home.state().stages[0].fixtures[0].id]


def test_a_run_that_is_interrupted_before_the_second_time_remembers_the_first(tmp_path):
    home, observer = Home(tmp_path), Silent()
    with pytest.raises(KeyboardInterrupt):
        home.play(executor=FakeExecutor(None, {0: "timed", 1: "stop"}))
    home.play(observer=observer)
    assert [kind for kind, _ in observer.seen].count("doubtful") == 1


@pytest.mark.parametrize("damage", ["missing", "cut"])
def test_of_a_damaged_record_only_this_match_is_played_again(tmp_path, damage):
    home = Home(tmp_path)
    _, executor = home.play()
    before = home.tables()
    record = home.data / "records" / executor.jobs[2].id / "result.json"
    if damage == "missing":
        record.unlink()
    else:
        record.write_bytes(record.read_bytes()[:-1])
    _, again = home.play()
    assert [job.id for job in again.jobs] == [executor.jobs[2].id]
    assert home.tables() == before


def test_what_a_killed_run_left_in_the_middle_is_removed(tmp_path):
    home = Home(tmp_path)
    left = home.data / "records" / ".playing" / "half a record"
    left.mkdir(parents=True)
    home.play()
    assert not left.exists()


def test_the_executor_is_kept_busy_but_not_given_more_than_one_job_to_wait_for_each_lane(tmp_path):
    home = Home(tmp_path, teams=[f"team{number}" for number in range(7)])
    assert home.play()[1].most_waiting == 4


def test_a_team_that_left_without_a_submission_cannot_play_in_a_super_team(tmp_path):
    teams = ("ada", "bee", "cid", "dee", "eva", "fay")
    home = Home(tmp_path, SUPER_TEAMS, teams)
    with home.opened() as tournament:
        withdraw(tournament, "ada", "its archive cannot be read")
        entries = [entry for team, entry in tournament.loaded.entries.items() if team != "ada"]
        jobs = JobMaker(tournament, take_submissions(entries, tournament.store), "off")
        (fixture,) = tournament.state().stages[0].fixtures
        with pytest.raises(DiagnosticError) as error:
            jobs.job_for(fixture)
    assert code_of(error) == "submission-unusable"


def test_finals_do_not_wait_for_open_challenges(tmp_path):
    skills = "  skills: {stage: challenge, seeds: 5, scenarios: {slalom: {scenario: slalom}}}\n"
    home = Home(tmp_path, LEAGUE.replace("  finals:", f"{skills}  finals:"))
    seen = Silent()
    home.play(observer=seen)
    played = [fixture.partition("/")[0] for _, fixture in seen.seen]
    assert played.count("skills") == 15
    assert "skills" in played[played.index("finals") + 4 :], "more challenges than lanes and waiting jobs came after it"
