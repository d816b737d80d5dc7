"""The tables of the site. A job's state is the state of its submission: both change in one transaction (`jobs`)."""

from __future__ import annotations

import secrets
from datetime import UTC, datetime
from typing import Any

from django.contrib.auth.base_user import AbstractBaseUser, BaseUserManager
from django.core.exceptions import ValidationError
from django.core.validators import MaxValueValidator, MinValueValidator
from django.db import models
from django.db.models import Q
from django.utils import timezone
from django.utils.translation import gettext_lazy as _

from rcj_challenges.core.errors import RcjError
from rcj_challenges.tournament.seeds import seed_hash


class Role(models.TextChoices):
    """What an account may do: a mentor runs one group, an organizer the site."""

    MENTOR = "mentor"
    ORGANIZER = "organizer"


class AccountManager(BaseUserManager["Account"]):
    """Makes accounts."""

    def create_account(self, name: str, password: str, role: Role, group: Group | None = None) -> Account:
        """Create an account with a hashed password."""
        account = self.model(name=name, role=role, group=group)
        account.set_password(password)
        account.save()
        return account


class Group(models.Model):
    """A school or club, labelled without names of persons.

    Attributes:
        quota: how many teams it may have.
        meetings: how often two programs of its teams meet in rated matches at most; 0: never.
    """

    label = models.CharField(max_length=60, unique=True)
    quota = models.PositiveIntegerField(default=40)
    meetings = models.PositiveSmallIntegerField(default=3)

    def __str__(self) -> str:
        return self.label


class Account(AbstractBaseUser):
    """An organizer or a mentor. It has a name, and no e-mail address."""

    name = models.CharField(max_length=40, unique=True)
    role = models.CharField(max_length=10, choices=Role.choices)
    group = models.ForeignKey(Group, on_delete=models.PROTECT, null=True, blank=True)
    is_active = models.BooleanField(default=True)
    failures = models.PositiveIntegerField(default=0)
    locked_until = models.DateTimeField(null=True, blank=True)

    USERNAME_FIELD = "name"
    objects = AccountManager()

    @property
    def is_staff(self) -> bool:
        """Whether it may open the lists of the organizers."""
        return self.is_active and self.role == Role.ORGANIZER

    def has_perm(self, perm: str, obj: Any = None) -> bool:
        """Return whether it may change something in the lists; nothing is deleted there."""
        return self.is_staff and ".delete_" not in perm

    def has_module_perms(self, app_label: str) -> bool:
        """Return whether it may see the lists of an app."""
        return self.is_staff


class Invite(models.Model):
    """A link with which somebody makes an account, once."""

    code_hmac = models.CharField(max_length=64, unique=True)
    role = models.CharField(max_length=10, choices=Role.choices)
    group = models.ForeignKey(Group, on_delete=models.PROTECT, null=True, blank=True)
    expires_at = models.DateTimeField()
    used_at = models.DateTimeField(null=True, blank=True)


class Team(models.Model):
    """A team: a public name and a card. Who its members are is known to its mentor only."""

    group = models.ForeignKey(Group, on_delete=models.PROTECT)
    name = models.CharField(max_length=40)
    is_name_public = models.BooleanField(default=False)
    allows_practice = models.BooleanField(default=False)
    code_hmac = models.CharField(max_length=64, null=True, blank=True, unique=True)
    epoch = models.PositiveIntegerField(default=0)
    last_used_at = models.DateTimeField(null=True, blank=True)
    deleted_at = models.DateTimeField(null=True, blank=True)

    def __str__(self) -> str:
        return self.public_name

    @property
    def public_name(self) -> str:
        """The name that everybody sees: its own once a person has released it."""
        if self.deleted_at is not None:
            return f"deleted team {self.pk}"
        return self.name if self.is_name_public else f"Team {self.pk}"


def short_halves() -> list[str]:
    """Return the settings of a ladder: many short matches say more than a few long ones."""
    return ["match.half_s=150"]


class Season(models.Model):
    """What is played in a time, and when programs are taken for it.

    Attributes:
        ladder_overrides: further settings of the matches of its ladder.
        begun_at: when its ladder began; None: it has none yet.
        ended_at: when its ladder ended, from when on its secret is shown.
        secret: from which the seeds of its matches follow.
        secret_hash: SHA-256 of the secret, shown from the beginning.
    """

    title = models.CharField(max_length=80)
    scenario = models.CharField(max_length=200, default="match")
    overrides = models.JSONField(default=list, blank=True)
    ladder_overrides = models.JSONField(default=short_halves, blank=True)
    opens_at = models.DateTimeField(null=True, blank=True)
    closes_at = models.DateTimeField(null=True, blank=True)
    is_current = models.BooleanField(default=True)
    begun_at = models.DateTimeField(null=True, blank=True, editable=False)
    ended_at = models.DateTimeField(null=True, blank=True, editable=False)
    secret = models.CharField(max_length=64, blank=True, editable=False)
    secret_hash = models.CharField(max_length=64, blank=True, editable=False)

    class Meta:
        constraints = (
            models.UniqueConstraint(fields=("is_current",), condition=Q(is_current=True), name="one_current_season"),
        )

    def __str__(self) -> str:
        return self.title

    def clean(self) -> None:
        """Refuse a scenario that cannot be played.

        Raises:
            ValidationError: it cannot be loaded with these overrides.
        """
        from rcj_challenges.scenario.load import load  # noqa: PLC0415 - a process that serves pages loads none else

        try:
            load(self.scenario, self.overrides)
            load(self.scenario, [*self.overrides, *self.ladder_overrides])
        except RcjError as error:
            raise ValidationError(str(error)) from error


class First(models.TextChoices):
    """The first stage of an event."""

    GROUPS = "groups", _("groups: all of each group meet")
    SWISS = "swiss", _("Swiss: in each round, teams with equal points meet")
    FINALS = "finals", _("none, only the knock-out")
    CHALLENGE = "challenge", _("challenge: each team plays alone, for a scenario with one team")


def new_seed() -> str:
    """Return a seed that cannot be guessed."""
    return secrets.token_hex(16)


def _within(least: int, most: int) -> tuple[MinValueValidator, MaxValueValidator]:
    return MinValueValidator(least), MaxValueValidator(most)


_LAST = datetime(2200, 1, 1, tzinfo=UTC)
_AHEAD = MinValueValidator(timezone.now, _("This time has passed.")), MaxValueValidator(_LAST)


class Event(models.Model):
    """A tournament with what plays at its deadline (`events`).

    Attributes:
        address: of the pages of events, for calendars.
        seed: of all random choices.
        closed_at: when the deadline was first seen to have passed.
        chosen: by team what played then, and `Entry.chosen_over`.
        frozen_at: when it was fixed what plays.
        frozen: team, SHA-256 of its archive, and place in the ladder (0: none).
        plays: whether its matches are to be played now.
        played_at: when all were over.
        publish_at: when there is something new to be shown.
    """

    season = models.ForeignKey(Season, on_delete=models.PROTECT)
    title = models.CharField(_("Title"), max_length=80)
    deadline = models.DateTimeField(_("Deadline"), validators=_AHEAD)
    first = models.CharField(_("First stage"), max_length=10, choices=First.choices, default=First.GROUPS)
    groups = models.IntegerField(_("Groups"), default=1, validators=_within(1, 26))
    rounds = models.IntegerField(_("Rounds of a Swiss stage"), default=5, validators=_within(1, 64))
    finalists = models.IntegerField(
        _("Teams in the finals, of each group; 0: none"), default=4, validators=_within(0, 64)
    )
    seeds = models.IntegerField(_("Runs of a challenge"), default=5, validators=_within(1, 1000))
    premiere = models.DateTimeField(_("First premiere of the last stage"), null=True, blank=True, validators=_AHEAD)
    minutes_between = models.IntegerField(_("Minutes between premieres"), default=30, validators=_within(0, 10_080))
    address = models.CharField(max_length=200)
    seed = models.CharField(max_length=64, default=new_seed)
    closed_at = models.DateTimeField(null=True)
    chosen = models.JSONField(default=dict)
    frozen_at = models.DateTimeField(null=True)
    frozen = models.JSONField(default=list)
    plays = models.BooleanField(default=False)
    played_at = models.DateTimeField(null=True)
    publish_at = models.DateTimeField(null=True)

    class Meta:
        ordering = ("-deadline", "-id")

    def __str__(self) -> str:
        return self.title

    @property
    def seed_hash(self) -> str:
        """The SHA-256 of the seed, which is shown from the beginning."""
        return seed_hash(self.seed)

    @property
    def teams(self) -> models.QuerySet[Team]:
        """The teams that play."""
        return Team.objects.filter(pk__in=[team for team, *_ in self.frozen]).order_by("pk")


class State(models.TextChoices):
    """Where a submission stands.

    ``unchecked`` is our fault and costs nothing; ``superseded``: a newer one came before its turn.
    """

    QUEUED = "queued"
    CHECKING = "checking"
    ACCEPTED = "accepted"
    REJECTED = "rejected"
    UNCHECKED = "unchecked", "not checked"
    SUPERSEDED = "superseded"


class Submission(models.Model):
    """What a team has handed in.

    Attributes:
        begun_at: when its upload began, which is what counts for a deadline.
        received_at: when it was on the disk and in the database.
        late_for: the last event for which it came too late.
        level: the verdict of the check; empty until there is one.
        report: the report of the check as JSON.
        is_counted: whether it counts for the quotas: not if it was our fault, superseded or known before.
    """

    team = models.ForeignKey(Team, on_delete=models.PROTECT)
    season = models.ForeignKey(Season, on_delete=models.PROTECT)
    number = models.PositiveIntegerField()
    sha256 = models.CharField(max_length=64, db_index=True)
    size_bytes = models.PositiveIntegerField()
    begun_at = models.DateTimeField()
    received_at = models.DateTimeField()
    via = models.CharField(max_length=10)
    is_late = models.BooleanField(default=False)
    late_for = models.ForeignKey(Event, on_delete=models.SET_NULL, null=True, blank=True)
    is_counted = models.BooleanField(default=True)
    state = models.CharField(max_length=12, choices=State.choices, default=State.QUEUED)
    level = models.CharField(max_length=10, blank=True)
    digest = models.CharField(max_length=64, blank=True)
    report = models.JSONField(null=True, blank=True)
    repaired_from = models.ForeignKey("self", on_delete=models.PROTECT, null=True, blank=True)
    is_deleted = models.BooleanField(default=False)

    class Meta:
        constraints = (models.UniqueConstraint(fields=("team", "season", "number"), name="one_number_a_season"),)
        ordering = ("-id",)

    def __str__(self) -> str:
        return f"{self.team} {self.number}"

    def replaces(self, active: Submission | None, chosen_over: int) -> bool:
        """Return whether it plays instead of another one of its team, once it is accepted.

        A late one does not replace one that was in time, nor an older one the team's own choice.
        """
        if active is None:
            return True
        return self.number > chosen_over and (not self.is_late, self.number) > (not active.is_late, active.number)


class Entry(models.Model):
    """A team's place in a season: which of its accepted submissions plays.

    Attributes:
        chosen_over: the last number there was when the team chose itself; only later submissions replace its choice.
    """

    team = models.ForeignKey(Team, on_delete=models.CASCADE)
    season = models.ForeignKey(Season, on_delete=models.CASCADE)
    active = models.ForeignKey(Submission, on_delete=models.PROTECT, null=True, blank=True)
    chosen_over = models.PositiveIntegerField(default=0)

    class Meta:
        constraints = (models.UniqueConstraint(fields=("team", "season"), name="one_entry_a_season"),)


class Basis(models.Model):
    """What the matches of a season are played with. If versions change, a new one is made, and all is played again.

    Attributes:
        scenario: hash of the scenario with all settings (`tournament.jobs`).
        versions: what decides the bits of a result besides scenario, programs and seed.
        is_whole: whether all matches of the basis before have been played again; until then, that one has the table.
    """

    season = models.ForeignKey(Season, on_delete=models.CASCADE)
    scenario = models.CharField(max_length=64)
    versions = models.JSONField()
    is_whole = models.BooleanField(default=True)
    made_at = models.DateTimeField()

    class Meta:
        ordering = ("-id",)

    def __str__(self) -> str:
        return f"{self.season}, from {self.made_at:%Y-%m-%d}"


class MatchKind(models.TextChoices):
    """Whether a match counts for the ladder."""

    RATED = "rated"
    PRACTICE = "practice"


class Match(models.Model):
    """A match of a ladder.

    Attributes:
        number: from 1 for each kind of a basis; with the season's secret it gives the seed.
        blue: whose programs begin on blue.
        yellow: whose programs begin on yellow.
        played_at: when it was over; None: it is in the queue.
        digest: of its record.
        faults: what programs did wrong, as in ``result.json`` but without details.
        is_doubtful: whether it ended differently when it was repeated because of a time limit.
        void: why it does not count; empty if it does.
    """

    basis = models.ForeignKey(Basis, on_delete=models.CASCADE)
    kind = models.CharField(max_length=8, choices=MatchKind.choices, default=MatchKind.RATED)
    number = models.PositiveIntegerField()
    blue = models.ForeignKey(Submission, on_delete=models.PROTECT, related_name="blue_matches")
    yellow = models.ForeignKey(Submission, on_delete=models.PROTECT, related_name="yellow_matches")
    seed = models.PositiveBigIntegerField()
    made_at = models.DateTimeField()
    played_at = models.DateTimeField(null=True, blank=True)
    blue_goals = models.FloatField(null=True, blank=True)
    yellow_goals = models.FloatField(null=True, blank=True)
    digest = models.CharField(max_length=64, blank=True)
    faults = models.JSONField(default=list, blank=True)
    is_doubtful = models.BooleanField(default=False)
    void = models.CharField(max_length=200, blank=True)

    class Meta:
        constraints = (models.UniqueConstraint(fields=("basis", "kind", "number"), name="one_match_a_number"),)
        ordering = ("-id",)

    def __str__(self) -> str:
        return f"match {self.number}" if self.kind == MatchKind.RATED else f"practice match {self.number}"


class Show(models.Model):
    """A match on the stage. Its times never change: spectators may be waiting for it.

    Attributes:
        begins_at: when its kick-off is shown.
        ends_at: when all has been shown, as planned: nothing may reveal before that a half ended early.
        is_chosen: whether an organizer put it there; what is there by itself gives way to that.
        goals: time in s from the beginning, half, tick, side and score of each.
    """

    match = models.ForeignKey(Match, on_delete=models.CASCADE)
    begins_at = models.DateTimeField()
    ends_at = models.DateTimeField(db_index=True)
    is_chosen = models.BooleanField()
    goals = models.JSONField()

    class Meta:
        ordering = ("begins_at",)

    def __str__(self) -> str:
        return f"{self.match} on the stage"


class JobState(models.TextChoices):
    """Where a job stands; ``stuck`` is an alarm on the organizers' desk."""

    QUEUED = "queued"
    RUNNING = "running"
    DONE = "done"
    STUCK = "stuck"


class Job(models.Model):
    """Work for a dispatcher, leased to one at a time.

    Attributes:
        key: what it does, so that nothing is done twice.
        attempt: how often it has been claimed; a result counts only with the number of its claim.
        tries: claims since it was put into the queue; after the last one it is stuck.
        lane_s: how long it has occupied a lane, in s.
    """

    kind = models.CharField(max_length=12)
    key = models.CharField(max_length=120, unique=True)
    submission = models.ForeignKey(Submission, on_delete=models.CASCADE, null=True, blank=True)
    match = models.ForeignKey(Match, on_delete=models.CASCADE, null=True, blank=True)
    event = models.ForeignKey(Event, on_delete=models.CASCADE, null=True, blank=True)
    team = models.ForeignKey(Team, on_delete=models.CASCADE, null=True, blank=True)
    priority = models.IntegerField(default=0)
    state = models.CharField(max_length=8, choices=JobState.choices, default=JobState.QUEUED)
    attempt = models.PositiveIntegerField(default=0)
    tries = models.PositiveIntegerField(default=0)
    worker = models.CharField(max_length=80, blank=True)
    lease_until = models.DateTimeField(null=True, blank=True)
    not_before = models.DateTimeField()
    created_at = models.DateTimeField()
    started_at = models.DateTimeField(null=True, blank=True)
    finished_at = models.DateTimeField(null=True, blank=True)
    lane_s = models.FloatField(default=0.0)
    progress = models.CharField(max_length=40, blank=True)
    error = models.CharField(max_length=400, blank=True)

    class Meta:
        indexes = (
            models.Index(fields=("state", "priority", "id")),
            models.Index(fields=("team", "started_at")),
        )

    def __str__(self) -> str:
        return self.key


class Worker(models.Model):
    """A dispatcher that has been seen."""

    name = models.CharField(max_length=80, unique=True)
    seen_at = models.DateTimeField()
    lanes = models.PositiveIntegerField()
    versions = models.JSONField(default=dict)


class Audit(models.Model):
    """What was done with consequences, its actor and reason; only ever added to."""

    at = models.DateTimeField()
    actor = models.CharField(max_length=60)
    act = models.CharField(max_length=40)
    about = models.CharField(max_length=120)
    reason = models.CharField(max_length=200, blank=True)
