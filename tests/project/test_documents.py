"""The documents: links lead somewhere, programs in them are programs, the lock file names the public index only."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest
import typer.main
import yaml

from rcj_challenges.cli.commands import load_app

ROOT = Path(__file__).resolve().parents[2]
DOCUMENTS = sorted([*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md"), *(ROOT / "examples").rglob("*.md")])
LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")
PROGRAM = re.compile(r"^```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def anchors_of(text: str) -> set[str]:
    """Return the anchors of a document's headings, as code hosts make them."""
    titles = re.findall(r"^#+ (.+)$", text, re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


def test_every_link_leads_somewhere():
    broken = []
    for document in DOCUMENTS:
        for link in LINK.findall(document.read_text(encoding="utf-8")):
            if "://" in link:
                continue
            path, _, anchor = link.partition("#")
            target = (document.parent / path).resolve() if path else document
            if not target.exists() or (anchor and anchor not in anchors_of(target.read_text(encoding="utf-8"))):
                broken.append((document.name, link))
    assert not broken


def test_every_program_in_the_documents_is_python():
    for document in DOCUMENTS:
        text = document.read_text(encoding="utf-8")
        programs = PROGRAM.findall(text)
        assert len(programs) == text.count("```python"), document.name
        for number, program in enumerate(programs):
            compile(program, f"{document.name}[{number}]", "exec")


def test_the_lock_file_names_the_public_index_only():
    lock = (ROOT / "uv.lock").read_text(encoding="utf-8")
    assert set(re.findall(r"(?:https?|file)://[^/\"]*", lock)) == {
        "https://pypi.org",
        "https://files.pythonhosted.org",
    }


def test_the_lock_file_contains_every_dependency():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    lock = tomllib.loads((ROOT / "uv.lock").read_text(encoding="utf-8"))
    locked = {package["name"] for package in lock["package"]}
    extras = [name for extra in project["optional-dependencies"].values() for name in extra]
    wanted = [re.split(r"[<>=\[;~! ]", entry)[0].lower() for entry in [*project["dependencies"], *extras]]
    assert set(wanted) <= locked


def test_the_suite_runs_on_the_three_systems_with_the_oldest_and_the_newest_python():
    workflow = yaml.safe_load((ROOT / ".github" / "workflows" / "ci.yml").read_text(encoding="utf-8"))
    matrix = workflow["jobs"]["suite"]["strategy"]["matrix"]
    assert {system.split("-")[0] for system in matrix["os"]} == {"ubuntu", "macos", "windows"}
    assert "3.11" in matrix["python"]
    assert len(matrix["python"]) == 2


def test_every_decision_is_in_the_index():
    index = (ROOT / "docs" / "adr" / "README.md").read_text(encoding="utf-8")
    records = sorted((ROOT / "docs" / "adr").glob("0*.md"))
    assert [int(record.name[:4]) for record in records] == list(range(1, len(records) + 1))
    assert index.count("](0") == len(records) > 0
    for record in records:
        number, title = re.match(r"# (\d+)\. (.+)", record.read_text(encoding="utf-8")).groups()
        assert f"| {number} | [{title}]({record.name}) |" in index


COMMANDS = typer.main.get_command(load_app()).commands


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_and_every_option_stands_in_a_document(name):
    text = "\n".join(path.read_text(encoding="utf-8") for path in DOCUMENTS if path.name != "CHANGELOG.md")
    assert re.search(rf"rcj-challenge {name}\b", text)
    # Of a pair such as --replay/--no-replay the one that changes something suffices.
    spellings = [
        {*option.opts, *option.secondary_opts} for option in COMMANDS[name].params if option.opts[0][:1] == "-"
    ]
    missing = [names for names in spellings if not any(re.search(rf"(?<![\w-]){one}(?![\w-])", text) for one in names)]
    assert missing == []


COMMAND = re.compile(r"^(?:pip|rcj-challenge) .*$", re.MULTILINE)


def test_commands_in_the_documents_can_be_typed_into_every_shell():
    """PowerShell 5 has no ``&&``, and cmd passes single quotes on."""
    commands = [command for document in DOCUMENTS for command in COMMAND.findall(document.read_text(encoding="utf-8"))]
    assert len(commands) > 40
    assert [command for command in commands if re.search(r"&&|[\s=]'", command.partition("  #")[0])] == []
