"""The results of a season as they are published, and what anyone can recompute of them."""

from __future__ import annotations

import hmac

from pydantic import BaseModel

from rcj_challenges.tournament.seeds import seed_hash
from rcj_challenges.web.codes import SEEDS_DIFFER, TABLE_DIFFERS
from rcj_challenges.web.errors import SiteError
from rcj_challenges.web.ladder.ratings import Fit, Rating, Result, fit, standings

_SEED_BYTES = 4
_SHOWN = 5


class Program(BaseModel):
    """A program of the season.

    Attributes:
        digest: over its files.
        follows: the one that its team handed in before.
        plays: whether it plays now, and so is in the table.
    """

    digest: str
    follows: str | None
    plays: bool


class PlayedMatch(BaseModel):
    """A rated match, as it is published; one that is void does not count."""

    number: int
    seed: int
    blue: str
    yellow: str
    score: tuple[float, float]
    digest: str
    void: str


class Results(BaseModel):
    """All that the table of a season follows from, and the table.

    Attributes:
        season: its title.
        scenario: hash of the scenario with all settings.
        versions: with which it is played.
        secret_hash: SHA-256 of the secret, known since the season began.
        secret: from which seeds follow; None until the season has ended.
        programs: all that were accepted.
        matches: all that were played.
        table: the best program first.
    """

    season: str
    scenario: str
    versions: dict[str, str]
    secret_hash: str
    secret: str | None
    programs: list[Program]
    matches: list[PlayedMatch]
    table: list[Rating]


def seed_of(secret: str, use: str) -> int:
    """Return the seed of a match: the first bytes of HMAC-SHA-256 of its number, with the secret of its season."""
    return int.from_bytes(hmac.digest(secret.encode(), use.encode(), "sha256")[:_SEED_BYTES], "big")


def fit_of(results: Results) -> Fit:
    """Fit the strengths of programs to the matches that count.

    Raises:
        ValueError: a match or a program names a program that is not among them.
    """
    counted = [Result(one.blue, one.yellow, *one.score) for one in results.matches if not one.void]
    return fit(counted, {one.digest: one.follows for one in results.programs})


def table_of(results: Results, fitted: Fit) -> list[Rating]:
    """The table that follows from a fit of the results."""
    return standings(fitted, {one.digest for one in results.programs if one.plays})


def ensure_consistent(results: Results, table: list[Rating]) -> None:
    """Refuse results whose table or seeds do not follow from their matches.

    Args:
        results: as published.
        table: as computed from them.

    Raises:
        SiteError: they differ. Seeds are compared once the secret is published.
    """
    if table != results.table:
        made_by = results.versions.get("rcj_challenges", "unknown")
        help_ = f"use version {made_by} of this package; if the table still differs, ask the organizers"
        raise SiteError("the published table does not follow from the results", help_, code=TABLE_DIFFERS)
    if (secret := results.secret) is None:
        return
    wrong = [one.number for one in results.matches if one.seed != seed_of(secret, str(one.number))]
    if seed_hash(secret) != results.secret_hash or wrong:
        message = f"the seeds of matches do not follow from the secret: {', '.join(map(str, wrong[:_SHOWN]))}"
        raise SiteError(message, "ask the organizers for the reason", code=SEEDS_DIFFER)
