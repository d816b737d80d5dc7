"""Who is told to wait awake for the next tick, and when nobody is."""

from dataclasses import replace
from types import SimpleNamespace

import pytest

from rcj_challenges.controllers import scheduling, tasks
from rcj_challenges.controllers.scheduling import AS_EVERYBODY, Manners
from rcj_challenges.expect.scripted_match import half_of
from rcj_challenges.facts.play import Fault
from rcj_challenges.facts.traffic import Request
from rcj_challenges.match import haste
from rcj_challenges.match.haste import SOON_S, Haste
from rcj_challenges.match.loop import TickLoop
from rcj_challenges.match.stage import build_stage
from rcj_challenges.scenario.load import load

AWAKE = 0


@pytest.fixture
def computer(monkeypatch):
    """A computer of two processors on which one thread runs, on the second, and ticks take a third of a millisecond.

    Three programs play, of which one stays awake; the others keep a quarter of a processor busy.
    """
    told = SimpleNamespace(now_s=0.0, tick_s=SOON_S / 3, running=1, looked=0, here=1, ours=0.5, ours_s=7.0)
    told.busy, told.computed_s = {AWAKE: 1.0, 1: 0.15, 2: 0.1}, {AWAKE: 0.0, 1: 3.0, 2: 4.0}

    def clock():
        told.now_s += told.tick_s
        told.ours_s += told.ours * told.tick_s
        for robot in told.computed_s:
            told.computed_s[robot] += told.busy[robot] * told.tick_s
        return told.now_s

    def running():
        told.looked += 1
        return told.running

    monkeypatch.setattr(haste, "time", SimpleNamespace(perf_counter=clock, thread_time=lambda: told.ours_s))
    monkeypatch.setattr(tasks, "running", running)
    monkeypatch.setattr(tasks, "all_processors", lambda: 2)
    monkeypatch.setattr(tasks, "processors", lambda: 2)
    monkeypatch.setattr(scheduling, "processor_here", lambda: told.here)
    told.haste = Haste(lambda: dict(told.computed_s))
    return told


def answers(of, ticks, awake=AWAKE):
    return [of.next_is_soon(awake) for _ in range(ticks)]


def test_the_next_tick_is_soon_once_it_is_known_that_there_is_room(computer):
    assert not any(answers(computer.haste, 63))
    assert computer.looked == 0


def test_one_tick_in_64_is_slept_through_so_that_nobody_of_ours_is_counted(computer):
    of = computer.haste
    answers(of, 63)
    for looked in range(1, 5):
        assert answers(of, 64) == 63 * [True] + [False]
        assert computer.looked == looked


@pytest.mark.parametrize("running", [2, 7, 0])
def test_beside_others_who_compute_nobody_stays_awake(computer, running):
    of = computer.haste
    answers(of, 63)
    computer.running = running  # 0: nobody tells
    assert not any(answers(of, 192))
    assert not of.manners.gives_way
    computer.running = 1
    answers(of, 1)
    assert answers(of, 62) == 62 * [True]


@pytest.mark.parametrize("running", [2, 7])
def test_beside_others_who_compute_programs_keep_to_the_matchs_processor(computer, running):
    of, computer.running, computer.busy[AWAKE] = computer.haste, running, 0.1
    answers(of, 64)
    assert of.manners == AS_EVERYBODY  # it is not known yet how much they compute
    answers(of, 64)
    assert of.manners == Manners(gives_way=False, keeps_to=1)
    computer.here = 0  # Linux has put it elsewhere
    answers(of, 64)
    assert of.manners == Manners(gives_way=False, keeps_to=0)
    computer.running = 1
    answers(of, 64)
    assert of.manners == Manners(gives_way=True, leaves=0)


@pytest.mark.parametrize(("busy", "keeps_to"), [(0.48, 1), (0.52, None)])
@pytest.mark.parametrize("share", [1.0, 0.2])
def test_beside_others_programs_that_compute_more_than_the_match_may_be_everywhere(computer, busy, keeps_to, share):
    of, computer.running, computer.ours = computer.haste, 2, 0.5 * share  # of a processor that others want as well
    computer.busy = {AWAKE: 0.1 * share, 1: 0.1 * share, 2: (busy - 0.2) * share}
    answers(of, 128)
    assert of.manners == Manners(gives_way=False, keeps_to=keeps_to)


def test_who_is_granted_a_part_of_a_large_computer_does_not_take_it_for_full(computer, monkeypatch):
    monkeypatch.setattr(tasks, "all_processors", lambda: 64)
    computer.running, computer.busy[AWAKE] = 63, 0.1
    of = Haste(lambda: dict(computer.computed_s))
    assert not any(answers(of, 256))
    assert of.manners == AS_EVERYBODY
    computer.running = 64
    answers(of, 128)
    assert of.manners == Manners(gives_way=False, keeps_to=1)


def test_one_look_alone_does_not_tell_that_no_processor_is_free(computer):
    of, computer.busy[AWAKE] = computer.haste, 0.1
    for running in (2, 1, 2, 1):
        computer.running = running
        answers(of, 64)
        assert of.manners.keeps_to is None


@pytest.mark.parametrize(("tick_s", "keeps_to"), [(0.015, 1), (0.017, None), (0.032, None)])
def test_beside_others_programs_of_a_match_that_is_watched_may_be_everywhere(computer, tick_s, keeps_to):
    of, computer.running, computer.tick_s, computer.busy[AWAKE] = computer.haste, 2, tick_s, 0.1
    answers(of, 128)
    assert of.manners == Manners(gives_way=False, keeps_to=keeps_to)


def test_where_nobody_tells_how_many_compute_programs_may_be_everywhere(computer):
    of, computer.running, computer.busy[AWAKE] = computer.haste, 0, 0.1
    answers(of, 128)
    assert of.manners == AS_EVERYBODY


def test_beside_others_too_one_that_computes_for_long_sets_all_free(computer):
    of, computer.running, computer.busy[AWAKE] = computer.haste, 2, 0.1
    answers(of, 130)
    assert of.manners.keeps_to == 1
    of.somebody_computes()
    answers(of, 61)
    assert of.manners == AS_EVERYBODY
    answers(of, 1)
    assert of.manners.keeps_to == 1


def test_where_ticks_take_long_nobody_stays_awake(computer):
    of = computer.haste
    answers(of, 64)
    computer.tick_s = 0.032
    assert not any(answers(of, 16))
    computer.tick_s = SOON_S / 2
    assert of.next_is_soon(AWAKE)


def test_programs_that_compute_little_leave_the_match_its_processor(computer):
    of = computer.haste
    answers(of, 64)
    assert of.manners == Manners(gives_way=True, leaves=None)  # it is not known yet how much they compute
    answers(of, 64)
    assert of.manners == Manners(gives_way=True, leaves=1)
    computer.here = 0  # Linux has put it elsewhere
    answers(of, 64)
    assert of.manners == Manners(gives_way=True, leaves=0)


def test_programs_that_compute_much_may_be_on_all_processors(computer):
    of = computer.haste
    answers(of, 128)
    computer.busy[2] = 0.3
    answers(of, 64)
    assert of.manners == Manners(gives_way=True, leaves=None)


@pytest.mark.parametrize("is_known_to_have_failed", [True, False])
def test_one_that_ends_has_not_given_back_what_it_computed(computer, is_known_to_have_failed):
    of = computer.haste
    computer.busy[2] = 0.5
    answers(of, 128)
    if is_known_to_have_failed:
        del computer.computed_s[1]
    else:
        computer.computed_s[1] = computer.busy[1] = 0.0
    answers(of, 64)
    assert of.manners == Manners(gives_way=True, leaves=None)


def test_all_count_who_had_to_sleep(computer):
    of = computer.haste
    answers(of, 128)
    computer.tick_s, computer.busy[AWAKE] = SOON_S * 1.01, 0.3  # so nobody waits awake
    answers(of, 30)
    computer.tick_s = SOON_S / 3
    computer.busy[1] = computer.busy[2] = 0.0
    answers(of, 34)
    assert of.manners == Manners(gives_way=True, leaves=1)  # it was awake for a part of the time
    answers(of, 64, awake=1)
    assert of.manners == Manners(gives_way=True, leaves=1)
    computer.busy[AWAKE] = 0.5
    answers(of, 64, awake=1)
    assert of.manners == Manners(gives_way=True, leaves=None)


def test_while_somebody_computes_all_may_be_on_all_processors(computer):
    of = computer.haste
    answers(of, 130)
    assert of.manners.leaves == 1
    of.somebody_computes()
    assert answers(of, 61) == 60 * [True] + [False]
    manners = of.manners
    assert manners == Manners(gives_way=True, leaves=None)
    of.somebody_computes()
    assert of.manners is manners
    answers(of, 1)
    assert of.manners == Manners(gives_way=True, leaves=1)


def test_where_ticks_take_long_programs_may_be_on_all_processors(computer):
    of = computer.haste
    answers(of, 128)
    computer.tick_s, computer.busy = 0.032, dict.fromkeys(computer.busy, 0.01)
    answers(of, 64)
    assert of.manners == Manners(gives_way=True, leaves=None)


def test_where_nobody_tells_on_which_processor_the_match_is_none_is_left_to_it(computer):
    computer.here = None
    answers(computer.haste, 128)
    assert computer.haste.manners == Manners(gives_way=True, leaves=None)


def test_manners_are_told_anew_only_when_they_change(computer):
    of = computer.haste
    answers(of, 128)
    manners = of.manners
    answers(of, 640)
    assert of.manners is manners


def test_where_nobody_knows_how_many_processors_there_are_nobody_stays_awake(computer, monkeypatch):
    monkeypatch.setattr(tasks, "processors", lambda: 0)
    assert not any(answers(Haste(dict), 200))


@pytest.mark.skipif(not tasks.processors(), reason="only Linux tells it")
def test_linux_tells_that_at_least_this_thread_runs():
    assert tasks.running() >= 1


@pytest.mark.skipif(not tasks.processors(), reason="only Linux tells it")
@pytest.mark.parametrize(
    ("told", "processors"),
    [
        (["max 100000\n"], 4),
        (["250000 100000\n"], 2),
        (["50000 100000\n"], 0),
        (["-1\n", "100000\n"], 4),
        (["100000\n", "100000\n"], 1),
        (["900000\n", "100000\n"], 4),
        (["what is this\n"], 4),
        (["100000 0\n"], 4),
        ([], 4),
    ],
)
def test_a_container_keeps_no_more_processors_busy_than_it_is_granted(monkeypatch, tmp_path, told, processors):
    monkeypatch.setattr("os.sched_getaffinity", lambda _: set(range(4)))
    files = [tmp_path / str(number) for number in range(max(1, len(told)))]
    for file, text in zip(files, told, strict=False):
        file.write_text(text, encoding="ascii")
    monkeypatch.setattr(tasks, "_GRANTS", (tuple(map(str, files)),))
    assert tasks.processors() == processors


class Noted:
    """A program that asks for steps of so many ticks, and of which is noted who was told that the next one is soon."""

    def __init__(self, name, notes, ticks, fails_at=None, computes_at=None):
        self.name, self.ticks, self.notes = name, ticks, notes
        self.fails_at, self.computes_at = fails_at, computes_at
        self.steps, self.manners = 0, []

    def collect(self, if_long=None):
        if if_long is not None:
            if_long()
        self.steps += 1
        return Fault(self.name, "crash", 0, 1, "made up") if self.steps == self.fails_at else Request(self.ticks)

    def collect_soon(self):
        return None if self.steps == self.computes_at else self.collect()

    def release(self, observation):
        self.notes.append((self.name, observation.soon))

    def behave(self, manners):
        self.manners.append(manners)

    def computed_s(self):
        return float(self.steps)

    def overstepped(self, tick):
        return None


@pytest.fixture
def stage():
    """Return what sets up a half of some ticks with six of them: the half, the stage, and what they noted."""

    def set_up(ticks, **asks):
        loaded = load("match")
        half = replace(half_of(loaded.scenario), ticks=ticks)
        notes = []
        names = loaded.roster.entities[: loaded.roster.robots]
        drivers = {index: Noted(name, notes, *asks.get(name, (1,))) for index, name in enumerate(names)}
        return half, build_stage(loaded.scenario, loaded.roster, half, drivers), notes

    return set_up


@pytest.fixture
def told(monkeypatch, stage):
    """Return what plays some ticks: by tick, who was released, and whether it was told to stay awake."""

    def play(ticks, *, soon=True, **asks):
        monkeypatch.setattr(Haste, "next_is_soon", lambda *_: soon)
        half, set_up, notes = stage(ticks, **asks)
        by_tick = []

        def on_tick(*_):
            by_tick.append(notes.copy())
            notes.clear()

        TickLoop(set_up, half, on_tick, lambda _: None, lambda _: None).play()
        return by_tick[1:]

    return play


def awake(ticks):
    return [[name for name, is_awake in notes if is_awake] for notes in ticks]


def test_the_one_that_is_released_first_stays_awake(told):
    ticks = told(3)
    assert awake(ticks)[:2] == [["B1"], ["B1"]]
    assert [len(notes) for notes in ticks] == [6, 6, 0]


def test_of_those_who_are_due(told):
    assert awake(told(5, B1=(2,)))[:4] == [["B2"], ["B1"], ["B2"], ["B1"]]


def test_one_that_has_failed_is_not_among_them(told):
    assert awake(told(4, B1=(1, 2)))[:3] == [["B1"], ["B2"], ["B2"]]


def test_where_the_next_tick_is_not_soon_all_sleep(told):
    assert not any(awake(told(4, soon=False)))


def test_all_behave_as_is_wanted_of_them(monkeypatch, stage):
    room, apart = Manners(gives_way=True, leaves=None), Manners(gives_way=True, leaves=1)
    wanted = iter([AS_EVERYBODY, AS_EVERYBODY, room, room, apart, AS_EVERYBODY, AS_EVERYBODY, room, room])

    def next_is_soon(haste, _):
        haste.manners = next(wanted)
        return False

    monkeypatch.setattr(Haste, "next_is_soon", next_is_soon)
    half, set_up, _ = stage(10, B1=(1, 5))
    TickLoop(set_up, half, lambda *_: None, lambda _: None, lambda _: None).play()
    first, *others = set_up.drivers.values()
    assert first.manners == [room]  # it fails at its fifth step
    # When the half is over they all clean up at once, and the match has nothing to do.
    assert all(one.manners == [room, apart, AS_EVERYBODY, room, AS_EVERYBODY] for one in others)


def test_one_that_computes_for_long_and_all_others_may_do_so_on_all_processors(monkeypatch, stage):
    apart, room, notes = Manners(gives_way=True, leaves=1), Manners(gives_way=True, leaves=None), []

    def next_is_soon(haste, _):
        haste.manners = apart if not notes else haste.manners
        notes.append(haste.manners)
        return False

    monkeypatch.setattr(Haste, "next_is_soon", next_is_soon)
    half, set_up, _ = stage(5, Y2=(1, None, 2))
    TickLoop(set_up, half, lambda *_: None, lambda _: None, lambda _: None).play()
    assert notes == [apart, apart, room, room]
    assert all(one.manners == [apart, room, AS_EVERYBODY] for one in set_up.drivers.values())


def test_what_counts_is_how_long_each_has_computed_that_plays(monkeypatch, stage):
    told = []
    monkeypatch.setattr(Haste, "next_is_soon", lambda haste, _: told.append(haste._computed_s_until_now()))
    half, set_up, _ = stage(4, B1=(1, 3))
    TickLoop(set_up, half, lambda *_: None, lambda _: None, lambda _: None).play()
    assert told == [dict.fromkeys(range(6), 1.0), dict.fromkeys(range(6), 2.0), dict.fromkeys(range(1, 6), 3.0)]
