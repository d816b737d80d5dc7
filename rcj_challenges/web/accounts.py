"""Cards of teams, passwords of mentors and organizers, and what a request is signed in as."""

from __future__ import annotations

import hashlib
import hmac
import secrets
import threading
from datetime import datetime, timedelta
from typing import Any, NamedTuple

from django.conf import settings
from django.contrib.auth.hashers import Argon2PasswordHasher
from django.contrib.sessions.backends.base import SessionBase
from django.db.models import Q
from django.http import HttpRequest
from django.middleware.csrf import rotate_token

from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.web.models import Account, Audit, Group, Invite, Role, Team

_ALPHABET = "0123456789ABCDEFGHJKMNPQRSTVWXYZ"
"""Crockford's base 32: no letters that look like digits."""
_CHARACTERS = 12
_AS_MEANT = str.maketrans("OIL", "011", "- \t")
_USE_NOTED_EVERY = timedelta(minutes=1)
INVITE_DAYS = 7
_FREE_FAILURES = 5
_MAX_WAIT_S = 900


class Argon2(Argon2PasswordHasher):
    """Argon2id with 64 MiB, two at a time: a crowd that signs in cannot take all memory."""

    memory_cost = 65536
    parallelism = 1
    _slots = threading.BoundedSemaphore(2)

    def encode(self, password: str, salt: str) -> str:
        """Return the hash of a password."""
        with self._slots:
            return super().encode(password, salt)

    def verify(self, password: str, encoded: str) -> bool:
        """Return whether a password is right."""
        with self._slots:
            return super().verify(password, encoded)


class Viewer(NamedTuple):
    """What a request is signed in as: a team, an account, or neither."""

    team: Team | None = None
    account: Account | None = None

    @property
    def is_organizer(self) -> bool:
        """Whether it may see and do everything."""
        return self.account is not None and self.account.role == Role.ORGANIZER

    @property
    def group(self) -> Group | None:
        """The group of a mentor."""
        return self.account.group if self.account is not None and self.account.role == Role.MENTOR else None

    def may_see(self, team: Team) -> bool:
        """Return whether it may see what a team has handed in, its reports and its output."""
        if team.deleted_at is not None:
            return False
        if self.is_organizer or (self.team is not None and self.team.pk == team.pk):
            return True
        return self.group is not None and self.group.pk == team.group_id


def new_code() -> str:
    """Return a new code of 60 random bits, as it is printed: ``7H3K-92QX-M4TD``."""
    characters = "".join(secrets.choice(_ALPHABET) for _ in range(_CHARACTERS))
    return "-".join(characters[start : start + 4] for start in range(0, _CHARACTERS, 4))


def code_hmac(code: str) -> str:
    """The hash of a code that is stored; small letters, blanks and letters that look like digits are as meant."""
    text = code.upper().translate(_AS_MEANT)
    return hmac.new(str(settings.SECRET_KEY).encode(), b"code:" + text.encode(), hashlib.sha256).hexdigest()


def give_card(team: Team) -> str:
    """Give a team a new code, which ends the old one and all sessions; return it: it is shown this once."""
    code = new_code()
    team.code_hmac = code_hmac(code)
    team.epoch += 1
    team.save(update_fields=("code_hmac", "epoch"))
    return code


def team_of_code(code: str, now: datetime) -> Team | None:
    """Return the team whose code this is; only a right one costs more than a look-up."""
    team = Team.objects.filter(code_hmac=code_hmac(code), deleted_at=None).select_related("group").first()
    if team is not None and (team.last_used_at is None or now - team.last_used_at > _USE_NOTED_EVERY):
        Team.objects.filter(pk=team.pk).update(last_used_at=now)
    return team


def enter(request: HttpRequest, team: Team) -> None:
    """Sign a team in."""
    request.session.flush()
    request.session["team"], request.session["epoch"] = team.pk, team.epoch
    rotate_token(request)


def viewer_of(request: HttpRequest) -> Viewer:
    """The viewer of a request; a team whose card was replaced is signed out."""
    user: Any = request.user
    if user.is_authenticated:
        return Viewer(account=user)
    team = team_of_session(request.session)
    if team is None and "team" in request.session:
        request.session.flush()
    return Viewer(team=team)


def team_of_session(session: SessionBase) -> Team | None:
    """Return the team that a session belongs to, unless its card was replaced since."""
    pk, epoch = session.get("team", 0), session.get("epoch", 0)
    return Team.objects.filter(pk=pk, epoch=epoch, deleted_at=None).select_related("group").first()


def invite(role: Role, group: Group | None, now: datetime) -> str:
    """Make an invitation; return its code."""
    code = new_code() + "-" + new_code()
    Invite.objects.create(
        code_hmac=code_hmac(code), role=role, group=group, expires_at=now + timedelta(days=INVITE_DAYS)
    )
    return code


def open_invite(code: str, now: datetime) -> Invite | None:
    """Return an invitation that can still be used."""
    return Invite.objects.filter(code_hmac=code_hmac(code), used_at=None, expires_at__gt=now).first()


def signs_in(name: str, password: str, now: datetime) -> Account | None:
    """Return the account that a name and a password open.

    After some failures that account alone has to wait, longer each time; never an address, which a class shares.
    """
    account = Account.objects.filter(name=name, is_active=True).first()
    if account is None or not _reserve_try(account, now):
        Account().set_password(password)  # takes as long as a wrong password
        return None
    if not account.check_password(password):
        return None
    Account.objects.filter(pk=account.pk).update(failures=0, locked_until=None)
    return account


def _reserve_try(account: Account, now: datetime) -> bool:
    """Count a try as a failure before it is made, so that tries at the same time cannot pass the wait."""
    failures = account.failures + 1
    wait_s = min(_MAX_WAIT_S, 2 ** min(failures - _FREE_FAILURES, 10)) if failures >= _FREE_FAILURES else 0
    is_free = Q(locked_until=None) | Q(locked_until__lte=now)
    return bool(
        Account.objects.filter(is_free, pk=account.pk, failures=account.failures).update(
            failures=failures, locked_until=now + timedelta(seconds=wait_s) if wait_s else None
        )
    )


def write_audit(viewer: Viewer, act: str, about: object, reason: str, now: datetime) -> None:
    """Note an act with consequences."""
    actor = str(viewer.account.name if viewer.account is not None else viewer.team or "")
    Audit.objects.create(at=now, actor=actor[:60], act=act, about=str(about)[:120], reason=sanitize(reason, 200))
