"""A class signs in from one address, guesses cost nothing, and no page of another site acts for a team."""

from __future__ import annotations

import time
from datetime import timedelta
from itertools import product
from typing import Any

import pytest

from rcj_challenges.web.config import SiteConfig
from tests.web.club import make_submission, new_client
from tests.web.conftest import NOW, make_team, use_site

OWN = {"http": "http://localhost", "https": "https://localhost"}


def test_a_class_signs_in_from_one_address_though_some_mistype(site: SiteConfig):
    codes = [make_team(f"Team {number}")[1] for number in range(30)]
    began = time.process_time()
    for number, code in enumerate(codes):
        client = new_client(REMOTE_ADDR="192.0.2.7")
        for _ in range(3 if number % 6 == 0 else 0):
            assert client.post("/enter", {"code": code[:-1] + "?"}).status_code == 403
        assert client.post("/enter", {"code": code.lower().replace("-", " ")}).status_code == 302
        assert client.get("/my").status_code == 200
    assert time.process_time() - began < 10


@pytest.mark.parametrize("tries", [500, pytest.param(100_000, marks=pytest.mark.nightly)])
def test_wrong_codes_are_refused_without_hashing_a_password(
    site: SiteConfig, monkeypatch: pytest.MonkeyPatch, tries: int
):
    from rcj_challenges.web.accounts import Argon2, new_code, team_of_code

    _, code = make_team()
    began = time.process_time()
    Argon2().encode("password", "salt" * 4)
    hash_s = time.process_time() - began
    monkeypatch.setattr(Argon2, "encode", _never)
    monkeypatch.setattr(Argon2, "verify", _never)
    began = time.process_time()
    assert [team_of_code(new_code(), NOW) for _ in range(tries)] == [None] * tries
    assert (time.process_time() - began) / tries < hash_s / 10
    assert team_of_code(code, NOW) is not None


def _never(*_: Any) -> bool:
    raise AssertionError("a password was hashed")


def test_account_waits_longer_after_each_failure_and_others_do_not(site: SiteConfig, monkeypatch: pytest.MonkeyPatch):
    from rcj_challenges.web.accounts import signs_in
    from rcj_challenges.web.models import Account, Role

    monkeypatch.setattr(Account, "check_password", lambda _self, password: password == "right")
    for name in ("chief", "other"):
        Account.objects.create(name=name, role=Role.ORGANIZER, password="!")  # noqa: S106
    for failure in range(5):
        assert signs_in("chief", "wrong", NOW + timedelta(seconds=failure)) is None
    assert signs_in("chief", "right", NOW + timedelta(seconds=4.5)) is None
    assert signs_in("other", "right", NOW) is not None
    assert signs_in("chief", "right", NOW + timedelta(seconds=6)) is not None
    assert Account.objects.get(name="chief").failures == 0


def test_lists_of_organizers_have_no_sign_in_of_their_own(site: SiteConfig, monkeypatch: pytest.MonkeyPatch):
    from rcj_challenges.web.models import Account, Role

    monkeypatch.setattr(Account, "check_password", lambda *_: True)
    far = NOW.replace(year=2999)
    Account.objects.create(name="chief", role=Role.ORGANIZER, password="!", locked_until=far)  # noqa: S106
    answer = new_client().post("/admin/login/", {"name": "chief", "username": "chief", "password": "right"})
    assert answer.status_code == 403


def test_new_card_ends_the_old_code_and_its_sessions(site: SiteConfig):
    from rcj_challenges.web.accounts import give_card

    team, old = make_team()
    client = new_client()
    client.post("/enter", {"code": old})
    new = give_card(team)
    assert client.get("/my")["Location"] == "/enter"
    assert client.post("/enter", {"code": old}).status_code == 403
    assert client.post("/enter", {"code": new}).status_code == 302


@pytest.mark.parametrize("scheme", ["http", "https"])
def test_only_forms_of_this_site_are_taken(site: SiteConfig, scheme: str):
    team, code = make_team()
    submission = make_submission(site, team)
    client = new_client(enforce_csrf_checks=True)
    secure = scheme == "https"
    here = {"secure": secure, "headers": {"Referer": f"{OWN[scheme]}/my"}}
    client.get("/enter", **here)
    token = client.cookies["csrf"].value
    assert client.post("/enter", {"code": code, "csrfmiddlewaretoken": token}, **here).status_code == 302
    client.get("/my", **here)
    good = client.cookies["csrf"].value
    origins = (OWN[scheme], None, "null", "http://evil.example", OWN["http" if secure else "https"])
    sites = (None, "same-origin", "none", "same-site", "cross-site")
    for origin, fetch_site, token in product(origins, sites, (good, "")):
        given = {"Origin": origin, "Sec-Fetch-Site": fetch_site}
        headers = {name: value for name, value in given.items() if value is not None}
        answer = client.post(
            f"/my/submissions/{submission.pk}/activate", {"csrfmiddlewaretoken": token}, secure=secure, headers=headers
        )
        may_pass = token == good and fetch_site in {None, "same-origin", "none"}
        is_ours = origin == OWN[scheme] or (origin is None and not secure)
        # 409: a rejected submission cannot play, so the request has passed.
        assert answer.status_code == (409 if may_pass and is_ours else 403), (origin, fetch_site, token)


def test_pages_change_nothing_when_they_are_only_loaded(site: SiteConfig):
    team, code = make_team()
    submission = make_submission(site, team)
    client = new_client()
    client.post("/enter", {"code": code})
    for address in (
        "/my/upload",
        "/leave",
        *(f"/my/submissions/{submission.pk}/{act}" for act in ("repair", "activate")),
    ):
        assert client.get(address).status_code == 405
    assert client.get("/my").status_code == 200


def test_cookies_behind_https_are_sent_over_https_and_to_this_host_only(folder: Any):
    with use_site(folder(https=True)):
        _, code = make_team()
        client = new_client()
        client.post("/enter", {"code": code}, secure=True)
        client.get("/my", secure=True)
        assert set(client.cookies) == {"__Host-session", "__Host-csrf"}
        for cookie in client.cookies.values():
            assert cookie["secure"]
            assert cookie["httponly"]
            assert (cookie["path"], cookie["domain"], cookie["samesite"]) == ("/", "", "Lax")


def test_invitation_makes_one_account(site: SiteConfig):
    from django.utils import timezone

    from rcj_challenges.web.accounts import invite
    from rcj_challenges.web.models import Account, Role

    code = invite(Role.ORGANIZER, None, timezone.now())
    wanted = {"name": "chief", "password": "correct horse 7"}
    assert new_client().post(f"/invite/{code}", wanted)["Location"] == "/desk"
    assert new_client().post(f"/invite/{code}", {**wanted, "name": "second"}).status_code == 404
    assert list(Account.objects.values_list("name", "role")) == [("chief", "organizer")]
    assert new_client().post("/login", wanted)["Location"] == "/desk"


def test_guesses_at_the_same_moment_do_not_pass_the_wait(site: SiteConfig, monkeypatch: pytest.MonkeyPatch):
    from rcj_challenges.web.accounts import signs_in
    from rcj_challenges.web.models import Account, Role

    hashed: list[str] = []

    def check(_account: Account, password: str) -> bool:
        if len(hashed) < 20:
            hashed.append(password)
            signs_in("chief", f"{password}+", NOW)  # another request, while this one hashes
        return password == "right"

    monkeypatch.setattr(Account, "check_password", check)
    Account.objects.create(name="chief", role=Role.ORGANIZER, password="!")  # noqa: S106
    assert signs_in("chief", "wrong", NOW) is None
    assert len(hashed) == 5


def test_account_that_waits_answers_as_slowly_as_one_that_does_not_exist(
    site: SiteConfig, monkeypatch: pytest.MonkeyPatch
):
    from rcj_challenges.web.accounts import Argon2, signs_in
    from rcj_challenges.web.models import Account, Role

    hashed: list[str] = []
    monkeypatch.setattr(Argon2, "encode", lambda _self, password, _salt: hashed.append(password) or "!")
    far = NOW + timedelta(days=1)
    Account.objects.create(name="chief", role=Role.ORGANIZER, password="!", locked_until=far)  # noqa: S106
    for name in ("chief", "none"):
        assert signs_in(name, "guess", NOW) is None
    assert hashed == ["guess", "guess"]


def test_use_of_a_card_is_noted_once_a_minute(site: SiteConfig):
    from rcj_challenges.web.accounts import team_of_code

    team, code = make_team()
    for after_s, noted_s in ((0, 0), (59, 0), (61, 61)):
        assert team_of_code(code, NOW + timedelta(seconds=after_s)) is not None
        team.refresh_from_db()
        assert team.last_used_at == NOW + timedelta(seconds=noted_s)
