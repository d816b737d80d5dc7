"""The store: one writer, one version, and errors that say what to do."""

import sqlite3
import subprocess
import sys

import pytest
from sqlalchemy import create_engine, delete, text, update

from rcj_challenges.core.diagnostics import DiagnosticError
from rcj_challenges.records.folder import utc_now
from rcj_challenges.tournament.played import read_played
from rcj_challenges.tournament.season import Outcome
from rcj_challenges.tournament.store.lock import is_locked
from rcj_challenges.tournament.store.store import STORE_FILE, Store
from rcj_challenges.tournament.store.tables import META, METADATA, RulingRow
from tests.tournament.store_helpers import Home, code_of

HOLDER = """
import sys, time
from pathlib import Path
from rcj_challenges.tournament.store.store import Store
with Store(Path(sys.argv[1]), writing=True):
    print("held", flush=True)
    time.sleep(60)
"""


def ruling(reason):
    return RulingRow("replay", reason, utc_now(), "a")


def open_store(folder, *, writing=True):
    with Store(folder, writing=writing):
        pass


def test_a_second_writer_gets_a_clear_error_and_readers_do_not_until_the_first_is_killed(tmp_path):
    with subprocess.Popen([sys.executable, "-c", HOLDER, tmp_path], stdout=subprocess.PIPE) as holder:
        assert holder.stdout is not None
        assert holder.stdout.readline()
        assert is_locked(tmp_path)
        with pytest.raises(DiagnosticError) as error:
            open_store(tmp_path)
        assert code_of(error) == "store-in-use"
        assert str(holder.pid) in error.value.diagnostics[0].message
        open_store(tmp_path, writing=False)
        holder.kill()
    assert not is_locked(tmp_path)
    open_store(tmp_path)


def test_a_store_of_another_version_is_refused(tmp_path):
    with Store(tmp_path, writing=True) as store, store.transaction() as connection:
        connection.execute(update(META).values(value="99"))
    for writing in (True, False):
        with pytest.raises(DiagnosticError) as error:
            open_store(tmp_path, writing=writing)
        assert code_of(error) == "store-version"


@pytest.mark.parametrize("content", [b"no database at all" * 100, None], ids=["other file", "torn pages"])
def test_a_damaged_store_is_refused_before_anything_is_played(tmp_path, content):
    home = Home(tmp_path)
    home.play()
    path = home.data / STORE_FILE
    damaged = bytearray(path.read_bytes())
    damaged[4096:] = b"\x7f" * (len(damaged) - 4096)
    path.write_bytes(content or bytes(damaged))
    with pytest.raises(DiagnosticError) as error:
        open_store(home.data)
    assert code_of(error) == "store-damaged"


def test_of_a_tournament_that_has_not_begun_nothing_was_played_and_nothing_is_made(tmp_path):
    home = Home(tmp_path)
    assert home.state().outcomes == {}
    assert not home.data.exists()


def test_an_unwritable_place_is_reported(tmp_path):
    (tmp_path / "file").write_text("", encoding="utf-8")
    with pytest.raises(DiagnosticError) as error:
        open_store(tmp_path / "file" / "data")
    assert code_of(error) == "store-unwritable"


def test_a_full_disk_is_no_damage(tmp_path):
    with Store(tmp_path, writing=True) as store:
        with store._engine.connect() as connection:
            pages = connection.exec_driver_sql("PRAGMA page_count").scalar()
            connection.exec_driver_sql(f"PRAGMA max_page_count={pages}")
            connection.commit()
        with pytest.raises(DiagnosticError) as error:
            store.add_ruling(ruling("x" * 100_000))
        assert code_of(error) == "store-unwritable"
        assert store.rulings() == []


def test_a_reader_sees_what_a_writer_has_written_while_it_writes(tmp_path):
    home = Home(tmp_path)
    with home.opened() as writer:
        writer.store.add_ruling(ruling("b"))
        with home.opened(writing=False) as reader:
            assert [row.reason for row in reader.store.rulings()] == ["b"]


def test_what_was_played_is_read_with_result_record_submissions_and_time(tmp_path):
    home = Home(tmp_path)
    state, executor = home.play()
    with home.opened(writing=False) as tournament:
        played = read_played(tournament.store)
    assert played.matches.keys() == state.outcomes.keys()
    match = played.matches[state.stages[0].fixtures[0].id]
    assert match.record == home.data / "records" / executor.jobs[0].id
    assert match.result["wall_s"] == 1.0
    assert match.played_at.tzinfo is not None
    assert {one.team: one.sha256 for one in played.submissions}.items() >= match.submissions.items()
    assert all(one.path.is_file() for one in played.submissions)
    assert Outcome(tuple(match.result["score"].values())).scores == state.outcomes[match.fixture].scores


def set_up_to(path, count):
    """Leave the file of a store as it is after so many tables, when its first command was killed."""
    with sqlite3.connect(path) as connection:
        connection.execute("PRAGMA journal_mode=WAL")
    engine = create_engine(f"sqlite:///{path}")
    METADATA.create_all(engine, tables=METADATA.sorted_tables[:count])
    engine.dispose()


@pytest.mark.parametrize("count", range(len(METADATA.tables) + 1))
def test_a_store_whose_creation_was_interrupted_is_completed(tmp_path, count):
    set_up_to(tmp_path / STORE_FILE, count)
    with Store(tmp_path, writing=False) as store:
        assert store.rulings() == []
    with Store(tmp_path, writing=True) as store:
        store.add_ruling(ruling("b"))
    with Store(tmp_path, writing=False) as store:
        assert len(store.rulings()) == 1


def test_a_database_without_version_and_with_content_is_refused(tmp_path):
    home = Home(tmp_path)
    home.play()
    with Store(home.data, writing=True) as store, store.transaction() as connection:
        connection.execute(delete(META))
    with pytest.raises(DiagnosticError) as error:
        open_store(home.data)
    assert code_of(error) == "store-version"


@pytest.mark.parametrize(
    ("cell", "content"),
    [("job.summary", "{no json"), ("played.outcome", "[[1]"), ("played.outcome", "[7]"), ("played.played_at", "noon"),
     ("job.ended_at", 5), ("submission.received_at", "noon"), ("job.state", b"\xff")],
)  # fmt: skip
def test_a_cell_that_is_no_json_or_date_is_damage(tmp_path, cell, content):
    home = Home(tmp_path)
    home.play()
    table, _, column = cell.partition(".")
    with Store(home.data, writing=True) as store, store.transaction() as connection:
        connection.execute(
            update(METADATA.tables[table]).values({column: text("CAST(:content AS TEXT)")}), {"content": content}
        )
    with home.opened(writing=False) as tournament, pytest.raises(DiagnosticError) as error:
        tournament.state(), tournament.store.summaries(), read_played(tournament.store)
    assert code_of(error) == "store-damaged"


@pytest.mark.parametrize("writing", [True, False])
def test_an_empty_store_beside_records_is_damage(tmp_path, writing):
    home = Home(tmp_path)
    home.play()
    (home.data / "records" / "one").mkdir(exist_ok=True)
    for path in home.data.glob(f"{STORE_FILE}*"):
        path.unlink()
    open_store(home.data, writing=False)  # moved away: all is played again
    (home.data / STORE_FILE).touch()
    with pytest.raises(DiagnosticError) as error:
        open_store(home.data, writing=writing)
    assert code_of(error) == "store-damaged"


def test_a_store_that_was_moved_away_is_made_again(tmp_path):
    home = Home(tmp_path)
    state, _ = home.play()
    (home.data / "records" / "one").mkdir(exist_ok=True)
    for path in home.data.glob(f"{STORE_FILE}*"):
        path.unlink()
    assert home.play()[0].outcomes == state.outcomes
