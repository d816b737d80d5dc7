"""The process that checks or repairs a submission, or plays a match or an event: the only one that opens teams' files.

It reads a request from standard input, and writes JSON lines to standard output: a line for each stage, and the report.
When its standard input ends, the dispatcher has ended: it then stops the programs and ends too.
"""

from __future__ import annotations

import _thread
import json
import os
import sys
import threading
from pathlib import Path
from typing import Any

from rcj_challenges.checker.check import CheckOptions, check_file
from rcj_challenges.checker.discovery import SubmissionName
from rcj_challenges.checker.repair import repair
from rcj_challenges.checker.report import check_report
from rcj_challenges.checker.report_files import write_page
from rcj_challenges.checker.report_html import html_page
from rcj_challenges.core.errors import RcjError
from rcj_challenges.scenario.load import load
from rcj_challenges.web.event_play import play_event
from rcj_challenges.web.playing import play

_END_S = 10.0


def work() -> None:
    """Check, repair or play, as the request says."""
    request = json.loads(_read_line())
    threading.Thread(target=_end_with_dispatcher, daemon=True).start()
    try:
        if request["kind"] == "match":
            _write(play(request))
        elif request["kind"] == "event":
            _write(play_event(request, _write))
        else:
            _work(request)
    except RcjError as error:
        _write({"error": str(error)})
    except KeyboardInterrupt:  # the dispatcher has ended, or has the answer already
        sys.exit(1)


def _work(request: dict[str, Any]) -> None:
    loaded = load(request["scenario"], request["overrides"])
    path, folder = Path(request["path"]), Path(request["folder"])
    if request["kind"] == "repair":
        try:
            repaired = repair(path, folder / "repaired.zip", loaded.scenario)
            _write({"repaired": None if repaired.out is None else str(repaired.out), "done": list(repaired.done)})
        except RcjError as error:
            _write({"repaired": None, "done": [], "error": str(error)})
        return
    options = CheckOptions(request["sandbox"], replays=folder, show_output=True)
    named = SubmissionName(request["name"], "replay")
    report = check_file(path, loaded, options, named=named, on_stage=lambda stage: _write({"stage": stage}))
    whole = check_report(loaded.scenario.id, loaded.scenario.title, request["sandbox"], [report], [])
    write_page(folder / "report.html", html_page(whole, folder))
    written = report.model_dump(mode="json")
    for match in written["matches"]:
        match["replay"] = Path(match["replay"]).name  # where it lies is known to the site alone
    _write({"report": written, "host": bool(report.code) or report.our_fault})


def _write(message: dict[str, Any]) -> None:
    sys.stdout.write(json.dumps(message) + "\n")
    sys.stdout.flush()


def _read_line() -> bytes:
    """Read from the descriptor: a buffered reader that a thread waits in cannot be closed when this process ends."""
    line = b""
    while not line.endswith(b"\n"):
        part = os.read(0, 65536)
        if not part:
            break
        line += part
    return line


def _end_with_dispatcher() -> None:
    while os.read(0, 65536):
        pass
    _thread.interrupt_main()
    threading.Event().wait(_END_S)
    os._exit(1)
