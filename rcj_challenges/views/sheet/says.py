"""The sentence ``says`` of a rule, with general words for the blanks that are filled in when it fires."""

from __future__ import annotations

from rcj_challenges.rules.phrasing import listed, number, plain
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.placeholders import OPEN, fill_generally, fill_params
from rcj_challenges.scenario.roster import ENTRANTS, as_tuple, has_other
from rcj_challenges.scenario.rule_effects import written_others
from rcj_challenges.views.sheet.phrasebook import Phrasebook

_UNKNOWN_TEAM = "the team"


def says_sentence(phrases: Phrasebook, rule: Rule) -> str:
    """Return the sentence of a rule for the sheet; an empty text if it has none."""
    phrases, scenario = phrases.within(rule), phrases.scenario
    words = fill_params(rule, scenario.params, rule.for_sheet).strip()
    if not words:
        return ""
    team, limit = _team(phrases, rule), _limit(phrases, rule)
    kind = "" if rule.for_each is None else "team" if rule.for_each == ENTRANTS else phrases.kinds_of(rule.for_each)
    each = (phrases.a_member(rule.for_each or ""), f"the {kind or plain(rule.for_each or '')}")
    others = "the other team" if kind == "team" and len(scenario.entrants) == 2 else "the others"
    if team == _UNKNOWN_TEAM:
        words = words.replace("{entity} of {team}", "{entity}")
    blanks = {
        "entity": each if _is_over_entities(phrases, rule) else _entity(phrases, rule),
        "each": each,
        "other": (_other(phrases, rule),) * 2,
        "others": (others,) * 2,
        "team": (team,) * 2,
        "measured": (limit if all(one.measures_its_limit() for one in rule.triggers) else OPEN,) * 2,
        "limit": (limit,) * 2,
        "points": (OPEN,) * 2,
    }
    named = dict.fromkeys(scenario.counters, (OPEN, OPEN))
    things = (
        *scenario.roles,
        *(name for name in scenario.draws if phrases.one_kind(phrases.roster.drawn.get(name, ()))),
    )
    named |= dict.fromkeys(scenario.draws, (OPEN, OPEN)) | {name: (phrases.thing(name),) * 2 for name in things}
    return as_sentence(fill_generally(words, named | blanks).replace(f"{OPEN}.", OPEN))


def as_sentence(words: str) -> str:
    """Return what an author wrote with a capital letter and a full stop."""
    end = "" if words.rstrip("\"'”)").endswith((".", "!", "?", "…", ":")) else "."
    return f"{words[:1].upper()}{words[1:]}{end}"


def _entity(phrases: Phrasebook, rule: Rule) -> tuple[str, str]:
    """Return the one that the triggers are about, and how it is called later."""
    names = _concerned(phrases, rule)
    first = listed([phrases.a_member(name) for name in names], "or") or "the one concerned"
    return first, f"the {phrases.kinds_of(names)}" if any(map(phrases.is_several, names)) else first


def _is_over_entities(phrases: Phrasebook, rule: Rule) -> bool:
    return rule.for_each is not None and rule.for_each != ENTRANTS and phrases.is_on_field(rule.for_each)


def _other(phrases: Phrasebook, rule: Rule) -> str:
    """Return the one touched: ``the other robot``, ``the robot`` if a ball touches it, ``Y1`` if only that can be."""
    others = phrases.roster.others(rule, None) if has_other(rule) else ()
    if len(others) == 1:
        return phrases.thing(others[0])
    kind = phrases.one_kind(others)
    if others and not kind:
        return phrases.any_of(written_others(rule))
    touching = rule.for_each or () if _is_over_entities(phrases, rule) else _concerned(phrases, rule)
    return f"the {kind}" if kind and kind != phrases.one_kind(touching) else f"the other {kind or 'one'}"


def _team(phrases: Phrasebook, rule: Rule) -> str:
    each = phrases.roster.expand(rule.for_each or ())
    # Balls and obstacles have no team: then it is the team of what came to them.
    is_over_robots = any(name in phrases.scenario.robots for name in each)
    names = each if is_over_robots else tuple(name for name in _concerned(phrases, rule) if name != "each")
    members = set(phrases.roster.expand(names))
    own = [seat for seat, robots in phrases.roster.teams.items() if members & set(robots)]
    return plain(own[0]) if len(own) == 1 and members <= set(phrases.roster.teams[own[0]]) else _UNKNOWN_TEAM


def _limit(phrases: Phrasebook, rule: Rule) -> str:
    limits = {trigger.limit(phrases) for trigger in rule.triggers}
    only = limits.pop() if len(limits) == 1 else None
    return OPEN if only is None else number(round(only, 3))


def _concerned(phrases: Phrasebook, rule: Rule) -> tuple[str, ...]:
    about = (trigger.about(phrases) for trigger in rule.triggers)
    return tuple(dict.fromkeys(name for names in about if names is not None for name in as_tuple(names)))
