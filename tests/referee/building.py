"""Builds rules for tests of the referee, and moves things in scripted matches."""

from rcj_challenges.core.play import Snapshot
from rcj_challenges.expect.scripted_match import ScriptedMatch

EMIT = "{action: emit, event: TOLD}"
IN_MIDDLE = "{trigger: enters, entity: ball, zone: middle}"


def rule(trigger: str, *actions: str, name: str = "act", more: str = "") -> str:
    """Return a rule."""
    return f"rules: {{{name}: {{triggers: [{{{trigger}}}], {more} actions: [{', '.join(actions)}]}}}}"


def once(tick: int, *actions: str, name: str = "act", more: str = "") -> str:
    """Return a rule that runs actions at a tick."""
    return rule(f"trigger: time_reached, at_s: {round(tick * 0.032, 3)}", *actions, name=name, more=more)


def at_tick_10(*actions: str) -> str:
    """Return a rule that runs these actions at tick 10."""
    return once(10, *actions)


def on_fault(robot: str, *actions: str, name: str = "act", more: str = "") -> str:
    """Return a rule that runs actions when the program of a robot fails, which a test can let happen at any time."""
    return rule(f"trigger: program_fault, robot: {robot}", *actions, name=name, more=more)


def hears(trigger: str, more: str = "", event: str = "TOLD") -> str:
    """Return a rule that emits an event when it is triggered."""
    return rule(f"trigger: {trigger}", f"{{action: emit, event: {event}}}", name=event.lower(), more=more)


def acted(play: ScriptedMatch) -> ScriptedMatch:
    """Return the play after tick 10."""
    play.play_until(10)
    return play


def fail(play: ScriptedMatch, robot: str = "Y1") -> ScriptedMatch:
    """Return the play after a tick in which a robot's program fails."""
    play.fail(robot)
    play.play()
    return play


def place(play: ScriptedMatch, entity: str, *pose: float, ticks: int = 1) -> None:
    """Put an entity somewhere by hand, and judge so many ticks."""
    play.place(entity, *pose)
    play.play(ticks)


def touch(play: ScriptedMatch, first: str, second: str, ticks: int = 1) -> None:
    """Let two things touch in the first of so many ticks."""
    play.touch(first, second)
    play.play(ticks)


def event_ticks(play: ScriptedMatch, name: str = "TOLD") -> list[int]:
    """Return the ticks of the events of a name."""
    return [event.tick for event in play.events_named(name)]


def payloads(play: ScriptedMatch, name: str = "TOLD") -> list[dict]:
    """Return the payloads of the events of a name."""
    return [event.payload for event in play.events_named(name)]


def feed(play, *ball_at: tuple[float, float], touches=None) -> None:
    """Judge one tick in which the ball is seen at these places, one a sub-step."""
    poses, substeps = [play.pose(name) for name in play.roster.entities], []
    for x, y in ball_at:
        poses = list(poses)
        poses[play.roster.index["ball"]] = (x, y, 0.0)
        substeps.append(poses)
    play.tick += 1
    touching = touches or ((),) * len(substeps)
    play._take(play.referee.judge(Snapshot(play.tick, substeps, [0.04] * len(poses), [1.0] * len(poses), touching)))


def payload(play, *, fault: str = "Y1") -> dict:
    """Return what the next emission tells."""
    return fail(play, fault).events[-1].payload


def emitting(values: str, rule: str = "") -> str:
    """Return a rule that tells values whenever a program fails."""
    return f"""
    rules:
      told: {{{rule} triggers: [{{trigger: program_fault}}], actions: [{{action: emit, event: TOLD, payload: {values}}}]}}
    """


TAKEN_OFF = """
rules:
  gone: {triggers: [{trigger: time_reached, at_s: 0.32}], actions: [{action: remove, entity: %s}]}
"""


def scoring(points: str) -> str:
    """Return a rule that gives yellow points whenever a program fails."""
    return f"""
    rules:
      paid: {{triggers: [{{trigger: program_fault, robot: B1}}],
              actions: [{{action: score, entrant: yellow, points: {points}}}]}}
    """


def paid(play) -> float:
    return fail(play, "B1").referee.scores["yellow"]


# A fault of B1's program is the bell at which the condition is asked.
ASKING = """
rules:
  asked:
    triggers: [{trigger: program_fault, robot: B1}]
    conditions: [%s]
    actions: [{action: emit, event: TRUE_NOW}]
"""


def kicking(at: str, kick: str, more: str = "") -> str:
    """Return a rule that puts the ball somewhere and kicks it whenever Y1's program fails."""
    return f"""
    rules:
      kick_off:
        triggers: [{{trigger: program_fault, robot: Y1}}]
        actions: [{{action: place, entity: ball, at: {at}, kick: {kick}{more}}}]
    """


def kick(play: ScriptedMatch) -> tuple[float, float]:
    """Let the rule fire, and return the velocity of the ball's placement."""
    placement = fail(play).placements[-1][1]
    assert placement.entity == play.roster.index["ball"]
    return (placement.vx_mps, placement.vy_mps)


def walk(play: ScriptedMatch, entity: str, *places: tuple[float, float], ticks: int = 4) -> None:
    """Let an entity glide through these places."""
    for place in places:
        play.glide(entity, place, ticks)
        play.play(ticks)


SEQUENCE = """
zones:
  a: {shape: circle, centre_m: [-0.4, 0], radius_m: 0.1}
  b: {shape: circle, centre_m: [0, 0], radius_m: 0.1}
  c: {shape: circle, centre_m: [0.4, 0], radius_m: 0.1}
gates:
  high: {from_m: [-0.1, 0.3], to_m: [0.1, 0.3]}
balls: {ball: {start_m: [-0.4, -0.2]}}
sequences:
  way: {entity: ball, steps: [a, b, c], %s}
rules:
  done:
    triggers: [{trigger: sequence_completed, sequence: way}]
    actions: [{action: emit, event: DONE, payload: {took: {word: measured}}}]
  wrong: {triggers: [{trigger: sequence_broken, sequence: way}], actions: [{action: emit, event: WRONG}]}
"""
A, B, C = (-0.4, 0.0), (0.0, 0.0), (0.4, 0.0)
A_LOW, B_LOW, C_LOW = (-0.4, -0.3), (0.0, -0.3), (0.4, -0.3)
