"""The similarity of submissions: a hint for the organizer, never a verdict.

Each program is read as a row of tokens, in which every name is one sign, every number one and every text one: renaming
and reformatting change nothing. What two submissions share are rows of tokens of a fixed length, without those of the
sample teams, which everybody may start from.
"""

from __future__ import annotations

import io
import keyword
import tokenize
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from itertools import combinations
from pathlib import Path

from rcj_challenges.scenario.resources import TEAMS_FOLDER
from rcj_challenges.submissions.archive import TeamError, read_contents

LENGTH = 12
"""Tokens of a row: shorter ones are in any two programs that drive two wheels."""
LEAST_SHARE = 0.25
_MAX_PAIRS = 200
_MAX_FILES = 3
_LAYOUT = frozenset(
    (
        tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT, tokenize.ENCODING,
        tokenize.ENDMARKER,
    )
)  # fmt: skip

Rows = frozenset[int]


@dataclass(frozen=True, slots=True)
class SimilarPair:
    """Two teams whose submissions share code, with the pairs of files that are most similar.

    A share is that of the smaller one's rows that the other one has, too.
    """

    first: str
    second: str
    share: float
    files: tuple[tuple[str, str, float], ...]


def similar_pairs(submissions: Mapping[str, Mapping[str, Path]]) -> tuple[list[SimilarPair], list[str]]:
    """Return the pairs of teams whose submissions share much, most first, and the ids of teams with unreadable ones.

    Submissions come by team id and purpose; the purpose stands before the names of its files.
    """
    known = _sample_rows()
    programs: dict[str, dict[str, Rows]] = {}
    unread = []
    for team, paths in submissions.items():
        own: dict[str, Rows] = {}
        for purpose, path in paths.items():
            try:
                files = read_contents(path).files
            except TeamError:
                unread.append(team)
                continue
            before = f"{purpose}: " if purpose else ""
            rows = {f"{before}{name}": token_rows(files[name]) - known for name in files if name.suffix == ".py"}
            own |= {name: new for name, new in rows.items() if new}
        programs[team] = own
    whole = {team: frozenset[int]().union(*files.values()) for team, files in programs.items()}
    found = []
    for first, second in combinations(sorted(programs), 2):
        if (share := _share(whole[first], whole[second])) >= LEAST_SHARE:
            found.append(SimilarPair(first, second, share, _similar_files(programs[first], programs[second])))
    return sorted(found, key=lambda pair: -pair.share)[:_MAX_PAIRS], unread


def token_rows(source: bytes) -> Rows:
    """Return hashes of all rows of `LENGTH` tokens of a program, as far as it can be read."""
    signs: list[str] = []
    try:
        tokens = tokenize.tokenize(io.BytesIO(source).readline)
        signs.extend(_sign(token) for token in tokens if token.type not in _LAYOUT)
    except (tokenize.TokenError, SyntaxError, ValueError, LookupError):
        pass  # what comes before the mistake is compared
    return frozenset(hash(tuple(signs[at : at + LENGTH])) for at in range(len(signs) - LENGTH + 1))


def _sign(token: tokenize.TokenInfo) -> str:
    if token.type == tokenize.NAME:
        return token.string if keyword.iskeyword(token.string) else "name"
    if token.type in (tokenize.NUMBER, tokenize.STRING):
        return "value"
    return token.string


def _share(one: Rows, other: Rows) -> float:
    smaller = min(len(one), len(other))
    return len(one & other) / smaller if smaller else 0.0


def _similar_files(one: Mapping[str, Rows], other: Mapping[str, Rows]) -> tuple[tuple[str, str, float], ...]:
    pairs = [(a, b, _share(rows, others)) for a, rows in one.items() for b, others in other.items()]
    return tuple(sorted((pair for pair in pairs if pair[2] >= LEAST_SHARE), key=lambda pair: -pair[2])[:_MAX_FILES])


@cache
def _sample_rows() -> Rows:
    return frozenset[int]().union(*(token_rows(path.read_bytes()) for path in sorted(TEAMS_FOLDER.rglob("*.py"))))
