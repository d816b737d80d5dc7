"""What no type says of a word: which keys exclude each other, whose counter it is, which values a draw has.

Each function puts a made-up mapping in order. What still does not fit is refused by the loader, which is a test too.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from rcj_challenges.rules.actions.count import Count
from rcj_challenges.rules.actions.draw import DrawAction
from rcj_challenges.rules.actions.place import Place
from rcj_challenges.rules.actions.reset import Reset
from rcj_challenges.rules.actions.score import Score
from rcj_challenges.rules.actions.set_flag import SetFlag
from rcj_challenges.rules.actions.timer import TimerAction
from rcj_challenges.rules.conditions import CONDITIONS
from rcj_challenges.rules.triggers.event import OnEvent
from rcj_challenges.rules.triggers.sequence_broken import SequenceBroken
from rcj_challenges.rules.triggers.sequence_completed import SequenceCompleted
from rcj_challenges.rules.values import FOLDS
from rcj_challenges.rules.values.count import CountValue
from rcj_challenges.rules.values.counter import CounterValue
from rcj_challenges.rules.values.entity import FactValue
from rcj_challenges.rules.values.flag import FlagValue
from rcj_challenges.rules.values.highest import HighestValue
from rcj_challenges.rules.values.lowest import LowestValue
from rcj_challenges.rules.values.sum import SumValue
from rcj_challenges.rules.values.timer import TimerValue
from rcj_challenges.rules.values.word import NumberWord, WordValue
from rcj_challenges.scenario.models import places, scenario

if TYPE_CHECKING:
    from tests.whole_scenarios.making import Maker

Data = dict[str, Any]
_PARTS = (
    "{entity}",
    "{each}",
    "{other}",
    "{team}",
    "{measured}",
    "{limit}",
    "{points}",
    "{goal_points}",
    "{p_1}",
    "{}",
)


def sentence(maker: Maker) -> str:
    """Return what a rule says."""
    words = [
        maker.chance.choice((*_PARTS, "goes", "off", "the", "field.", "Ä", "<i>", "*so*", "|", "`x`", "\u200b", "{{"))
        for _ in range(maker.chance.randrange(1, 7))
    ]
    return " ".join(words)


_BOUNDS = ("at_least", "at_most", "above", "below", "equals")


def _kept_each(key: str) -> Callable[[Maker, Data], None]:
    def fit(maker: Maker, data: Data) -> None:
        per = maker.stage.kept.get((key, data[key]))
        owners = () if per is None else maker.stage.groups.get(per, (per,))
        data.pop("entity", None)
        if per is None:
            data.pop("of", None)
            return
        if maker.each and set(maker.each) <= set(owners):
            data["entity"] = "each"
        elif maker.each or maker.chance.random() < 0.6:
            data["entity"] = maker.chance.choice(owners) if owners else per

    return fit


def _compared(maker: Maker, data: Data) -> None:
    given = [key for key in _BOUNDS if key in data]
    for key in given[1:]:
        del data[key]
    if not given:
        data[maker.chance.choice(("at_least", "at_most"))] = maker.chance.choice((0, 0.1, 1, 2))
    if isinstance(data.get("of"), dict):
        data["of"] = {"at_least": 1}


def _both(*fits: Callable[[Maker, Data], None]) -> Callable[[Maker, Data], None]:
    def fit(maker: Maker, data: Data) -> None:
        for one in fits:
            one(maker, data)

    return fit


def _reset(maker: Maker, data: Data) -> None:
    """Keep one of what is reset: not all of it is kept for the same."""
    key = next((one for one in ("sequence", "flag", "counter") if one in data), "counter")
    names = data.get(key) or maker.field(Reset, key)
    for one in ("flag", "counter"):
        data.pop(one, None)
    data[key] = names if isinstance(names, str) else names[0]
    _kept_each(key)(maker, data)


def _one_bound(maker: Maker, data: Data) -> None:
    given = [key for key in _BOUNDS if key in data]
    for key in given[1:]:
        del data[key]


def _of_one(_maker: Maker, data: Data) -> None:
    data.pop("of", None)


def _lengthens(_maker: Maker, data: Data) -> None:
    if "s" in data or data.get("do") == "add":
        data |= {"do": "add", "s": data.get("s", 2)}


def _told_is(maker: Maker, data: Data) -> None:
    _one_bound(maker, data)
    if any(key in data for key in _BOUNDS):
        data.pop("text", None)


def _fact_is(maker: Maker, data: Data) -> None:
    if not any(key in data for key in ("in", "touching", "held", "looks")):
        data["held"] = True
    if isinstance(data.get("of"), dict):
        data["of"] = {"at_least": 1}


def _place(maker: Maker, data: Data) -> None:
    if "layout" in data and maker.chance.random() < 0.5:
        for key in ("entity", "at", "kick"):
            data.pop(key, None)
        return
    data.pop("layout", None)
    _kick(maker, data)
    for key in ("entity", "at"):
        if key not in data:
            data[key] = maker.field(Place, key)


def _kick(maker: Maker, data: Data) -> None:
    """Let only balls roll."""
    if "kick" in data:
        balls = [name for name, kind in maker.stage.kinds.items() if kind == "ball"]
        if balls:
            data["entity"] = maker.chance.choice(balls)
        else:
            del data["kick"]
        speed = data.get("kick", {}).get("speed_mps")
        if isinstance(speed, list):
            data["kick"]["speed_mps"] = sorted(speed)


def _bounded(maker: Maker, data: Data) -> None:
    if "keeps_at_least" in data and "keeps_at_most" in data:
        data["keeps_at_least"], data["keeps_at_most"] = sorted((data["keeps_at_least"], data["keeps_at_most"]))


def _count(maker: Maker, data: Data) -> None:
    if "to" in data:
        for key in ("by", "keeps_at_least", "keeps_at_most"):
            data.pop(key, None)


def _drawn(key: str) -> Callable[[Maker, Data], None]:
    def fit(maker: Maker, data: Data) -> None:
        if key in data:
            values = maker.stage.draws[data["draw"]]
            known = [
                name for name in ("each", "other") if (members := getattr(maker, name)) and set(members) <= set(values)
            ]
            data[key] = maker.chance.choice(known or values)

    return fit


def _sequence_at(maker: Maker, data: Data) -> None:
    data["equals"] = maker.chance.choice(maker.stage.steps[data["sequence"]])


def _event(maker: Maker, data: Data) -> None:
    if "entity" in data and maker.each:
        data["entity"] = "each"


def _word(maker: Maker, data: Data) -> None:
    if data["word"] not in ("score", "team_name"):
        data.pop("of", None)


def _folded(key: str) -> Callable[[Maker, Data], None]:
    def fit(maker: Maker, data: Data) -> None:
        several = data[key]
        if isinstance(several, dict) and maker.stage.kept.get(("counter", several.get("counter"))):
            data[key] = {"counter": several["counter"]}
        elif isinstance(several, dict):
            data[key] = [several]

    return fit


def _counted(_maker: Maker, data: Data) -> None:
    data.pop("flag", None)


def _expected(maker: Maker, data: Data) -> None:
    at_s = 0.0
    for frame in data["keyframes"]:
        at_s = frame["at_s"] = round(at_s + maker.chance.choice((0, 0.032, 0.5)) + 0.001, 3)
    data["lasts_s"] = round(at_s + maker.chance.choice((0.032, 0.5, 1)), 3)
    data.pop("half", None)
    for event in data.get("events", ()):
        event.pop("at_s", None)
    for key in ("draws", "spots", "ranking", "told"):
        if maker.chance.random() < 0.7:
            data.pop(key, None)
    for name in data.get("draws", {}):
        data["draws"][name] = maker.chance.choice({**maker.stage.draws, **maker.stage.roles}[name])
    for section in (data, data.get("given", {})):
        _one_for_each(maker, section)


def _one_for_each(maker: Maker, section: Data) -> None:
    for key, kind, value in (("counters", "counter", 2), ("flags", "flag", True)):
        for name in section.get(key, {}):
            per = maker.stage.kept.get((kind, name))
            owners = maker.stage.groups.get(per, (per,)) if per else ()
            section[key][name] = {maker.chance.choice(owners): value} if owners else value


_IS = {one.name(): one for one in CONDITIONS.words()}
_FOLDED = [one for one in CONDITIONS.words() if one.name() in FOLDS]

FIT: dict[type, Callable[[Maker, Data], None]] = {
    **dict.fromkeys((_IS["speed"], _IS["distance"], _IS["way"]), _compared),
    _IS["score"]: _both(_of_one, _compared),
    **{one: _both(_folded(one.KEY), _of_one, _compared) for one in _FOLDED},
    _IS["counter"]: _both(_kept_each("counter"), _compared),
    _IS["flag"]: _both(_kept_each("flag"), _one_bound),
    _IS["timer"]: _both(_kept_each("timer"), _one_bound),
    _IS["told"]: _told_is,
    _IS["word"]: _both(_word, _of_one, _compared),
    _IS["entity"]: _both(_fact_is, _one_bound),
    _IS["draw"]: _drawn("equals"),
    _IS["sequence"]: _both(_kept_each("sequence"), _sequence_at),
    Place: _place,
    places.Placing: _kick,
    Score: _bounded,
    Count: _both(_kept_each("counter"), _bounded, _count),
    SetFlag: _kept_each("flag"),
    TimerAction: _both(_kept_each("timer"), _lengthens),
    Reset: _reset,
    DrawAction: _drawn("as"),
    SequenceCompleted: _kept_each("sequence"),
    SequenceBroken: _kept_each("sequence"),
    OnEvent: _event,
    CounterValue: _kept_each("counter"),
    FlagValue: _kept_each("flag"),
    TimerValue: _kept_each("timer"),
    **dict.fromkeys((WordValue, NumberWord), _word),
    **{model: _folded(model.KEY) for model in (HighestValue, LowestValue, SumValue)},
    CountValue: _counted,
    _IS["count"]: _both(_counted, _of_one, _compared),
    FactValue: _both(_fact_is, _of_one),
    scenario.Expectation: _expected,
}
