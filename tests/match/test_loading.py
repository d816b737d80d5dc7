"""The physics needs what a computer may lack; whose fault that is, and what helps."""

from importlib import metadata
from pathlib import Path
from types import SimpleNamespace

import pytest

from rcj_challenges import windows_runtime
from rcj_challenges.core.errors import HostError
from rcj_challenges.match.loading import load_stage

MISSING = FileNotFoundError("Could not find module 'mujoco.dll' (or one of its dependencies).")


def fails_with(error):
    def load(_):
        raise error

    return load


def test_the_stage_is_that_of_the_match():
    assert load_stage().__module__ == "rcj_challenges.match.stage"


@pytest.mark.parametrize(
    ("system", "help_"),
    [("win32", "python -m pip install msvc-runtime"), ("linux", "python -m pip install --force-reinstall")],
)
@pytest.mark.parametrize("error", [MISSING, ImportError("DLL load failed while importing _structs", name="_structs")])
def test_a_physics_that_cannot_be_loaded_is_the_computers_fault_with_help(system, help_, error):
    with pytest.raises(HostError) as reported:
        load_stage(fails_with(error), system)
    assert str(error) in str(reported.value)
    assert reported.value.code == "no-physics"
    assert help_ in reported.value.help
    assert reported.value.exit_code == 2


def test_what_is_wrong_in_our_own_modules_stays_ours():
    error = ImportError("cannot import name 'x'", name="rcj_challenges.world.world")
    with pytest.raises(ImportError) as reported:
        load_stage(fails_with(error))
    assert reported.value is error


def test_an_interruption_while_it_loads_stays_one():
    error = ImportError("numpy: cannot load module")
    error.__context__ = KeyboardInterrupt()
    with pytest.raises(ImportError):
        load_stage(fails_with(error))


@pytest.fixture
def packaged(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """What pip installed for one user only, far from `python.exe`."""
    folder = tmp_path / "Roaming" / "Python"
    folder.mkdir(parents=True)
    (folder / "msvcp140_atomic_wait.dll").touch()
    files = [metadata.PackagePath("../../MSVCP140.dll"), metadata.PackagePath("../../msvcp140_atomic_wait.dll")]
    site = folder / "Python311" / "site-packages"
    site.mkdir(parents=True)
    for file in files:
        file.dist = SimpleNamespace(locate_file=lambda path: site / path)  # type: ignore[assignment]
    monkeypatch.setattr(metadata, "distribution", lambda name: {"msvc-runtime": SimpleNamespace(files=files)}[name])
    return folder


def test_windows_looks_into_the_package_where_the_system_has_no_runtime(tmp_path, packaged):
    system = tmp_path / "System32"
    system.mkdir()
    assert windows_runtime.packaged_runtime(system) == packaged
    (system / "msvcp140_atomic_wait.dll").touch()
    assert windows_runtime.packaged_runtime(system) is None


def test_without_the_package_nothing_is_done(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def not_installed(name: str) -> None:
        raise metadata.PackageNotFoundError(name)

    monkeypatch.setattr(metadata, "distribution", not_installed)
    assert windows_runtime.packaged_runtime(tmp_path) is None
