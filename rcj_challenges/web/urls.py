"""The addresses of the site."""

from django.contrib import admin
from django.urls import path

from rcj_challenges.web.api import api
from rcj_challenges.web.views import desk, events, ladder, mentor, organize, practice, public, team

handler404 = public.not_found
urlpatterns = [
    path("", public.home, name="home"),
    path("style.css", public.style, name="style"),
    path("enter", public.enter, name="enter"),
    path("login", public.login, name="login"),
    path("leave", public.leave, name="leave"),
    path("invite/<str:code>", public.invited, name="invited"),
    path("privacy", public.privacy, name="privacy"),
    path("help", public.help_page, name="help"),
    path("healthz", public.healthz, name="healthz"),
    path("ladder", ladder.ladder, name="ladder"),
    path("seasons/<int:pk>", ladder.ladder, name="season"),
    path("teams/<int:pk>", ladder.team, name="ladder_team"),
    path("matches/<int:pk>", ladder.match, name="match"),
    path("matches/<int:pk>/replay", ladder.match_replay, name="match_replay"),
    path("matches/<int:pk>/log/<str:robot>", ladder.match_log, name="match_log"),
    path("matches/<int:pk>/again", ladder.match_again, name="match_again"),
    path("events", events.all_events, name="events"),
    path("events/<int:pk>", events.event, name="event"),
    path("events/<int:pk>/hashes.txt", events.hashes, name="event_hashes"),
    path("my", team.my, name="my"),
    path("my/upload", team.upload, name="upload"),
    path("my/submissions/<int:pk>", team.submission, name="submission"),
    path("my/submissions/<int:pk>/state", team.submission_state, name="submission_state"),
    path("my/submissions/<int:pk>/report", team.report, name="report"),
    path("my/submissions/<int:pk>/archive", team.archive, name="archive"),
    path("my/submissions/<int:pk>/repair", team.repair, name="repair"),
    path("my/submissions/<int:pk>/activate", team.activate, name="activate"),
    path("my/submissions/<int:pk>/<str:name>", team.replay, name="replay"),
    path("my/practice", practice.practice, name="practice"),
    path("my/practice/new", practice.new_practice, name="new_practice"),
    path("my/practice/allow", practice.allow_practice, name="allow_practice"),
    path("group", mentor.group, name="group"),
    path("group/teams/new", mentor.new_teams, name="new_teams"),
    path("group/teams/<int:pk>", mentor.team, name="team"),
    path("group/teams/<int:pk>/card", mentor.new_card, name="new_card"),
    path("group/teams/<int:pk>/delete", mentor.delete_team, name="delete_team"),
    path("desk", desk.desk, name="desk"),
    path("desk/jobs/<int:pk>/again", desk.job_again, name="job_again"),
    path("desk/matches/<int:pk>/void", desk.void_match, name="void_match"),
    path("desk/teams/<int:pk>/release", desk.release_name, name="release_name"),
    path("desk/season", desk.change_season, name="change_season"),
    path("desk/events/new", organize.new_event, name="new_event"),
    path("desk/events/<int:pk>", organize.desk_event, name="desk_event"),
    path("desk/events/<int:pk>/change", organize.change_event, name="change_event"),
    path("desk/invite", desk.new_invite, name="new_invite"),
    path("desk/export", desk.export, name="export"),
    path("admin/login/", public.login),  # Django's own has no back-off
    path("admin/", admin.site.urls),
    path("api/v1/", api.urls),
]
