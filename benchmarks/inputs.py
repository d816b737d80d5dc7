"""The largest inputs inside every bound: what it costs to look at what a stranger hands in.

    python -m benchmarks.inputs [--json] [NAME …]

Each input is as large as one bound allows, in the shape that costs most. The figure is processor time, that of
processes which were started for it included. ``tests/project/test_largest_inputs.py`` holds them every night.
"""

from __future__ import annotations

import argparse
import io
import json
import math
import os
import random
import sys
import tempfile
import zipfile
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

from rcj_challenges.checker.check import CheckOptions, check_file
from rcj_challenges.checker.reading import MAX_ALL_BYTES, MAX_BYTES, MAX_IMPORTS
from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.lint.registry import lint
from rcj_challenges.scenario.load import load, load_text
from rcj_challenges.scenario.tree import MAX_ITEMS, MAX_KEYS, MAX_VALUES
from rcj_challenges.submissions.limits import MAX_DEPTH, MAX_FILES, MAX_FOLDERS

MAX_S = 5.0
"""What looking at any of them may take."""

_FOLDER = "rcj_soccer_team_blue"
_ENTRY = f"{_FOLDER}/{_FOLDER}.py"
_PROGRAM = b"from controller import Robot\nrobot = Robot()\nwhile robot.step(32) != -1:\n    pass\n"
_HEAD = "schema_version: 2\nid: large\ntitle: Large\nextends: match\n"
_LETTERS = str.maketrans("0123456789", "qrstuvwxyz")


def archives() -> Mapping[str, Callable[[], bytes]]:
    """Return what makes each archive, by name."""
    return {
        "deep folders": _deep_folders,
        "many files": lambda: _packed({f"{_FOLDER}/data/{number}.txt": b"1" for number in range(MAX_FILES - 2)}),
        "nearly equal names of modules": _near_modules,
        "nearly equal names of programs": lambda: _zip({f"{name}/{name}.py": b"1" for name in _near_names(490, 50)}),
        "statements": lambda: _packed(_files(b"a\n" * (MAX_BYTES // 2 - 10))),
        "named arguments": lambda: _packed(_files(_filled(b"f(", lambda n: b"a%d=1," % n, b")\n"))),
        "functions in a function": lambda: _packed(
            _files(_filled(b"def f():\n", lambda n: b" def g%d():a%d\n" % (n, n)))
        ),
        "braces of an f-string": lambda: _packed(_files(_filled(b"f'", lambda _: b"{a}", b"'\n"))),
        "modules that import each other": _mutual_imports,
        "imports from any folder": _imports_from_anywhere,
        "relative imports": _relative_imports,
    }


def scenarios() -> Mapping[str, Callable[[], str]]:
    """Return what makes each scenario, by name."""
    return {
        "rules": lambda: _section("rules", _rule, 236),
        "rules with events": lambda: _section("rules", _event_rule, 236),
        "rules in phases": lambda: _section("phases", _phase, 250) + _section("rules", _phase_rule, 230, head=""),
        "zones": lambda: _section(
            "zones", lambda n: f"{{shape: circle, centre_m: [0, 0], radius_m: {0.1 + n / 1e4}}}", 250
        ),
        "polygons": _polygons,
        "obstacles": lambda: _section("obstacles", _obstacle, 256),
        "unknown keys": lambda: _HEAD + "".join(f"{name}: 1\n" for name in _near_names(230, 60)),
        "unknown zones": _unknown_zones,
        "triggers of a rule": lambda: _long_rule("triggers", "{trigger: enters, entity: ball, zone: blue_goal}"),
        "actions of a rule": lambda: _long_rule("actions", "{action: score, entrant: blue, points: 1}"),
        "repeated rules": _repeated_rules,
        "wrong values": lambda: _section("zones", lambda _: "{" + "shape: [" + "x, " * 34 + "x]}", 250),
        "list entries": lambda: _HEAD + "groups: {g: [" + ", ".join(["Y1"] * MAX_ITEMS) + "]}\n",
    }


def _zip(files: Mapping[str, bytes]) -> bytes:
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(name, content)
    return out.getvalue()


def _packed(more: Mapping[str, bytes], imports: bytes = b"") -> bytes:
    return _zip({_ENTRY: imports + _PROGRAM, "team_name.txt": b"Large\n", **more})


def _files(source: bytes) -> dict[str, bytes]:
    """Return as many different files of such a length as are looked into, with room for the program."""
    count = MAX_ALL_BYTES // MAX_BYTES
    last = source[: -len(_PROGRAM) - 200].rpartition(b"\n")[0] + b"\n"
    files = {f"{_FOLDER}/m{number}.py": b"#%d\n" % number + source[: MAX_BYTES - 9] for number in range(count - 1)}
    return files | {f"{_FOLDER}/last.py": last}


def _filled(begin: bytes, part: Callable[[int], bytes], end: bytes = b"") -> bytes:
    """Return a source of many parts that is nearly as long as a file may be."""
    parts, size = [begin], len(begin) + len(end)
    for number in range(MAX_BYTES):
        piece = part(number)
        if size + len(piece) > MAX_BYTES - 400:
            break
        parts.append(piece)
        size += len(piece)
    return b"".join([*parts, end])


def _near_names(count: int, letters: int) -> list[str]:
    """Return different names that have nearly all letters in common."""
    chance = random.Random(1)  # noqa: S311 - names, no secrets
    base = [chance.choice("ab") for _ in range(letters - 6)]
    names = []
    for number in range(count):
        changed = list(base)
        for _ in range(3):
            changed[chance.randrange(len(changed))] = chance.choice("ab")
        names.append("".join(changed) + f"{number:06d}".translate(_LETTERS))
    return names


def _near_modules() -> bytes:
    names = _near_names(MAX_FILES - 10, 50)
    imports = "".join(f"import {name}x\n" for name in names[:1000]).encode()
    return _packed({f"{_FOLDER}/{name}.py": b"" for name in names}, imports)


def _deep_folders() -> bytes:
    chains = MAX_FOLDERS // (MAX_DEPTH - 1) - 2
    below = "/".join("abcdefghijklmnopqrstuvwxyz"[: MAX_DEPTH - 2])
    each = (MAX_FILES - 10) // chains
    return _packed({f"{_FOLDER}/{chain}/{below}/{n}.txt": b"1" for chain in range(chains) for n in range(each)})


def _mutual_imports() -> bytes:
    count = math.isqrt(MAX_IMPORTS) - 1
    imports = "".join(f"import m{number}\n" for number in range(count)).encode()
    return _packed({f"{_FOLDER}/m{number}.py": b"#%d\n" % number + imports for number in range(count)}, b"import m0\n")


def _imports_from_anywhere() -> bytes:
    folders = MAX_FOLDERS - 10
    files = {f"f{number}/part.py": b"" for number in range(folders)}
    imports = b"import sys\nsys.path.append('..')\n" + b"".join(b"import part.a%d\n" % n for n in range(2_500))
    return _packed(files, imports)


def _relative_imports() -> bytes:
    names = [f"m{number}" for number in range(60)]
    files, folder = {}, _FOLDER
    for level in range(1, MAX_DEPTH - 1):
        folder = f"{folder}/p"
        lines = [f"from {'.' * dots} import m{level}\n" for dots in range(1, level + 1)]
        lines += [f"from {'.' * dots}p import p\n" for dots in range(1, level + 1)]
        source = "".join([f"#{level}\nimport p\n", *lines]).encode()
        files |= {f"{folder}/__init__.py": source, f"{folder}/m{level}.py": source + b"#m"}
    source = "".join(f"from . import {name}\nfrom .. import p\n" for name in names[:35]).encode()
    files |= {f"{folder}/{name}.py": f"#{name}\n".encode() + source for name in names}
    return _packed(files, b"import sys\nsys.path.append('.')\nimport p.p.p.p.p.p.p.p.m0\n")


def _section(name: str, entry: Callable[[int], str], count: int, head: str = _HEAD) -> str:
    return head + f"{name}:\n" + "".join(f"  x{number}: {entry(number)}\n" for number in range(count))


def _rule(number: int) -> str:
    triggers = "{trigger: enters, entity: ball, zone: blue_goal}, {trigger: leaves, entity: robots, zone: pitch}"
    conditions = f"{{entity: ball, in: pitch}}, {{speed: ball, at_least: {number}}}"
    scores = "{action: score, entrant: blue, points: 1}"
    return f"{{triggers: [{triggers}], conditions: [{conditions}], actions: [{scores}]}}"


def _event_rule(number: int) -> str:
    heard = ", ".join(f"{{trigger: event, event: E{(number * step + step) % 236}}}" for step in (1, 3, 5, 7, 11))
    emitted = ", ".join(f"{{action: emit, event: E{(number + step) % 236}}}" for step in (1, 2, 3, 5, 8))
    return f"{{triggers: [{heard}], actions: [{emitted}]}}"


def _phase(number: int) -> str:
    return f"{{lasts_s: 3, next: x{(number + 1) % 250}}}"


def _phase_rule(number: int) -> str:
    actions = ", ".join(f"{{action: set_phase, phase: x{(number + step) % 250}}}" for step in range(4))
    phases = ", ".join(f"x{(number + step) % 250}" for step in range(10))
    return f"{{phases: [{phases}], triggers: [{{trigger: touches, a: ball, b: robots}}], actions: [{actions}]}}"


def _polygons() -> str:
    corners = [2 * math.pi * corner / 16 for corner in range(16)]
    points = ", ".join(f"[{0.3 * math.cos(angle):.4f}, {0.3 * math.sin(angle):.4f}]" for angle in corners)
    return _section("zones", lambda _: f"{{shape: polygon, points_m: [{points}]}}", MAX_VALUES // 52)


def _obstacle(number: int) -> str:
    x_m, y_m = 0.02 * (number % 50) - 0.5, 0.02 * (number // 50) - 0.2
    return f"{{shape: cylinder, radius_m: 0.005, height_m: 0.1, centre_m: [{x_m:.2f}, {y_m:.2f}]}}"


def _unknown_zones() -> str:
    names = _near_names(MAX_KEYS - 20, 60)
    wrong = (name[:-1] + "a" for name in names)
    zones = "".join(f"  {name}: {{shape: circle, centre_m: [0, 0], radius_m: 0.1}}\n" for name in names)
    enters = (f"{{trigger: enters, entity: ball, zone: {name}}}" for name in wrong)
    rules = "".join(f"  r{k}: {{triggers: [{one}], actions: [{{action: end}}]}}\n" for k, one in enumerate(enters))
    return f"{_HEAD}zones:\n{zones}rules:\n{rules}"


def _long_rule(part: str, entry: str) -> str:
    other = {"triggers": "actions: [{action: end}]", "actions": "triggers: [{trigger: half_started}]"}[part]
    return f"{_HEAD}rules: {{x: {{{part}: [{', '.join([entry] * MAX_ITEMS)}], {other}}}}}\n"


def _repeated_rules() -> str:
    rows = ", ".join(f"n{number}: {{}}" for number in range(47))
    rules = _section("rules", lambda n: f"{{repeat_for: rows, {_rule(n)[1:]}", 5)
    return f"{rules}tables: {{rows: {{{rows}}}}}\n"


def checked(archive: bytes) -> list[str]:
    """Check an archive without playing; return the codes that it got."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "large.zip"
        path.write_bytes(archive)
        report = check_file(path, load("match"), CheckOptions(play=False))
    return [finding.code for stage in report.stages for finding in stage.findings]


def validated(text: str) -> list[str]:
    """Load a scenario, and look for likely mistakes; return what is wrong."""
    try:
        return [str(finding) for finding in lint(load_text(text))]
    except ScenarioError as error:
        return [str(error)]


def processor_s(do: Callable[[], object]) -> float:
    """Return the processor time of doing something, in s, with that of the processes which it waits for."""

    def spent_s() -> float:
        return sum(os.times()[:4])

    before_s = spent_s()
    do()
    return spent_s() - before_s


def figures(names: frozenset[str] = frozenset()) -> Iterator[tuple[str, float]]:
    """Yield each input with the processor time that looking at it takes, in s."""
    checked(_packed({}))  # what is loaded once for all
    validated(_HEAD)
    for name, build in archives().items():
        if not names or name in names:
            archive = build()
            yield f"archive: {name}", processor_s(lambda archive=archive: checked(archive))  # type: ignore[misc]
    for name, write in scenarios().items():
        if not names or name in names:
            text = write()
            yield f"scenario: {name}", processor_s(lambda text=text: validated(text))  # type: ignore[misc]


def main() -> int:
    """Print the figures; 1 if one is beyond the bar."""
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("names", nargs="*")
    arguments.add_argument("--json", action="store_true")
    given = arguments.parse_args()
    found = {}
    for name, taken_s in figures(frozenset(given.names)):
        found[name] = round(taken_s, 2)
        if not given.json:
            sys.stdout.write(f"{taken_s:6.2f} s  {name}{'' if taken_s <= MAX_S else f'  (more than {MAX_S:g} s)'}\n")
            sys.stdout.flush()
    if given.json:
        sys.stdout.write(json.dumps(found, indent=2) + "\n")
    return int(any(taken_s > MAX_S for taken_s in found.values()))


if __name__ == "__main__":
    sys.exit(main())
