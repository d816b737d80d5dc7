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
        "inside arrives reaches": "did you mean 'enters'? How long it is inside, 'stays_in' measures",
        "exits outside out": "did you mean 'leaves'?",
        "collides contact hits bump kick": "did you mean 'touches'?",
        "passes line": "did you mean 'crosses', with a gate?",
        "pushed moved turned": "did you mean 'displaced'?",
        "stuck idle stopped": "'no_progress' notices what stands still, 'holds' with 'speed' what is slow",
        "timeout timer_ended": "did you mean 'timer_expired'?",
        "start begin kickoff match_start": "did you mean 'half_started'?",
        "end finish match_end game_over": "did you mean 'half_ended'?",
        "time at clock": "did you mean 'time_reached', with at_s?",
        "phase_started phase_changed": "did you mean 'phase_entered'?",
        "falls flipped tilted": "did you mean 'tips_over'?",
        "crash crashed fault": "did you mean 'program_fault'?",
        "sequence lap": "did you mean 'sequence_completed'?",
        "random chance": _CHANCE,
    },
    "action": {
        "wait sleep pause delay": "a pause is a phase, and what comes later waits for a timer",
        "freeze stop": "'hold' keeps a robot where it is, for_s or until 'release'",
        "unfreeze let_go": "'release' lets a robot go that 'hold' keeps",
        "if when": "what depends on something is a rule of its own, with conditions",
        "set_counter increment decrement add inc": _COUNT,
        "set_score points penalty goal": _SCORE,
        "teleport move put respawn": "did you mean 'place'? It puts a robot, a ball, or a whole layout somewhere",
        "toggle_flag toggle": "'set_flag' with to: opposite turns a flag over",
        "disqualify eliminate delete": "did you mean 'remove', with for_s or for good?",
        "log say print announce": "an event is written by {action: emit, event: NAME}; a rule's sentence is its 'says'",
        "end_match win lose": "did you mean 'end'? It ends the half or the match",
        "start_timer stop_timer": "write {action: timer, timer: NAME, do: start}",
        "phase change_phase goto": "did you mean 'set_phase'?",
        "random choose roll": "did you mean 'draw'? The draw stands under 'draws'",
        "flag clear_flag": "did you mean 'set_flag', with to: true or to: false?",
        "broadcast tell send": "what programs receive is in the section 'broadcast'",
    },
    "condition": {
        "and all_of": "conditions in a list must all hold; in any_of a list may stand too",
        "or": "did you mean 'any_of'?",
        "not none_of": "the opposite of a condition is the same one with negate: true",
        "score points": "a score is compared with {score: ENTRANT, at_least: 3}",
        "phase state": "write 'phases' beside 'conditions': a rule is inactive in all others",
        "time clock elapsed": "did you mean 'timer', of one with starts: true?",
        "frozen hold": "did you mean {entity: NAME, held: true}?",
        "tells said": "did you mean 'told'?",
        "inside in within": "did you mean {entity: NAME, in: ZONE}?",
        "outside out": "did you mean {entity: NAME, in: ZONE, negate: true}?",
        "near close": "did you mean 'distance', with at_most?",
        "stopped still moving": "did you mean 'speed'?",
        "facing heading": "did you mean {entity: NAME, looks: NAME}?",
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
        "triangle": "did you mean 'polygon'?",
        "line fence": "did you mean 'wall', or of a zone 'half_plane'?",
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
