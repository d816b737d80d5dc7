"""Rules by which the tests of the tick contract hear what the referee does."""

from rcj_challenges.facts.play import Snapshot


def once(tick: int, *actions: str, name: str = "act", more: str = "") -> str:
    """Return a rule that runs actions at a tick."""
    seconds = round(tick * 0.032, 3)
    return (
        f"rules: {{{name}: {{triggers: [{{trigger: time_reached, at_s: {seconds}}}], {more} "
        f"actions: [{', '.join(actions)}]}}}}"
    )


def told(play, name: str = "TOLD") -> list[int]:
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


TELL = "{action: emit, event: TOLD}"
