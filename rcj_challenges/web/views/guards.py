"""Lets only those pass who may, and gives the rest the answer that shows nothing."""

from __future__ import annotations

from collections.abc import Callable
from functools import wraps
from typing import Concatenate, Literal, ParamSpec

from django.http import Http404, HttpRequest, HttpResponse, HttpResponseBase, HttpResponseNotAllowed
from django.shortcuts import redirect
from django.urls import reverse
from django.utils import timezone

from rcj_challenges.web.accounts import Viewer, viewer_of, write_audit
from rcj_challenges.web.models import Submission, Team

P = ParamSpec("P")
Audience = Literal["team", "mentor", "organizer"]
View = Callable[Concatenate[HttpRequest, Viewer, P], HttpResponseBase]


def only(
    audience: Audience, *, post: bool = False
) -> Callable[[View[P]], Callable[Concatenate[HttpRequest, P], HttpResponseBase]]:
    """Make a view for an audience, which is passed its viewer; others are sent to sign in.

    Args:
        audience: who may open it; an organizer may also open what is for mentors.
        post: whether it changes something, and so answers to POST only.
    """

    def decorate(view: View[P]) -> Callable[Concatenate[HttpRequest, P], HttpResponseBase]:
        @wraps(view)
        def guarded(request: HttpRequest, /, *args: P.args, **kwargs: P.kwargs) -> HttpResponseBase:
            viewer = viewer_of(request)
            if not _belongs(viewer, audience):
                return redirect(reverse("enter") if audience == "team" else reverse("login"))
            if post and request.method != "POST":
                return HttpResponseNotAllowed(["POST"])
            return view(request, viewer, *args, **kwargs)

        return guarded

    return decorate


def _belongs(viewer: Viewer, audience: Audience) -> bool:
    if audience == "team":
        return viewer.team is not None
    return viewer.is_organizer or (audience == "mentor" and viewer.group is not None)


def seen_submission(request: HttpRequest, pk: int) -> tuple[Viewer, Submission]:
    """Return a submission that the viewer may see.

    Raises:
        Http404: there is none, or the viewer may not know that there is.
    """
    viewer = viewer_of(request)
    found = Submission.objects.filter(pk=pk, is_deleted=False).select_related("team", "season", "late_for").first()
    if found is None or not viewer.may_see(found.team):
        raise Http404
    return viewer, found


def seen_team(viewer: Viewer, pk: int) -> Team:
    """Return a team that the viewer may see.

    Raises:
        Http404: there is none, or the viewer may not know that there is.
    """
    team = Team.objects.filter(pk=pk).select_related("group").first()
    if team is None or not viewer.may_see(team):
        raise Http404
    return team


def done(viewer: Viewer, act: str, about: object, page: str, reason: str = "") -> HttpResponseBase:
    """Note an act with consequences, and lead to the page that shows them."""
    write_audit(viewer, act, about, reason, timezone.now())
    return redirect(page)


def plain(text: str, status: int = 200) -> HttpResponse:
    """Return a text that no browser takes for anything else."""
    return HttpResponse(text, status=status, content_type="text/plain; charset=utf-8")
