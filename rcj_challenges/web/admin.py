"""The lists of organizers: search, and the settings of seasons. Nothing is deleted here."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from django.contrib import admin
from django.contrib.auth.models import Group as DjangoGroup
from django.http import HttpRequest

from rcj_challenges.web.models import Account, Audit, Group, Job, Match, Season, Submission, Team, Worker

if TYPE_CHECKING:
    from django.db.models import Model

    Base = admin.ModelAdmin[Model]
else:
    Base = admin.ModelAdmin


class Listed(Base):
    """A list that is only read."""

    def has_add_permission(self, request: HttpRequest) -> bool:
        """Return False: it is filled elsewhere."""
        return False

    def has_change_permission(self, request: HttpRequest, obj: Any = None) -> bool:
        """Return False: it is changed elsewhere."""
        return False


class SubmissionAdmin(Listed):
    """All that was handed in, with hashes and states."""

    list_display = (
        "id",
        "team",
        "number",
        "season",
        "state",
        "level",
        "is_late",
        "received_at",
        "size_bytes",
        "sha256",
    )
    list_filter = ("season", "state", "is_late")
    search_fields = ("sha256", "digest", "team__name", "team__group__label")
    list_select_related = ("team", "season")
    exclude = ("report",)


class TeamAdmin(Listed):
    """All teams."""

    list_display = ("id", "name", "group", "is_name_public", "last_used_at", "deleted_at")
    list_filter = ("group",)
    search_fields = ("name",)
    exclude = ("code_hmac",)


class JobAdmin(Listed):
    """All jobs."""

    list_display = ("id", "key", "team", "state", "tries", "worker", "created_at", "finished_at", "lane_s", "error")
    list_filter = ("state", "kind")
    search_fields = ("key",)


class SeasonAdmin(Base):
    """Seasons and their deadlines."""

    list_display = ("title", "scenario", "opens_at", "closes_at", "is_current", "begun_at", "ended_at")

    def get_readonly_fields(self, request: HttpRequest, obj: Any = None) -> tuple[str, ...]:
        """The settings that are pinned once the ladder has begun."""
        return ("scenario", "overrides", "ladder_overrides") if obj is not None and obj.begun_at is not None else ()


class MatchAdmin(Listed):
    """All matches of ladders."""

    list_display = ("basis", "kind", "number", "blue", "yellow", "played_at", "blue_goals", "yellow_goals", "void")
    list_filter = ("basis__season", "kind", "is_doubtful")
    list_select_related = ("basis__season", "blue__team", "yellow__team")


class AccountAdmin(Listed):
    """Accounts, without their passwords; one that is no longer active is signed out."""

    list_display = ("name", "role", "group", "is_active", "last_login")
    fields = ("name", "role", "group", "is_active")
    readonly_fields = ("name", "role", "group")

    def has_change_permission(self, request: HttpRequest, obj: Any = None) -> bool:
        """Return whether it may be made inactive."""
        return Base.has_change_permission(self, request, obj)


class GroupAdmin(Base):
    """Groups and how many teams each may have."""

    list_display = ("label", "quota", "meetings")


class AuditAdmin(Listed):
    """What was done with consequences."""

    list_display = ("at", "actor", "act", "about", "reason")
    search_fields = ("about", "actor")


admin.site.site_header = admin.site.site_title = "RCJ Challenges"
admin.site.unregister(DjangoGroup)
admin.site.register(Submission, SubmissionAdmin)
admin.site.register(Team, TeamAdmin)
admin.site.register(Job, JobAdmin)
admin.site.register(Season, SeasonAdmin)
admin.site.register(Match, MatchAdmin)
admin.site.register(Account, AccountAdmin)
admin.site.register(Group, GroupAdmin)
admin.site.register(Audit, AuditAdmin)
admin.site.register(Worker, Listed)
