"""How the command line starts: quickly, and without losing a word about what is wrong."""

import gc
import signal
from pathlib import Path

import pytest

from rcj_challenges import cli
from rcj_challenges.cli.app import app
from rcj_challenges.scenario import models


@pytest.fixture
def arguments(monkeypatch):
    """Return a function that runs the command line with arguments and returns its exit code."""
    thresholds = gc.get_threshold()
    monkeypatch.setenv("PYDANTIC_DISABLE_PLUGINS", "__all__")
    monkeypatch.setattr(cli, "_install_signal_handlers", list)  # the signals of this process are the tests'

    def run(*given: str) -> object:
        monkeypatch.setattr("sys.argv", ["rcj-challenge", *given])
        with pytest.raises(SystemExit) as left:
            cli.main()
        return left.value.code

    yield run
    gc.set_threshold(*thresholds)


def test_a_command_runs_and_leaves_the_others_alone(arguments, capsys):
    before = list(app.registered_commands)
    assert arguments("validate", "match") == 0
    assert capsys.readouterr().out.startswith("ok  match:")
    assert app.registered_commands == before


def test_an_unknown_command_is_met_with_the_nearest_one(arguments, capsys):
    assert arguments("valdate", "match") == 2
    assert "No such command 'valdate'. Did you mean 'validate'?" in capsys.readouterr().err


@pytest.mark.parametrize("package", ["pydantic", "mujoco.viewer"])
def test_a_package_that_is_not_installed_is_no_fault_of_ours(arguments, capsys, monkeypatch, package):
    def missing(*_):
        raise ModuleNotFoundError(f"No module named {package!r}", name=package)

    monkeypatch.setattr(cli, "_speed_up_start", missing)
    assert arguments("validate", "match") == 2
    printed = capsys.readouterr().err
    assert f"the package '{package.partition('.')[0]}' is missing" in printed
    assert "install it as the README says" in printed
    assert "Traceback" not in printed


@pytest.mark.parametrize("module", ["rcj_challenges.nowhere", "json.nowhere"])
def test_a_module_that_we_should_have_is(arguments, capsys, monkeypatch, tmp_path, module):
    def missing(*_):
        raise ModuleNotFoundError(f"No module named {module!r}", name=module)

    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(cli, "_speed_up_start", missing)
    assert arguments("validate", "match") == 3
    assert "our fault" in capsys.readouterr().err


def test_ctrl_break_of_windows_interrupts_as_ctrl_c_does(monkeypatch):
    if not hasattr(signal, "SIGBREAK"):
        monkeypatch.setattr(signal, "SIGBREAK", signal.SIGUSR1, raising=False)
    handlers = {}
    monkeypatch.setattr(signal, "signal", handlers.__setitem__)
    heard = cli._install_signal_handlers([])
    assert signal.SIGBREAK in heard
    with pytest.raises(KeyboardInterrupt):
        handlers[signal.SIGBREAK]()


def test_the_models_are_written_so_that_their_annotations_are_compiled_once():
    files = sorted(Path(models.__file__).parent.glob("*.py"))
    late = [file.name for file in files if "from __future__ import annotations\n" in file.read_text(encoding="utf-8")]
    assert late == []
