"""The stage: what is planned, what all see, and that no byte is sent before its time."""

from __future__ import annotations

import asyncio
import itertools
import json
import math
import re
import shutil
import struct
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from datetime import timedelta
from pathlib import Path
from typing import Any

import pytest

from rcj_challenges.core.timing import TICK_S
from rcj_challenges.views.live.feed import KEEP_ALIVE
from rcj_challenges.views.live.recorded import STEP_S
from rcj_challenges.views.replay import write_replay
from rcj_challenges.web import seasons, stage
from rcj_challenges.web.blobs import record_folder, stage_folder
from rcj_challenges.web.config import SiteConfig
from rcj_challenges.web.front import Front
from rcj_challenges.web.models import Audit, Match, Show
from tests.made_up_runs import write_made_up_run
from tests.web.club import Club, make_club, make_match
from tests.web.conftest import NOW

BREAK_S = 30.0
TICKS = 410
LENGTH_S = math.ceil((2 * TICKS * TICK_S + BREAK_S) / STEP_S) * STEP_S


@pytest.fixture(scope="module")
def replay(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the replay of a short match without physics."""
    return write_replay(write_made_up_run(tmp_path_factory.mktemp("run") / "run", ticks=TICKS))


@pytest.fixture
def club(site: SiteConfig, replay: Path) -> Club:
    """Return a club whose only rated match has a replay."""
    made = make_club(site)
    shutil.copy(replay, record_folder(site.folder, made.rated))
    return made


def another_match(config: SiteConfig, replay: Path, blue: Any, yellow: Any) -> Any:
    made = make_match(config, blue, yellow, number=Match.objects.count() + 1)
    shutil.copy(replay, record_folder(config.folder, made))
    return made


def put(match: Any, after_s: float = 0.0, *, is_chosen: bool = True) -> Show:
    found = Match.objects.get(pk=match.pk)
    show = stage.schedule(found, NOW + timedelta(seconds=after_s), NOW, is_chosen=is_chosen)
    assert show is not None
    return show


def seconds(show: Show) -> tuple[float, float]:
    """Return when a show begins and ends, in s from now."""
    return (show.begins_at - NOW).total_seconds(), (show.ends_at - NOW).total_seconds()


# --- the feed ---------------------------------------------------------------------------------------------------------


class Spectator:
    """A connection to the front; the time passes only while it waits.

    Args:
        config: of the site.
        at_s: the time, in s since 1970.
    """

    def __init__(self, config: SiteConfig, at_s: float) -> None:
        self.now_s = at_s
        self.received: list[tuple[float, bytes]] = []
        self.status = 0
        self.is_gone = False
        self._front = Front(self._no_page, config, lambda: self.now_s)

    async def _no_page(self, *_: Any) -> None:
        raise AssertionError("the feed is sent without Django")

    def watch(self, show: Show, monkeypatch: pytest.MonkeyPatch, query: str = "from=0") -> bytes:
        """Watch to the end; return all bytes."""
        scope = {"type": "http", "method": "GET", "path": f"/live/{show.pk}/feed", "query_string": query.encode(),
                 "headers": []}  # fmt: skip

        async def wait(some: Any, **until: float) -> Any:
            await asyncio.sleep(0)
            self.now_s += until["timeout"] * 0.7 + 1e-3  # a timer that wakes up too early
            return (set(some) if self.is_gone else set()), set()

        monkeypatch.setattr(asyncio, "wait", wait)
        with ThreadPoolExecutor(1) as apart:  # a browser of other tests may run a loop in this thread
            apart.submit(lambda: asyncio.run(self._front(scope, self._receive, self._send))).result()
        return b"".join(body for _, body in self.received if body != KEEP_ALIVE)

    async def _receive(self) -> Any:
        await asyncio.Event().wait()

    async def _send(self, message: Any) -> None:
        if message["type"] == "http.response.start":
            self.status = message["status"]
        else:
            self.received.append((self.now_s, message["body"]))


def happenings(data: bytes, entities: int = 7) -> Iterator[tuple[int, float]]:
    """Yield the end of each message of a feed, and when what it says happens, in s from the beginning."""
    at = 0
    while at < len(data):
        kind, length = struct.unpack_from("<BI", data, at)
        body = data[at + 5 : at + 5 + length]
        at += 5 + length
        if kind == 2:
            half, first = struct.unpack_from("<HI", body)
            tick = first + (len(body) - 6) // (2 * 5 * entities) - 1
        elif kind == 1:
            said = json.loads(body)
            half, tick = (
                (2, TICKS) if said["say"] == "over" else ((said.get("facts") or said)["half"], said.get("tick", 0))
            )
        else:
            continue
        yield at, (half - 1) * (TICKS * TICK_S + BREAK_S) + tick * TICK_S


def test_no_byte_is_sent_before_the_clock_of_the_server_says_so(
    club: Club, site: SiteConfig, monkeypatch: pytest.MonkeyPatch
) -> None:
    show = put(club.rated)
    begins_s = show.begins_at.timestamp()
    early = Spectator(site, begins_s - 12.0)
    whole = early.watch(show, monkeypatch)
    assert whole == (stage_folder(site.folder) / str(show.pk) / "feed").read_bytes()
    assert early.received[0][1] == KEEP_ALIVE  # it is not cut off while it waits
    assert early.received[0][0] == pytest.approx(begins_s - 7, abs=3)
    sent = [(at_s - begins_s, body) for at_s, body in early.received if body and body != KEEP_ALIVE]
    due = dict(happenings(whole))
    total = 0
    for at_s, body in sent:
        total += len(body)
        assert max(happens_s for end, happens_s in due.items() if end <= total) <= at_s + 1e-6
    assert len(sent) == len(
        set(json.loads((stage_folder(site.folder) / str(show.pk) / "release.json").read_text("utf-8"))["ends"])
    )
    assert sent[-1][0] == pytest.approx(LENGTH_S, abs=STEP_S)


def test_latecomer_gets_what_was_shown_at_once_and_then_what_all_get(
    club: Club, site: SiteConfig, monkeypatch: pytest.MonkeyPatch
) -> None:
    show = put(club.rated)
    begins_s = show.begins_at.timestamp()
    early, late = Spectator(site, begins_s), Spectator(site, begins_s + 1.6)
    whole = early.watch(show, monkeypatch)
    assert late.watch(show, monkeypatch) == whole
    before = b"".join(body for at_s, body in early.received if at_s < begins_s + 1.6)
    assert late.received[0] == (begins_s + 1.6, before)
    again = Spectator(site, begins_s + 1.6)
    assert again.watch(show, monkeypatch, f"match=&from={len(before)}") == whole[len(before) :]
    assert again.received[0][0] > begins_s + 1.6
    over = Spectator(site, begins_s + 1e6)
    assert (over.watch(show, monkeypatch), over.status) == (whole, 200)


def test_clock_that_is_set_back_stops_the_feed_and_not_the_server(
    club: Club, site: SiteConfig, monkeypatch: pytest.MonkeyPatch
) -> None:
    show = put(club.rated)
    one = Spectator(site, show.begins_at.timestamp() + 3.0)
    send, waited = one._send, list[float]()

    async def and_set_back(message: Any) -> None:
        await send(message)
        if len(one.received) == 1 and not waited:
            waited.append(one.now_s)
            one.now_s -= 2.2
            calls = itertools.count()
            one._front._stream._clock = lambda: one.now_s if next(calls) < 1000 else pytest.fail("it does not wait")

    monkeypatch.setattr(one, "_send", and_set_back)
    assert one.watch(show, monkeypatch) == (stage_folder(site.folder) / str(show.pk) / "feed").read_bytes()
    assert waited
    assert one.received[1][0] > waited[0]


def test_what_asks_for_no_feed_is_refused(club: Club, site: SiteConfig, monkeypatch: pytest.MonkeyPatch) -> None:
    show = put(club.rated)
    for query in ("from=x", "from=-1", "from=1" + 20 * "0", "from=\u0661"):
        asked = Spectator(site, NOW.timestamp())
        assert (asked.watch(show, monkeypatch, query), asked.status) == (b"", 400)
    ahead = Spectator(site, show.begins_at.timestamp())
    whole = (stage_folder(site.folder) / str(show.pk) / "feed").read_bytes()
    assert ahead.watch(show, monkeypatch, f"from={len(whole) - 1}") == whole  # no look ahead
    stage.take_off(Show.objects.filter(pk=show.pk))
    gone = Spectator(site, NOW.timestamp())
    assert (gone.watch(show, monkeypatch), gone.status) == (b"", 409)


def test_feed_ends_with_its_reader_and_when_the_match_is_taken_off(
    club: Club, site: SiteConfig, monkeypatch: pytest.MonkeyPatch
) -> None:
    show = put(club.rated)
    one = Spectator(site, show.begins_at.timestamp() + 0.6)
    one.is_gone = True
    one.watch(show, monkeypatch)
    assert len(one.received) == 1
    other = Spectator(site, show.begins_at.timestamp() + 0.6)
    send = other._send

    async def and_take_off(message: Any) -> None:
        await send(message)
        shutil.rmtree(stage_folder(site.folder) / str(show.pk), ignore_errors=True)

    monkeypatch.setattr(other, "_send", and_take_off)
    other.watch(show, monkeypatch)
    assert [bool(body) for _, body in other.received] == [False] or len(other.received) <= 2


# --- the list ---------------------------------------------------------------------------------------------------------


def test_matches_follow_each_other_with_a_pause_and_fill_gaps(club: Club) -> None:
    pause = stage.PAUSE.total_seconds()
    lead = stage.LEAD.total_seconds()
    first, second = put(club.rated), put(club.rated)
    assert seconds(first)[0] == lead
    assert seconds(first)[1] == pytest.approx(lead + LENGTH_S)
    assert seconds(second)[0] == pytest.approx(lead + LENGTH_S + pause)
    later = put(club.rated, 3600.0)
    assert seconds(later)[0] == 3600.0
    assert seconds(put(club.rated))[0] == pytest.approx(lead + 2 * (LENGTH_S + pause))
    assert seconds(put(club.rated, 3600.0 - LENGTH_S))[0] == pytest.approx(3600.0 + LENGTH_S + pause)


def test_stage_fills_itself_with_the_closest_ratings_of_what_was_shown_least(
    club: Club, site: SiteConfig, replay: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    own, foreign = club.rated.blue, club.rated.yellow
    same = another_match(site, replay, own, own)
    far = another_match(site, replay, own, foreign)
    values = {own.digest: 1000, foreign.digest: 1100}
    fitted = type("Fitted", (), {"value_of": staticmethod(values.__getitem__)})
    monkeypatch.setattr(stage, "standings_of", lambda _: type("Standings", (), {"fitted": fitted, "playing": values}))
    shown = []
    now = NOW
    for _ in range(4):
        show = stage.fill(now)
        assert show is not None
        assert stage.fill(now) is None  # one waits
        shown.append(show.match_id)
        now = show.begins_at
    assert shown[0] == shown[3] == same.pk
    assert set(shown[1:3]) == {club.rated.pk, far.pk}


def test_what_an_organizer_chooses_takes_the_place_of_what_came_by_itself(club: Club, site: SiteConfig) -> None:
    automatic = stage.fill(NOW)
    assert automatic is not None
    chosen = put(club.rated)
    assert chosen.begins_at == automatic.begins_at
    assert [show.pk for show in Show.objects.all()] == [chosen.pk]
    assert [path.name for path in stage_folder(site.folder).iterdir()] == [str(chosen.pk)]
    following = stage.fill(NOW)
    assert following is not None
    assert following.begins_at == chosen.ends_at + stage.PAUSE


def test_organizer_puts_matches_on_the_stage_and_takes_them_off(club: Club, site: SiteConfig) -> None:
    organizer = club.clients["organizer"]
    page = organizer.get("/desk/stage").content.decode()
    assert f'formaction="/desk/matches/{club.rated.pk}/stage"' in page
    later = (NOW.replace(year=2100)).strftime("%Y-%m-%dT%H:%M")
    for after in ("", later):
        answer = organizer.post(f"/desk/matches/{club.rated.pk}/stage", {"after": after})
        assert (answer.status_code, answer["Location"]) == (302, "/desk/stage")
    shows = list(Show.objects.all())
    assert [show.is_chosen for show in shows] == [True, True]
    assert shows[1].begins_at == NOW.replace(year=2100)
    assert organizer.post(f"/desk/matches/{club.practice['own'].pk}/stage").status_code == 404
    assert organizer.post(f"/desk/matches/{club.rated.pk}/stage", {"after": "2100-99-99T00:00"}).status_code == 409
    assert organizer.post(f"/desk/matches/{club.rated.pk}/stage", {"after": "9999-12-31T23:59:50"}).status_code == 409
    assert organizer.post(f"/desk/stage/{shows[0].pk}/take-off").status_code == 302
    assert [show.pk for show in Show.objects.all()] == [shows[1].pk]
    assert not (stage_folder(site.folder) / str(shows[0].pk)).exists()
    assert [one.act for one in Audit.objects.order_by("pk")][-3:] == ["put on stage", "put on stage", "take off stage"]
    shutil.rmtree(record_folder(site.folder, club.rated))
    assert organizer.post(f"/desk/matches/{club.rated.pk}/stage").status_code == 409


def test_deleted_team_is_on_no_stage_and_files_of_what_was_shown_go(club: Club, site: SiteConfig) -> None:
    show, folder = put(club.rated), stage_folder(site.folder)
    stage.drop_shown(show.ends_at)
    assert (folder / str(show.pk) / "feed").exists()
    seasons.forget(club.teams["foreign"])
    assert (Show.objects.count(), list(folder.iterdir())) == (0, [])
    (folder / "new-left").mkdir()
    stage.drop_shown(NOW.replace(year=2100))
    assert list(folder.iterdir()) == []


# --- the pages --------------------------------------------------------------------------------------------------------


def test_page_shows_what_is_on_what_comes_and_the_goals_that_all_have_seen(
    club: Club, site: SiteConfig, monkeypatch: pytest.MonkeyPatch
) -> None:
    from django.utils import timezone

    client = club.clients["anonymous"]
    assert "iframe" not in client.get("/live").content.decode()
    first, second = put(club.rated), put(club.rated)
    goal_s = first.goals[0][0]
    seen = {}
    for name, at in (("before", first.begins_at - timedelta(seconds=5)), ("early", first.begins_at + timedelta(seconds=goal_s)),
                     ("on", first.ends_at - timedelta(seconds=1)), ("between", first.ends_at + timedelta(seconds=3)),
                     ("later", second.ends_at + timedelta(hours=2))):  # fmt: skip
        monkeypatch.setattr(timezone, "now", lambda at=at: at)
        seen[name] = client.get("/live").content.decode()
    assert len(first.goals) == 2  # the second one just before the end
    assert 'data-begins-ms="5000"' in seen["before"]
    for name, shown, goals in (
        ("before", first, 0),
        ("early", first, 0),
        ("on", first, 1),
        ("between", second, len(first.goals)),
    ):
        assert f'src="/live/{shown.pk}/page"' in seen[name], name
        assert len(re.findall(r"<strong>\d+ : \d+</strong>", seen[name])) == goals, name
        assert ("/replay#h1t" in seen[name]) == (name == "between"), name
    assert "iframe" not in seen["later"]
    again_s = {name: int(re.findall(r'data-again-ms="(\d+)"', body)[0]) / 1000 for name, body in seen.items()}
    assert again_s["before"] == (first.ends_at - first.begins_at).total_seconds() + 5 + 15
    assert (again_s["on"], again_s["later"]) == (1 + 15, 60)
    monkeypatch.setattr(timezone, "now", lambda: first.begins_at - timedelta(hours=1))
    assert 'data-again-ms="60000"' in client.get("/live").content.decode()  # an organizer may choose another one
    monkeypatch.setattr(timezone, "now", lambda: first.begins_at)
    bare = client.get("/live?stage=1").content.decode()
    assert f'src="/live/{first.pk}/page?stage"' in bare
    assert '<body class="bare">' in bare


def test_page_of_a_match_has_an_origin_of_its_own_and_knows_nothing_of_it(club: Club, site: SiteConfig) -> None:
    show = put(club.rated)
    answer = club.clients["anonymous"].get(f"/live/{show.pk}/page")
    policy = dict(one.strip().partition(" ")[::2] for one in answer["Content-Security-Policy"].split(";"))
    assert policy["sandbox"] == "allow-scripts"
    assert (policy["connect-src"], policy["frame-ancestors"], policy["default-src"]) == ("'self'", "'self'", "'none'")
    facts = json.loads(answer.getvalue().decode().partition('id="facts">')[2].partition("</script>")[0])
    assert (facts["halves"], facts["events"], facts["places"]) == ([], [], [])
    assert [team.get("logo") for team in facts["teams"]] == [None, None]
    assert "frame-src 'self'" in club.clients["anonymous"].get("/live")["Content-Security-Policy"]
