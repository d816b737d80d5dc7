"""Does what docs/site-for-a-class.md says, from the wheel in a fresh environment, and measures how long it takes.

The commands are taken from the page. What its reader does in a browser is done here by sending the same forms: make the
first account, make a card, hand in. Exits with 1 if something fails, if the submission is not accepted, or if all of it
took more than 15 minutes.
"""

from __future__ import annotations

import html
import http.cookiejar
import os
import re
import shlex
import subprocess
import sys
import tempfile
import time
import urllib.parse
import urllib.request
from pathlib import Path

from scripts.try_tutorial import ROOT, steps

PAGE = ROOT / "docs" / "site-for-a-class.md"
MAX_S = 900.0
_CARD = re.compile(r'<p class="code">([^<]+)</p>')


class _Browser:
    """Opens pages and sends their forms, with cookies."""

    def __init__(self) -> None:
        cookies = urllib.request.HTTPCookieProcessor(http.cookiejar.CookieJar())
        self._opener = urllib.request.build_opener(cookies)

    def send(self, page: str, fields: dict[str, str], action: str = "") -> str:
        """Open a page, fill in a form of it and send it; return the page that answers."""
        text = self._read(page)
        token = re.search(r'name="csrfmiddlewaretoken" value="([^"]+)"', text)
        if token is None:
            raise ValueError(f"{page} has no form")
        data = urllib.parse.urlencode({**fields, "csrfmiddlewaretoken": html.unescape(token[1])})
        return self._read(urllib.parse.urljoin(page, action or page), data.encode())

    def _read(self, address: str, data: bytes | None = None) -> str:
        with self._opener.open(address, data, timeout=60) as answer:
            return str(answer.read().decode("utf-8"))


def commands() -> list[str]:
    """Return the commands of the page, in order."""
    return [step.command for step in steps(PAGE.read_text(encoding="utf-8")) if step.command]


def main() -> int:
    """Run the page; returns the exit code."""
    began = time.monotonic()
    with tempfile.TemporaryDirectory(prefix="rcj-site-") as temporary:
        folder = Path(temporary)
        subprocess.run([sys.executable, "-m", "venv", folder / "build"], check=True)
        pip = [folder / "build" / "bin" / "python", "-m", "pip"]
        subprocess.run([*pip, "wheel", "--quiet", "--no-deps", "-w", folder, ROOT], check=True)
        (wheel,) = folder.glob("*.whl")
        environment = {**os.environ, "PATH": f"{folder / '.venv' / 'bin'}{os.pathsep}{os.environ['PATH']}"}
        environment.pop("PYTHONPATH", None)
        serving: subprocess.Popen[str] | None = None
        try:
            for command in commands():
                words = shlex.split(command)
                started = time.monotonic()
                if words[0] == ".":  # the environment is in PATH already
                    continue
                if words[:2] == ["pip", "install"]:
                    words[2:] = ["--quiet", f"{wheel}[web]"]
                if words[:3] == ["rcj-challenge", "site", "serve"]:
                    serving = subprocess.Popen(words, cwd=folder, env=environment, stdout=subprocess.PIPE, text=True)
                    environment["RCJ_CARD"] = _make_card(serving)
                else:
                    subprocess.run(words, cwd=folder, env=environment, check=True)
                print(f"{time.monotonic() - started:6.1f} s  {command}", flush=True)
        except (subprocess.CalledProcessError, OSError, ValueError) as error:
            print(f"FAILED: {error}")
            return 1
        finally:
            if serving is not None:
                serving.terminate()
                serving.wait()
    took_s = time.monotonic() - began
    print(f"{took_s:6.1f} s in all, at most {MAX_S:.0f} s")
    return 1 if took_s > MAX_S else 0


def _make_card(serving: subprocess.Popen[str]) -> str:
    """Make the first account and a card, as the page says; return the card's code."""
    if serving.stdout is None:
        raise ValueError("its output is not read")
    address, link = (serving.stdout.readline().rpartition(": ")[2].strip() for _ in range(2))
    browser = _Browser()
    browser.send(link, {"name": "teacher", "password": "a long password"})
    teams = {"group": "School 3", "names": "Robo Rangers\nBlue Foxes"}
    cards = _CARD.findall(browser.send(f"{address}/group", teams, "/group/teams/new"))
    if len(cards) != 2:
        raise ValueError(f"{len(cards)} cards, not 2")
    return str(cards[0])


if __name__ == "__main__":
    sys.exit(main())
