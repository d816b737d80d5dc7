"""Words that other games and languages have for what is written otherwise here: what to write instead."""

from __future__ import annotations

_BY_RADIO = "'tells' fires when a robot tells the referee something by radio"
_REPEATED = "every 5 s is {trigger: time_reached, at_s: 5, every_s: 5}"
_STANDS_STILL = "a robot or ball that stands still is noticed by 'no_progress', a slow one by 'holds' with 'speed'"
_HELD = "'hold' keeps a robot where it is, for_s or until 'release'"
_LET_GO = "'release' lets a robot go that 'hold' holds"
_LATER = "a pause is a phase, and what comes later waits for a timer"
_CHANCE = "what chance decides is a draw: declare it under 'draws', and ask for it with {condition: drawn}"
_TOLD = "write told: what a robot has told the referee last"
_COUNT = "a counter changes by {action: count, counter: NAME, by: 1}, or is set: {action: count, counter: NAME, to: 0}"
_SCORE = "points are given by {action: score, entrant: NAME, points: 1}, and taken by points below 0"
_PLACE = "write place: it puts a robot or a ball at a place, or all of a layout at theirs"
_CARRIED = "nothing is carried along: take it off by 'remove', and let a flag kept per robots say who has it"
_CLOCK = "write timer, of a timer with starts: true"
_INSIDE = "write in_zone"
_TOUCHED = "write last_touch: who touched it last; that two touch is a trigger, 'touches'"
_IF = "what depends on something is a rule of its own, with conditions"

_TABLE: dict[str, tuple[tuple[str, str], ...]] = {
    "trigger": (
        ("told hears heard hear reports report radio message receives answers answer says said sends tell", _BY_RADIO),
        ("every interval repeat", _REPEATED),
        ("always tick each_tick update loop", f"a rule waits for a moment; {_REPEATED}"),
        ("hold", "what waits for a condition is 'holds'; 'hold' is an action that keeps robots still"),
        ("goal scored scores goal_scored", "a goal is {trigger: enters, entity: ball, zone: …}: the goal is the zone"),
        ("inside in_area arrives reaches comes_in goes_in", "write enters; how long it is inside, 'stays_in' measures"),
        ("exit exits outside out goes_out", "write leaves"),
        ("collision collides contact contacts hits hit bump bumps kick kicks meets", "write touches"),
        ("passes passes_through goes_through line", "write crosses, with a gate"),
        ("pushed shifted moved pushes", "write displaced"),
        ("stuck idle stands stands_still not_moving stops stopped lack_of_progress", _STANDS_STILL),
        ("timeout expired timer_ended timer_ends timer_runs_out runs_out time_is_over", "write timer_expired"),
        ("timer_over timer_done timer_finished timer_elapsed", "write timer_expired"),
        ("start starts begin kickoff match_start game_start match_started on_start", "write half_started"),
        ("end ends finish match_end game_over match_ended on_end", "write half_ended"),
        ("time at after clock elapsed", "write time_reached, with at_s"),
        ("phase_started phase_begins phase_changed new_phase", "write phase_entered"),
        ("falls falls_over flipped overturned tilted", "write tips_over"),
        ("crash crashed fault error program_crash", "write program_fault"),
        ("sequence sequence_done sequence_finished lap lap_completed", "write sequence_completed"),
        ("random chance probability", _CHANCE),
    ),
    "action": (
        ("wait sleep pause delay", _LATER),
        ("holds freeze stop held", _HELD),
        ("unfreeze free let_go unhold", _LET_GO),
        ("if when unless", _IF),
        ("set_counter increment decrement add subtract inc counter reset_counter count_up count_down", _COUNT),
        ("set_score add_score points add_points give_points award penalty penalise penalize goal", _SCORE),
        ("teleport move move_to put respawn spawn return relocate set_position position", _PLACE),
        ("attach carry carries grab pick_up pickup take follow glue join", _CARRIED),
        ("reset", "'place' puts things back, 'count' with to: 0 a counter, 'timer' with do: start a timer"),
        ("disqualify eliminate delete despawn take_off send_off kick_out park", "write remove, with for_s or for good"),
        (
            "log say says message print announce notify event trigger fire",
            "an event is written by {action: emit, event: NAME}; the sentence about it is the rule's 'says'",
        ),
        ("finish stop_match end_match end_half end_game game_over win lose", "write end, of the half or of the match"),
        ("start_timer stop_timer reset_timer set_timer", "write {action: timer, timer: NAME, do: start}"),
        ("phase change_phase goto goto_phase next_phase state", "write set_phase"),
        ("random choose pick roll shuffle", "write draw, of a draw that stands under 'draws'"),
        ("flag clear_flag unset_flag reset_flag", "write set_flag, with to: true or to: false"),
        ("toggle", "write toggle_flag"),
        ("set change", f"a flag is set by set_flag, a spot by set_spot, a draw by draw with as; {_COUNT}"),
        ("broadcast tell send inform", "what programs are told stands in the section 'broadcast'"),
    ),
    "condition": (
        ("and", "write all_of"),
        ("or", "write any_of"),
        ("not", "write the condition itself, with negate: true"),
        ("none_of", "write any_of, with negate: true"),
        ("halftime", "write half"),
        ("score points", "write counter, with the entrant as the counter: a score is read like one"),
        ("phase state", "write phases: […] beside 'conditions': a rule lives in the phases of that list"),
        ("time_s time clock elapsed", _CLOCK),
        ("frozen hold", "write held"),
        ("tells heard said", _TOLD),
        ("inside in is_in within zone contains", _INSIDE),
        ("outside out out_of not_in not_in_zone", f"{_INSIDE}, with negate: true"),
        ("near close close_to nearer closer_than distance_to", "write distance, with at_most"),
        ("stopped still moving velocity", "write speed"),
        ("facing heading direction sees", "write looks"),
        ("touched touching touch possession owner", _TOUCHED),
        ("free empty occupied", "write spot_free of a spot; of a zone in_zone, with negate: true"),
        ("random chance probability", _CHANCE),
        ("true always", "leave 'conditions' out: without them the triggers decide alone"),
        ("value variable", "write counter or flag"),
    ),
}  # fmt: skip
_HINTS = {(kind, word): hint for kind, entries in _TABLE.items() for words, hint in entries for word in words.split()}
_SHAPES: tuple[tuple[str, frozenset[str]], ...] = (
    ("rect", frozenset({"rectangle", "square", "box", "quad", "rectangular"})),
    ("box", frozenset({"rect", "rectangle", "square", "cube", "cuboid", "block", "brick"})),
    ("circle", frozenset({"disk", "disc", "round", "cylinder"})),
    ("cylinder", frozenset({"circle", "post", "pole", "pillar", "cone", "disk", "disc", "sphere", "ball", "round"})),
    ("polygon", frozenset({"triangle", "poly", "hexagon", "points"})),
    ("half_plane", frozenset({"plane", "line"})),
    ("wall", frozenset({"line", "fence", "barrier", "segment"})),
)
_EVENTS = {
    "trigger": "an event is heard by {{trigger: event, event: {event}}}",
    "action": "an event is announced by {{action: emit, event: {event}}}",
}
"""Events have capitals, and words of the language none."""


def other_name(word: str, kind: str, known: list[str]) -> str:
    """Return what to write instead of a word that is none here, as an ending of a message; empty if nobody knows.

    Args:
        word: as written.
        kind: ``trigger``, ``action``, ``condition`` or ``shape``.
        known: the words that may stand there.
    """
    if word.isidentifier() and word.isupper() and kind in _EVENTS and word.casefold() not in known:
        return f"; {_EVENTS[kind].format(event=word)}"
    word = word.casefold()
    if kind == "shape":
        meant = next((shape for shape, names in _SHAPES if shape in known and word in names), None)
        return f"; write {meant}" if meant else ""
    hint = _HINTS.get((kind, word))
    return f"; {hint}" if hint else ""


def table() -> dict[tuple[str, str], str]:
    """Return all of it, by kind and word: for those who check that no word of the language is among them."""
    return dict(_HINTS)
