"""The output says in each tick whether the robots are held from the next one on."""

PHASES = """
phases: {countdown: {lasts_s: 0.32, robots: held}, stop: {lasts_s: 0.32, robots: held}, pause: {lasts_s: 0.32}}
rules:
  stop: {triggers: [{trigger: touches, entity: Y1, other: ball}], actions: [{action: set_phase, phase: stop}]}
  pause: {triggers: [{trigger: touches, entity: Y2, other: ball}], actions: [{action: set_phase, phase: pause}]}
"""


def held(play, ticks):
    """Play so many ticks and return in which of them, 1 being the first, the output holds the robots."""
    return [tick for tick in range(1, ticks + 1) if play.play().robots_held]


class TestHeldRobots:
    def test_from_tick_0_on_where_the_first_phase_holds_them(self, stage):
        play = stage(PHASES, "first_phase: countdown")
        assert play.output.robots_held
        assert held(play, 20) == list(range(1, 10))  # over when tick 10 is judged

    def test_from_the_tick_in_which_a_rule_enters_the_phase(self, stage):
        play = stage(PHASES)
        assert not play.output.robots_held
        play.play(2)
        play.touch("Y1", "ball")
        assert held(play, 20) == list(range(1, 11))

    def test_not_in_other_phases(self, stage):
        play = stage(PHASES)
        play.touch("Y2", "ball")
        assert held(play, 20) == []
