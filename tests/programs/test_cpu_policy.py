"""When programs busy-wait, and which CPUs they may use."""

from types import SimpleNamespace

import pytest

from rcj_challenges.programs import cpu_policy, process_stats
from rcj_challenges.programs.cpu_policy import DEFAULT_SHARE, SOON_S, CpuPolicy, CpuShare

AWAKE = 0


@pytest.fixture
def computer(monkeypatch):
    """A computer of two processors on which one thread runs, on the second, and ticks take a third of a millisecond.

    Three programs play, of which one stays awake; the others keep a quarter of a processor busy.
    """
    machine = SimpleNamespace(now_s=0.0, tick_s=SOON_S / 3, running=1, looked=0, here=1, ours=0.5, ours_s=7.0)
    machine.busy, machine.computed_s = {AWAKE: 1.0, 1: 0.15, 2: 0.1}, {AWAKE: 0.0, 1: 3.0, 2: 4.0}

    def clock():
        machine.now_s += machine.tick_s
        machine.ours_s += machine.ours * machine.tick_s
        for robot in machine.computed_s:
            machine.computed_s[robot] += machine.busy[robot] * machine.tick_s
        return machine.now_s

    def running():
        machine.looked += 1
        return machine.running

    monkeypatch.setattr(cpu_policy, "ENABLED", True)
    monkeypatch.setattr(cpu_policy, "time", SimpleNamespace(perf_counter=clock, thread_time=lambda: machine.ours_s))
    monkeypatch.setattr(process_stats, "running", running)
    monkeypatch.setattr(process_stats, "all_processors", lambda: 2)
    monkeypatch.setattr(process_stats, "processors", lambda: 2)
    monkeypatch.setattr(cpu_policy, "current_cpu", lambda: machine.here)
    machine.policy = CpuPolicy(lambda: dict(machine.computed_s))
    return machine


def answers(of, ticks, awake=AWAKE):
    return [of.should_busy_wait(awake) for _ in range(ticks)]


def test_no_program_busy_waits_before_the_first_poll(computer):
    assert not any(answers(computer.policy, 63))
    assert computer.looked == 0


def test_program_busy_waits_but_for_the_tick_before_each_poll(computer):
    of = computer.policy
    answers(of, 63)
    for looked in range(1, 5):
        assert answers(of, 64) == 63 * [True] + [False]
        assert computer.looked == looked


@pytest.mark.parametrize("running", [2, 7, 0])
def test_no_program_busy_waits_while_all_cpus_are_busy(computer, running):
    of = computer.policy
    answers(of, 63)
    computer.running = running  # 0: unknown
    assert not any(answers(of, 192))
    assert not of.share.is_batch
    computer.running = 1
    answers(of, 1)
    assert answers(of, 62) == 62 * [True]


@pytest.mark.parametrize("running", [2, 7])
def test_programs_keep_to_the_cpu_of_the_match_while_all_cpus_are_busy(computer, running):
    of, computer.running, computer.busy[AWAKE] = computer.policy, running, 0.1
    answers(of, 64)
    assert of.share == DEFAULT_SHARE  # it is not known yet how much they compute
    answers(of, 64)
    assert of.share == CpuShare(keeps_to_cpu=1)
    computer.here = 0  # Linux has put it elsewhere
    answers(of, 64)
    assert of.share == CpuShare(keeps_to_cpu=0)
    computer.running = 1
    answers(of, 64)
    assert of.share == CpuShare(is_batch=True, leaves_cpu=0)


@pytest.mark.parametrize(("busy", "keeps_to"), [(0.48, 1), (0.52, None)])
@pytest.mark.parametrize("share", [1.0, 0.2])
def test_programs_that_compute_more_than_the_match_use_all_cpus_while_all_are_busy(computer, busy, keeps_to, share):
    of, computer.running, computer.ours = computer.policy, 2, 0.5 * share  # of a processor that others want as well
    computer.busy = {AWAKE: 0.1 * share, 1: 0.1 * share, 2: (busy - 0.2) * share}
    answers(of, 128)
    assert of.share == CpuShare(keeps_to_cpu=keeps_to)


def test_computer_is_full_only_if_all_its_cpus_are_busy_not_those_granted(computer, monkeypatch):
    monkeypatch.setattr(process_stats, "all_processors", lambda: 64)
    computer.running, computer.busy[AWAKE] = 63, 0.1
    of = CpuPolicy(lambda: dict(computer.computed_s))
    assert not any(answers(of, 256))
    assert of.share == DEFAULT_SHARE
    computer.running = 64
    answers(of, 128)
    assert of.share == CpuShare(keeps_to_cpu=1)


@pytest.mark.parametrize(("tick_s", "keeps_to"), [(0.015, 1), (0.017, None), (0.032, None)])
def test_programs_use_all_cpus_in_ticks_of_half_their_simulated_time(computer, tick_s, keeps_to):
    of, computer.running, computer.tick_s, computer.busy[AWAKE] = computer.policy, 2, tick_s, 0.1
    answers(of, 128)
    assert of.share == CpuShare(keeps_to_cpu=keeps_to)


def test_program_that_computes_for_long_gives_all_cpus_until_the_next_poll(computer):
    of, computer.running, computer.busy[AWAKE] = computer.policy, 2, 0.1
    answers(of, 130)
    assert of.share.keeps_to_cpu == 1
    of.give_all_cpus()
    answers(of, 61)
    assert of.share == DEFAULT_SHARE
    answers(of, 1)
    assert of.share.keeps_to_cpu == 1


def test_no_program_busy_waits_in_long_ticks(computer):
    of = computer.policy
    answers(of, 64)
    computer.tick_s = 0.032
    assert not any(answers(of, 16))
    computer.tick_s = SOON_S / 2
    assert of.should_busy_wait(AWAKE)


def test_programs_that_compute_little_leave_the_match_its_cpu(computer):
    of = computer.policy
    answers(of, 64)
    assert of.share == CpuShare(is_batch=True)  # it is not known yet how much they compute
    answers(of, 64)
    assert of.share == CpuShare(is_batch=True, leaves_cpu=1)
    computer.here = 0  # Linux has put it elsewhere
    answers(of, 64)
    assert of.share == CpuShare(is_batch=True, leaves_cpu=0)


def test_programs_that_compute_much_use_all_cpus(computer):
    of = computer.policy
    answers(of, 128)
    computer.busy[2] = 0.3
    answers(of, 64)
    assert of.share == CpuShare(is_batch=True)


@pytest.mark.parametrize("is_known_to_have_failed", [True, False])
def test_program_that_ends_counts_as_no_time(computer, is_known_to_have_failed):
    of = computer.policy
    computer.busy[2] = 0.5
    answers(of, 128)
    if is_known_to_have_failed:
        del computer.computed_s[1]
    else:
        computer.computed_s[1] = computer.busy[1] = 0.0
    answers(of, 64)
    assert of.share == CpuShare(is_batch=True)


def test_switch_leaves_programs_to_the_scheduler(computer, monkeypatch):
    monkeypatch.setattr(cpu_policy, "ENABLED", False)
    assert not any(answers(computer.policy, 256))
    assert computer.policy.share == DEFAULT_SHARE


@pytest.mark.skipif(not process_stats.processors(), reason="only Linux reports it")
def test_linux_counts_this_thread_as_running():
    assert process_stats.running() >= 1


@pytest.mark.skipif(not process_stats.processors(), reason="only Linux reports it")
@pytest.mark.parametrize(
    ("cpu_max", "processors"),
    [("max 100000\n", 4), ("250000 100000\n", 2), ("50000 100000\n", 0), ("what is this\n", 4), (None, 4)],
)
def test_container_has_the_cpus_that_it_is_granted(monkeypatch, tmp_path, cpu_max, processors):
    monkeypatch.setattr("os.sched_getaffinity", lambda _: set(range(4)))
    if cpu_max is not None:
        (tmp_path / "cpu.max").write_text(cpu_max, encoding="ascii")
    monkeypatch.setattr(process_stats, "_GRANT", tmp_path / "cpu.max")
    assert process_stats.processors() == processors
