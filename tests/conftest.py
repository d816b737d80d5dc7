"""For all tests: what they start can be interrupted, examples may take their time, nothing is compiled or parsed twice."""

import gc
import os
import signal
import sys
from collections.abc import Iterator
from typing import Any

import pytest
from hypothesis import HealthCheck, settings

from tests.brief_reports import pytest_runtest_protocol  # noqa: F401 - a hook: pytest finds it here

# A shell lets what it starts with `&` ignore Ctrl-C, `nohup` the end of a terminal; a process inherits what is ignored.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)
if hasattr(signal, "SIGHUP") and signal.getsignal(signal.SIGHUP) is signal.SIG_IGN:
    signal.signal(signal.SIGHUP, signal.SIG_DFL)


# Without bytecode each worker, and each of the hundreds of commands and matches that are started, compiles everything.
sys.dont_write_bytecode = False
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)

# A busy machine is no failure: by default an example may take 200 ms of real time, and ten may take 1 s to generate.
# Examples of one test share its folder: each writes what it reads.
_PATIENT = settings(deadline=None, suppress_health_check=[HealthCheck.too_slow, HealthCheck.function_scoped_fixture])
settings.register_profile("daily", _PATIENT, max_examples=25)
settings.register_profile("nightly", _PATIENT, max_examples=500)
settings.load_profile("daily")  # `--hypothesis-profile=nightly` chooses the other one

_OBJECTS_BETWEEN_COLLECTIONS = 50_000
"""As commands have it. With Python's own 700 the search for garbage takes a twentieth of the time of the tests."""


_NIGHTLY_TIMEOUT_S = 1800


@pytest.fixture(scope="session")
def browser() -> Iterator[Any]:
    """One browser for all tests of a worker: its start takes seconds, and a process can drive one only."""
    from tests.views.browser_stage import opened_browser

    with opened_browser() as made:
        yield made


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Give nightly tests more time than the others, unless they say themselves how much they need."""
    all_nightly = config.getoption("--hypothesis-profile") == "nightly"
    for item in items:
        if (all_nightly or item.get_closest_marker("nightly")) and not item.get_closest_marker("timeout"):
            item.add_marker(pytest.mark.timeout(_NIGHTLY_TIMEOUT_S))


@pytest.hookimpl(wrapper=True)
def pytest_collection(session: pytest.Session) -> Iterator[None]:
    """Keep the garbage collector from scanning what stays to the end: some hundred thousand objects.

    Searching them took a quarter of the time of collecting, and a tenth of that of the tests.
    """
    gc.disable()
    if not session.config.pluginmanager.has_plugin("dsession"):  # which has others collect and run the tests
        from tests.parsed_once import load_once, parse_once

        parse_once()
        load_once()
    try:
        return (yield)
    finally:
        gc.collect()
        gc.freeze()
        gc.enable()
        gc.set_threshold(_OBJECTS_BETWEEN_COLLECTIONS, *gc.get_threshold()[1:])
