"""Words that other games and languages have for what is called otherwise here: data for help."""

from __future__ import annotations

_CHANCE = "chance is a draw: declare it under 'draws' and ask for it with {draw: NAME, equals: VALUE}"
_COUNT = "a counter changes by {action: count, counter: NAME, by: 1}; to: 0 sets it"
_SCORE = "points are given by {action: score, entrant: NAME, points: 1}"
_EVERY = "every 5 s is {trigger: time_reached, at_s: 5, every_s: 5}"
_RADIO = "'tells' fires when a robot tells the referee something by radio"

_WORDS: dict[str, dict[str, str]] = {
    "trigger": {
        "told hears radio message receives": _RADIO,
        "every interval repeat always tick loop": _EVERY,
        "goal scored": "a goal is {trigger: enters, entity: ball, zone: NAME}: the goal is a zone",
        "exits outside out": "did you mean 'leaves'?",
        "collides contact hits bump kick": "did you mean 'touches'?",
        "stuck idle stopped": "'no_progress' notices what stands still, 'holds' with 'speed' what is slow",
        "start begin kickoff match_start": "did you mean 'half_started'?",
        "end finish match_end game_over": "did you mean 'half_ended'?",
        "random chance": _CHANCE,
    },
    "action": {
        "wait sleep pause delay": "a pause is a phase, and what comes later waits for a timer",
        "freeze stop": "'hold' keeps a robot where it is, for_s or until 'release'",
        "if when": "what depends on something is a rule of its own, with conditions",
        "set_counter increment decrement add inc": _COUNT,
        "set_score points penalty goal": _SCORE,
        "teleport move put respawn": "did you mean 'place'? It puts a robot, a ball, or a whole layout somewhere",
        "log say print announce": "an event is written by {action: emit, event: NAME}; a rule's sentence is its 'says'",
        "toggle_flag toggle": "'set_flag' with to: opposite turns a flag over",
        "end_match win lose": "did you mean 'end'? It ends the half or the match",
        "broadcast tell send": "what programs receive is in the section 'broadcast'",
    },
    "condition": {
        "and all_of": "conditions in a list must all hold; in any_of a list may stand too",
        "or": "did you mean 'any_of'?",
        "not none_of": "the opposite of a condition is the same one with negate: true",
        "score points": "a score is compared with {score: ENTRANT, at_least: 3}",
        "phase state": "write 'phases' beside 'conditions': a rule is inactive in all others",
        "time clock elapsed": "did you mean 'timer', of one with starts: true?",
        "inside in within": "did you mean {entity: NAME, in: ZONE}?",
        "stopped still moving": "did you mean 'speed'?",
        "touched touching possession": "did you mean 'last_touch'?",
        "free empty occupied": "did you mean 'spot_free'? Of a zone: {entity: NAME, in: ZONE, negate: true}",
        "random chance": _CHANCE,
    },
    "value": {
        "time": "a time is {word: time_s, better: less, says: …}",
        "points goals": "points are {score: each, better: more}",
    },
    "shape": {
        "rectangle square": "did you mean 'rect', or of an obstacle 'box'?",
        "disk disc round": "did you mean 'circle', or of an obstacle 'cylinder'?",
    },
}
OTHER_WORDS = {
    (kind, word): help_ for kind, table in _WORDS.items() for words, help_ in table.items() for word in words.split()
}
"""By kind of word (``trigger``, ``action``, ``condition``, ``value``, ``shape``) and foreign word: what to write."""

_KEYS = {
    "when on": "triggers",
    "if": "conditions",
    "then do": "actions",
    "team": "entrant",
    "text message description": "says",
    "friction damping": "slows_mps2",
    "range_m": "max_range_m",
    "factor weight": "times",
    "periods": "halves",
    "teams": "entrants",
    "areas": "zones",
    "variables": "counters",
    "tests": "expect",
    "name": "title",
    "robot ball who": "entity",
    "not opposite inverted": "negate",
    "position pos location start start_m centre_m": "start_m centre_m start at",
    "amount value": "points by to equals initial",
    "duration seconds for_s": "half_s lasts_s for_s limit_s",
    "more_than faster_than greater_than greater over": "above at_least",
    "less_than slower_than fewer_than less under": "below at_most",
    "order": "better",
    "min minimum": "at_least",
    "max maximum up_to": "at_most",
}
OTHER_KEYS = {key: tuple(known.split()) for keys, known in _KEYS.items() for key in keys.split()}
"""By foreign key: the keys that it may be called here, of which those count that may stand in its place."""
