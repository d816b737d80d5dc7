"""A process that runs tests reports only results to the process that shows progress.

pytest-xdist would report six times for each test: that it begins, how it was set up, ran and was cleared away, that it is over and
that the next may come. To write, send, read and pass on all that takes as long as most of the tests themselves.
"""

import pytest
from _pytest.runner import runtestprotocol

WORTH_TELLING_S = 0.01
"""What takes less to set up or to clear away is not missed in a list of what took longest."""


@pytest.hookimpl(tryfirst=True)
def pytest_runtest_protocol(item: pytest.Item, nextitem: pytest.Item | None) -> bool | None:
    """Run a test for another process as for this one, and tell it of the test itself and of what went wrong."""
    if not hasattr(item.config, "workerinput"):  # no other process to report to
        return None
    for report in runtestprotocol(item, log=False, nextitem=nextitem):
        if report.when == "call" or not report.passed or report.duration >= WORTH_TELLING_S:
            item.ihook.pytest_runtest_logreport(report=report)
    return True
