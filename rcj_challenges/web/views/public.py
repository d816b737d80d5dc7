"""Pages for all: what is on, signing in and out, and the state of the site."""

from __future__ import annotations

from importlib.resources import files

from django.contrib.auth import login as start_session
from django.contrib.auth import logout as end_session
from django.contrib.auth.password_validation import validate_password
from django.core.exceptions import ValidationError
from django.db import DatabaseError, IntegrityError
from django.http import HttpRequest, HttpResponse, HttpResponseBase, JsonResponse
from django.shortcuts import redirect
from django.utils import timezone
from django.utils.translation import gettext
from django.views.decorators.http import require_GET, require_http_methods, require_POST

from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.web import jobs, seasons
from rcj_challenges.web.accounts import enter as sign_in_team
from rcj_challenges.web.accounts import open_invite, signs_in, team_of_code
from rcj_challenges.web.models import Account, Entry, Event, Invite, Job, JobState, Role, Worker
from rcj_challenges.web.pages import message_page, page


@require_GET
def home(request: HttpRequest) -> HttpResponse:
    """Show what is on, and who takes part."""
    season = seasons.current()
    found = Entry.objects.filter(season=season, active__isnull=False, team__deleted_at=None)
    entries = found.select_related("team__group").order_by("team__pk")
    open_events = Event.objects.filter(played_at=None).order_by("deadline")
    return page(request, "home.html", season=season, entries=entries, events=open_events, now=timezone.now())


@require_GET
def style(_request: HttpRequest) -> HttpResponse:
    """Return the style sheet: that of published tournaments, and what this site adds."""
    shared = files("rcj_challenges.tournament.site").joinpath("templates/style.css").read_text("utf-8")
    own = files("rcj_challenges.web").joinpath("static/site.css").read_text("utf-8")
    return HttpResponse(shared + own, content_type="text/css; charset=utf-8", headers={"Cache-Control": "max-age=300"})


@require_http_methods(["GET", "HEAD", "POST"])
def enter(request: HttpRequest) -> HttpResponseBase:
    """Sign in with the code of a card. The QR code on it has the code behind #, which no server and no log sees."""
    if request.method == "POST":
        team = team_of_code(request.POST.get("code", "")[:60], timezone.now())
        if team is not None:
            sign_in_team(request, team)
            return redirect("my")
        return page(
            request, "enter.html", status=403, error=gettext("This code is not on any card. Compare it with yours.")
        )
    return page(request, "enter.html", error="")


@require_http_methods(["GET", "HEAD", "POST"])
def login(request: HttpRequest) -> HttpResponseBase:
    """Sign in as a mentor or an organizer."""
    if request.method == "POST":
        account = signs_in(
            sanitize(request.POST.get("name", ""), 40), request.POST.get("password", "")[:200], timezone.now()
        )
        if account is not None:
            request.session.pop("team", None)
            start_session(request, account)
            return redirect("desk" if account.role == Role.ORGANIZER else "group")
        error = gettext("Name and password do not fit. After five failures, the account waits before each further try.")
        return page(request, "login.html", status=403, error=error)
    return page(request, "login.html", error="")


@require_POST
def leave(request: HttpRequest) -> HttpResponseBase:
    """Sign out."""
    end_session(request)
    return redirect("home")


@require_http_methods(["GET", "HEAD", "POST"])
def invited(request: HttpRequest, code: str) -> HttpResponseBase:
    """Make an account by an invitation, which works once."""
    now = timezone.now()
    found = open_invite(code, now)
    if found is None:
        return message_page(request, 404, gettext("This link has been used or is too old. Ask for a new one."))
    error = ""
    if request.method == "POST":
        name, password = sanitize(request.POST.get("name", "").strip(), 40), request.POST.get("password", "")[:200]
        try:
            validate_password(password)
            if not name:
                raise ValidationError(gettext("Choose a name."))
            with jobs.writing():
                account = Account.objects.create_account(name, password, Role(found.role), found.group)
                if not Invite.objects.filter(pk=found.pk, used_at=None).update(used_at=now):
                    raise ValidationError(gettext("This link has been used."))
        except ValidationError as problem:
            error = " ".join(problem.messages)
        except IntegrityError:
            error = gettext("This name is taken.")
        else:
            start_session(request, account)
            return redirect("desk" if account.role == Role.ORGANIZER else "group")
    return page(request, "invited.html", status=400 if error else 200, role=found.role, group=found.group, error=error)


@require_GET
def privacy(request: HttpRequest) -> HttpResponse:
    """Show what the site keeps, and for how long."""
    return page(request, "privacy.html")


@require_GET
def help_page(request: HttpRequest) -> HttpResponse:
    """Show how to hand in."""
    return page(request, "help.html")


def not_found(request: HttpRequest, exception: Exception) -> HttpResponse:
    """Show that there is no such page, or none for this viewer."""
    return message_page(request, 404, gettext("Or it is not for you to see."), gettext("There is no such page"))


@require_GET
def healthz(_request: HttpRequest) -> JsonResponse:
    """Return whether the site works, for watchdogs."""
    now = timezone.now()
    try:
        worker = Worker.objects.order_by("-seen_at").first()
        oldest = Job.objects.filter(state=JobState.QUEUED).order_by("created_at").first()
        stuck = Job.objects.filter(state=JobState.STUCK).count()
    except DatabaseError:
        return JsonResponse({"ok": False, "database": False}, status=503)
    seen_s = None if worker is None else round((now - worker.seen_at).total_seconds(), 1)
    is_alive = seen_s is not None and seen_s < jobs.LEASE.total_seconds()
    waits_s = None if oldest is None else round((now - oldest.created_at).total_seconds(), 1)
    state = {"ok": is_alive, "database": True, "dispatcher_seen_s": seen_s, "oldest_job_s": waits_s, "stuck": stuck}
    return JsonResponse(state, status=200 if is_alive else 503)
