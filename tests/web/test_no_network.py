"""The site asks nothing of any other computer."""

from __future__ import annotations

import ast
import subprocess
from pathlib import Path

import pytest

import rcj_challenges.web

CLIENTS = {"http.client", "urllib.request", "ftplib", "smtplib", "requests", "httpx", "aiohttp", "urllib3"}
MODULES = sorted(Path(rcj_challenges.web.__file__).parent.rglob("*.py"))


def imported(path: Path) -> set[str]:
    names: set[str] = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module is not None:
            names |= {node.module, *(f"{node.module}.{alias.name}" for alias in node.names)}
    return names


def test_no_module_of_the_site_imports_a_client_of_http_or_mail() -> None:
    assert len(MODULES) > 20
    assert {path.name: imported(path) & CLIENTS for path in MODULES if imported(path) & CLIENTS} == {}


@pytest.mark.nightly
def test_an_upload_is_checked_where_there_is_no_network_and_no_packet_is_tried_to_be_sent() -> None:
    if subprocess.run(["unshare", "-n", "ip", "link", "set", "lo", "up"], capture_output=True, check=False).returncode:
        pytest.skip("a network namespace cannot be had without root")
    test = "tests/web/test_served.py::test_what_is_handed_in_is_checked_by_playing_and_then_plays"
    command = f"ip link set lo up && python -m pytest -n 0 -p no:cacheprovider {test} && grep ^Ip: /proc/net/snmp"
    ran = subprocess.run(
        ["unshare", "-n", "sh", "-c", command],
        cwd=Path(__file__).parents[2],
        capture_output=True,
        text=True,
        check=False,
    )
    assert ran.returncode == 0, ran.stdout
    names, values = (line.split() for line in ran.stdout.splitlines() if line.startswith("Ip:"))
    assert int(values[names.index("OutNoRoutes")]) == 0
