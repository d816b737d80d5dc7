"""A tournament on a Dask cluster ends with the results of a local run, whatever happens to the workers."""

import os
import signal
import sys
import time
from pathlib import Path

import pytest

from rcj_challenges.core.diagnostics import DiagnosticError
from rcj_challenges.records.result import versions
from rcj_challenges.tournament.cluster import ClusterExecutor
from rcj_challenges.tournament.jobs import Workplace
from tests.cli.in_this_process import here
from tests.tournament.store_helpers import Home, Silent, code_of
from tests.tournament.test_killed import DUEL, SHORT, matches_of, played_here, what_came_out

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="finds processes by /proc")


def new_cluster(**options):
    from distributed import LocalCluster  # half of the time of collecting this folder

    return LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=":0", **options)


@pytest.fixture(scope="module")
def near_cluster():
    """Return a cluster of which scheduler and workers are threads; matches are processes here too."""
    with new_cluster(processes=False) as made:
        yield made


@pytest.fixture(scope="module")
def cluster():
    with new_cluster() as made:
        yield made


def new_home(folder, half_s=0.2):
    folder.mkdir()
    (folder / "duel.yaml").write_text(DUEL.replace("half_s: 1,", f"half_s: {half_s},"), encoding="utf-8")
    return Home(folder, SHORT, teams=("ada", "bee"))


def on_cluster(home, cluster, notes=None, *, is_shared=False, kind=ClusterExecutor, **other_versions):
    (home.data / "records").mkdir(parents=True, exist_ok=True)
    note = ([] if notes is None else notes).append
    expected = versions().model_dump() | other_versions
    return kind(Workplace(home.data), cluster.scheduler_address, expected, is_shared, note)


def busy_workers(cluster):
    """Return the process ids of the workers that play a match."""
    processes = [nanny.process for nanny in list(cluster.workers.values())]
    return [pid for process in processes if process is not None and (pid := process.pid) and matches_of(process)]


def test_two_workers_end_with_the_tables_and_digests_of_this_computer(tmp_path, near_cluster):
    home = new_home(tmp_path / "there")
    home.play(executor=on_cluster(home, near_cluster))
    assert what_came_out(home) == played_here(new_home(tmp_path / "here"))
    assert home.play()[1].jobs == [], "all records are whole"


def test_workers_with_another_version_are_refused_before_the_first_match(tmp_path, near_cluster):
    with pytest.raises(DiagnosticError) as error:
        on_cluster(Home(tmp_path), near_cluster, mujoco="3.0.0")
    assert code_of(error) == "cluster-worker-unfit"
    assert len(error.value.diagnostics) == 2, "each worker"


@pytest.mark.nightly
def test_a_worker_that_has_finished_its_match_and_left_keeps_its_result(tmp_path):
    home, notes = new_home(tmp_path / "there"), []

    class Leaving(ClusterExecutor):
        """Its worker leaves between the end of its match and the next look at it; another one takes over its result."""

        def submit(self, job):
            super().submit(job)
            self._running[-1].future.exception()  # waits for its end
            if len(self._client.nthreads()) > 1:
                self._client.retire_workers([self._running[-1].worker])
                self._looked_at_s = 0.0

    with new_cluster(processes=False) as cluster:
        home.play(executor=on_cluster(home, cluster, notes, kind=Leaving))
    assert any("has gone" in note for note in notes)
    assert not any("handed out again" in note for note in notes)
    assert what_came_out(home) == played_here(new_home(tmp_path / "here"))


def test_an_address_without_a_cluster_is_refused():
    with pytest.raises(DiagnosticError) as error:
        ClusterExecutor(Workplace(Path("data")), "nowhere://x", {}, False, print)
    assert code_of(error) == "cluster-unreachable"


def test_without_dask_the_error_explains_how_to_install_it(monkeypatch):
    monkeypatch.setitem(sys.modules, "distributed", None)
    with pytest.raises(DiagnosticError) as error:
        ClusterExecutor(Workplace(Path("data")), "tcp://127.0.0.1:1", {}, False, print)
    assert code_of(error) == "cluster-missing"


def test_a_shared_folder_needs_a_cluster(tmp_path, monkeypatch, capsys):
    home = Home(tmp_path)
    assert here(monkeypatch, home.folder, "tournament", "run", "league.yaml", "--shared") == 2
    assert "error[shared-without-cluster]" in capsys.readouterr().err


@pytest.mark.nightly
def test_records_can_stay_on_a_shared_folder(tmp_path, cluster):
    home = new_home(tmp_path / "there")
    home.play(executor=on_cluster(home, cluster, is_shared=True))
    assert what_came_out(home) == played_here(new_home(tmp_path / "here"))
    assert list((home.data / "records" / ".playing").iterdir()) == []


def before_each_poll(executor, act):
    """Let something happen each time a run looks for what is done."""
    poll = executor.poll

    def acted():
        act()
        return poll()

    executor.poll = acted
    return executor


@pytest.mark.nightly
def test_a_job_whose_worker_is_killed_is_handed_out_again(tmp_path):
    killed = []

    def kill_the_first():
        for pid in busy_workers(cluster):
            if not killed:
                killed.append(pid)
                os.kill(pid, signal.SIGKILL)

    home, notes = new_home(tmp_path / "there", half_s=20), []
    with new_cluster() as cluster:
        state, _ = home.play(executor=before_each_poll(on_cluster(home, cluster, notes), kill_the_first))
    assert killed
    assert any("handed out again" in note for note in notes)
    assert len(state.outcomes) == 2
    assert what_came_out(home) == played_here(new_home(tmp_path / "here", half_s=20))


@pytest.mark.nightly
def test_a_job_that_ends_two_workers_could_not_be_played(tmp_path):
    def kill_all():
        for pid in busy_workers(cluster):
            os.kill(pid, signal.SIGKILL)

    home, observer = new_home(tmp_path / "there", half_s=600), Silent()
    with new_cluster() as cluster:
        home.play(executor=before_each_poll(on_cluster(home, cluster), kill_all), observer=observer)
    assert [kind for kind, _ in observer.seen] == ["not_played"] * 2


@pytest.mark.nightly
def test_an_interrupted_run_ends_the_matches_on_the_workers(tmp_path, cluster):
    def interrupt():
        if busy_workers(cluster):
            raise KeyboardInterrupt

    home = new_home(tmp_path / "there", half_s=600)
    with pytest.raises(KeyboardInterrupt):
        home.play(executor=before_each_poll(on_cluster(home, cluster), interrupt))
    until_s = time.monotonic() + 30
    while busy_workers(cluster):
        assert time.monotonic() < until_s
        time.sleep(0.1)
