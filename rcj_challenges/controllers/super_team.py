"""A SuperTeam: programs of several teams drive the robots of one side."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import PurePosixPath

from rcj_challenges.controllers.team import Team


@dataclass(frozen=True)
class SuperTeam:
    """Teams that play as one: the first robot of the side is driven by the first team's program, and so on.

    It takes the place of a `Team` in a match. Each robot has the files, the private folder and the log of its own team.

    Attributes:
        members: a team for each robot of the side, in the order of the scenario.
    """

    members: tuple[Team, ...]

    @property
    def name(self) -> str:
        """The members' names."""
        return " + ".join(member.name for member in self.members)

    @property
    def digest(self) -> str:
        """SHA-256 over the digests of the members, in their order."""
        return hashlib.sha256("\n".join(member.digest for member in self.members).encode("ascii")).hexdigest()

    @property
    def files(self) -> Mapping[PurePosixPath, bytes]:
        """Files that all members share: none, so a SuperTeam has no logo."""
        return {}

    def driving(self, number: int) -> Team:
        """Return the team that drives a robot.

        Args:
            number: of the robot on its side, from 0.
        """
        return self.members[number]

    def close(self) -> None:
        """Forget the files of all members."""
        for member in self.members:
            member.close()
