"""No program can harm a match: each of the corpus costs at most its own robot."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from types import SimpleNamespace

import pytest

from rcj_challenges.programs import isolation, pipes, processes, scratch
from tests.hostile import page
from tests.hostile.harness import Entry, assert_gets_through, assert_held, batches, entries

HERE = [entry for entry in entries() if entry.not_here() is None]
NOT_HERE = [entry for entry in entries() if entry.not_here() is not None]
BESIDE_THE_SYSTEM = {"time", "endings", "output", "protocol", "module"}
HELD_BY_LAYERS = [entry for entry in HERE if entry.succeeds_without]


def names(batch: tuple[Entry, ...]) -> str:
    return "+".join(entry.name for entry in batch)


def cases(chosen: Iterable[Entry]) -> list[object]:
    """Return the batches of those that are telling, and for the night those of their variants."""
    entries_ = list(chosen)
    return [
        *batches(entry for entry in entries_ if not entry.variant),
        *nightly(entry for entry in entries_ if entry.variant),
    ]


def nightly(chosen: Iterable[Entry]) -> list[object]:
    """Return the batches of entries, all for the night."""
    return [pytest.param(batch, marks=pytest.mark.nightly) for batch in batches(chosen)]


def skipped(entry: Entry) -> object:
    return pytest.param((entry,), marks=pytest.mark.skip(f"{entry.name}: {entry.not_here()}"))


@pytest.mark.parametrize("batch", [*cases(HERE), *map(skipped, NOT_HERE)], ids=names)
def test_a_hostile_program_costs_its_own_robot_and_nothing_else(
    batch: tuple[Entry, ...], tmp_path: Path
) -> None:
    assert_held(batch, tmp_path)


@pytest.mark.skipif("bubblewrap" not in isolation.active_layers("auto"), reason="it is the usual way here")
@pytest.mark.parametrize(
    "batch",
    [*cases(entry for entry in HERE if entry.layers), *nightly(entry for entry in HERE if not entry.layers)],
    ids=names,
)
def test_the_layers_of_the_kernel_hold_without_bubblewrap(
    batch: tuple[Entry, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(isolation, "_has_bubblewrap", lambda: False)
    assert_held(batch, tmp_path)


@pytest.mark.nightly
@pytest.mark.parametrize("batch", batches(entry for entry in HERE if entry.about in BESIDE_THE_SYSTEM), ids=names)
def test_hostile_programs_are_held_where_pipes_cannot_be_polled(
    batch: tuple[Entry, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(pipes, "select", SimpleNamespace())
    monkeypatch.setattr(processes, "NEEDS_LIFELINE", True)
    assert_held(batch, tmp_path)


@pytest.mark.parametrize("batch", cases(HELD_BY_LAYERS), ids=names)
def test_what_the_layers_hold_does_succeed_without_them(batch: tuple[Entry, ...], tmp_path: Path) -> None:
    assert_gets_through(batch, tmp_path)


def test_the_page_about_hostile_programs_is_what_the_programs_say() -> None:
    assert page.PAGE.read_text(encoding="utf-8") == page.text(), "run: python -m tests.hostile.page"


def test_the_corpus_is_as_large_as_was_asked_for() -> None:
    assert len(entries()) >= 50


def test_a_link_in_the_place_of_a_private_folder_is_removed_and_not_followed(tmp_path: Path) -> None:
    treasure = tmp_path / "treasure"
    (treasure / "inner").mkdir(parents=True)
    (treasure / "inner").chmod(0o755)
    (treasure / "inner" / "kept.txt").write_text("kept", encoding="utf-8")
    link = tmp_path / "rcj-Y1"
    try:
        link.symlink_to(treasure, target_is_directory=True)
    except OSError:
        pytest.skip("this user may not make links (Windows)")
    assert scratch.has_more_than(link, 10**9)
    scratch.remove(link)
    assert not link.is_symlink()
    assert (treasure / "inner" / "kept.txt").read_text(encoding="utf-8") == "kept"
