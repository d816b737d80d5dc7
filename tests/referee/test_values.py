"""Values that rules can name, the broadcast, and the sentences."""

import pytest

from rcj_challenges.rules.values.word import FACTS, WordValue
from tests.referee.building import TAKEN_OFF, at_tick_10, emitting, fail, on_fault, once, payload, place


class TestValueCounter:
    def test_it_is_the_count_or_the_score(self, stage):
        play = stage(
            "counters: {all: {initial: 2}, own: {per: robots, initial: 1.5}}",
            emitting("{a: {counter: all}, b: {counter: own}, c: {counter: own, entity: B1}, d: {score: yellow}}"),
            scores={"blue": 0, "yellow": 7},
        )
        assert payload(play) == {"a": 2, "b": 6, "c": 1.5, "d": 7}


class TestValuePositionOf:
    def test_it_is_where_an_entity_is_or_nothing_off_the_field(self, stage):
        play = stage(
            emitting("{a: {position_of: B1}}"),
            TAKEN_OFF % "B1",
        )
        assert payload(play) == {"a": [0.4, 0.5, pytest.approx(-1.57, abs=1e-6)]}
        play.play_until(15)
        assert payload(play) == {"a": None}

    def test_of_a_spot_it_is_its_present_place_without_a_yaw(self, stage):
        play = stage(
            "spots: {mark: {x_m: 0.5, y_m: -0.1}, target: {x_m: 0, y_m: 0.25}}",
            "broadcast: {fields: {mark: {position_of: mark}, target: {position_of: target}}}",
            emitting("{a: {position_of: mark}, b: {position_of: target}}"),
            at_tick_10("{action: set_spot, spot: mark, to: B1}"),
        )
        assert payload(play) == {"a": [0.5, -0.1], "b": [0, 0.25]}
        assert play.output.broadcast == {"mark": [0.5, -0.1], "target": [0, 0.25]}
        play.play_until(15)
        assert play.output.broadcast == {"mark": [0.4, 0.5], "target": [0, 0.25]}
        play.play()
        assert payload(play)["a"] == [0.4, 0.5]

    @pytest.mark.parametrize(("decided", "there"), [("mark", [0.5, -0.1]), ("B1", [0.4, 0.5, -1.57])])
    def test_of_what_a_draw_has_decided(self, stage, decided, there):
        play = stage(
            "spots: {mark: {x_m: 0.5, y_m: -0.1}}",
            "draws: {hidden: {values: [mark, B1]}}",
            emitting("{a: {position_of: hidden}}"),
            draws={"hidden": decided},
        )
        assert payload(play) == {"a": pytest.approx(there, abs=1e-6)}


class TestValueWord:
    WHO = (
        "{robot: {word: robot_name}, entity: {word: entity_name}, team: {word: team_name}, entrant: {word: entrant}, "
        "score: {word: score}, other: {word: team_name, of: blue}, others: {word: score, of: blue}}"
    )

    def test_words_about_who(self, stage):
        reported = payload(stage(emitting(self.WHO), scores={"blue": 3, "yellow": 5}))
        assert reported == {
            "robot": "Y1", "entity": "Y1", "team": "Yellow Sub", "entrant": "yellow",
            "score": 5, "other": "Blue Moon", "others": 3,
        }  # fmt: skip

    def test_each_goes_before_what_the_trigger_found(self, stage):
        play = stage(emitting(self.WHO, "for_each: blue,"))
        fail(play, "Y1")
        assert [event.payload["robot"] for event in play.events] == ["B1", "B2"]

    def test_words_about_the_match(self, stage):
        values = (
            "{a: {word: halftime}, b: {word: match_id}, c: {word: total_match_time_s}, d: {word: time_s}, "
            "e: {word: time_left_s}, f: {word: phase}}"
        )
        play = stage(emitting(values), half=2, match_id=77)
        play.play(9)
        assert payload(play) == {"a": 2, "b": 77, "c": 60, "d": 0.32, "e": 59.68, "f": "play"}

    def test_the_length_of_a_half_played_shorter_is_the_played_one(self, stage):
        assert payload(stage(emitting("{a: {word: total_match_time_s}}"), ticks=313)) == {"a": 10.016}

    def test_measured_and_limit_are_of_the_firing(self, stage):
        play = stage("""
        rules:
          told:
            triggers: [{trigger: displaced, entity: B1, distance_m: 0.25}]
            actions: [{action: emit, event: TOLD, payload: {m: {word: measured}, l: {word: limit}}}]
            says: "{entity} of {team} is {measured} m away, over {limit} m; {unknown} {measured"
        """)
        place(play, "B1", 0.4, 0.0)
        assert play.events[0].payload == {"m": 0.5, "l": 0.25}
        assert play.firings[0].says == "B1 of Blue Moon is 0.5 m away, over 0.25 m; {unknown} {measured"

    def test_the_seed_cannot_be_read_but_distinguished_from_others(self, stage):
        values = "{a: {word: seed_id}}"
        one, again, two = (payload(stage(emitting(values), seed=seed))["a"] for seed in (1, 1, 2))
        assert one == again != two
        assert len(one) == 8

    def test_every_word_of_the_model_is_known(self):
        literal = WordValue.model_fields["word"].annotation
        assert set(FACTS) == set(literal.__args__)


def test_a_drawn_yes_or_no_is_said_as_it_is_written(stage):
    rule = on_fault("Y1", "{action: score, entrant: blue}", more='says: "It is {open}.",')
    play = fail(stage("draws: {open: {values: [true]}}", rule))
    assert play.firings[0].says == "It is true."


def test_a_name_that_looks_like_a_placeholder_stays_a_name(stage):
    rule = on_fault("Y1", "{action: score, entrant: blue}", more='says: "{team} {entity}",')
    play = fail(stage(rule, team_names={"blue": "B", "yellow": "{entity} {limit}"}))
    assert play.firings[0].says == "{entity} {limit} Y1"


class TestBroadcast:
    FIELDS = "{score: {score: blue}, phase: {word: phase}, ball: {position_of: ball}}"

    def test_it_has_the_state_after_the_actions_on_every_tick(self, stage):
        play = stage(
            f"broadcast: {{fields: {self.FIELDS}}}",
            once(2, "{action: score, entrant: blue}"),
        )
        assert play.output.broadcast == {"score": 0, "phase": "play", "ball": [0.0, 0.0, 0.0]}
        assert [play.play().broadcast["score"] for _ in range(3)] == [0, 1, 1]

    def test_some_robots_get_fields_of_their_own(self, stage):
        play = stage(
            "broadcast: {only: {Y1: {way: {draw: way}}, blue: {way: none, n: {counter: n}}, B2: {way: B2}}}",
            "draws: {way: {values: [left]}}",
            "counters: {n: {initial: 4}}",
        )
        output = play.play()
        names = play.roster.entities
        assert {names[robot]: reported for robot, reported in output.private_broadcasts.items()} == {
            "Y1": {"way": "left"},
            "B1": {"way": "none", "n": 4},
            "B2": {"way": "B2", "n": 4},
        }
        assert output.broadcast == {}

    def test_what_is_for_some_only_comes_as_rarely(self, stage):
        # Y2 has nothing of its own, as where a file that extends this one has removed a key by null.
        play = stage("broadcast: {every_ticks: 3, fields: {}, only: {Y1: {a: 1}, Y2: {}}}")
        sent = [[*(play.play().private_broadcasts or {}).values()] for _ in range(6)]
        assert sent == [[], [], [{"a": 1}]] * 2
