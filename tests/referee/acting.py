"""Actions set off by a rule at tick 10."""

from rcj_challenges.expect.scripted_match import ScriptedMatch


def at_tick_10(*actions: str) -> str:
    """Return a rule that runs these actions at tick 10."""
    return f"rules: {{act: {{triggers: [{{trigger: time_reached, at_s: 0.32}}], actions: [{', '.join(actions)}]}}}}"


def acted(play: ScriptedMatch) -> ScriptedMatch:
    """Return the play after tick 10."""
    play.play_until(10)
    return play
