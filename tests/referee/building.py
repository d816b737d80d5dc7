"""Builds rules for tests of the referee, and moves things in scripted matches."""

from rcj_challenges.core.play import Snapshot
from rcj_challenges.expect.scripted_match import ScriptedMatch


def at_tick_10(*actions: str) -> str:
    """Return a rule that runs these actions at tick 10."""
    return f"rules: {{act: {{triggers: [{{trigger: time_reached, at_s: 0.32}}], actions: [{', '.join(actions)}]}}}}"


def acted(play: ScriptedMatch) -> ScriptedMatch:
    """Return the play after tick 10."""
    play.play_until(10)
    return play


def once(tick: int, *actions: str, name: str = "act", more: str = "") -> str:
    """Return a rule that runs actions at a tick."""
    seconds = round(tick * 0.032, 3)
    return (
        f"rules: {{{name}: {{triggers: [{{trigger: time_reached, at_s: {seconds}}}], {more} "
        f"actions: [{', '.join(actions)}]}}}}"
    )


def event_ticks(play, name: str = "TOLD") -> list[int]:
    """Return the ticks of the events of a name."""
    return [event.tick for event in play.events_named(name)]


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


IN_MIDDLE = "{trigger: enters, entity: ball, zone: middle}"


EMIT = "{action: emit, event: TOLD}"


def payload(play, *, fault: str = "Y1") -> dict:
    """Return what the next emission tells."""
    play.fail(fault)
    play.play()
    return play.events[-1].payload


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
    play.fail("B1")
    play.play()
    return play.referee.scores["yellow"]


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
    play.fail("Y1")
    play.play()
    placement = play.placements[-1][1]
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
