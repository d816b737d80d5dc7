"""Lint of where things are: zones, spots and placements without a point on the field, or without room."""

from __future__ import annotations

import pytest

from tests.scenario.linting import found_in, kinds, rule


class TestGround:
    USE = rule("a", "{trigger: enters, entity: ball, zone: z}")

    @pytest.mark.parametrize(
        ("zone", "has_floor"),
        [
            ("shape: rect, x_min_m: 0.7", False),
            ("shape: rect, x_min_m: 0.64", True),
            ("shape: rect, y_min_m: 0.76", True),  # the goal
            ("shape: rect, x_min_m: 0.25, y_min_m: 0.76", False),  # beside the goal
            ("shape: rect, x_min_m: 0.63, y_min_m: 0.73", False),  # behind the chamfer
            ("shape: circle, centre_m: [0.7, 0.8], radius_m: 0.1", False),
            ("shape: circle, centre_m: [0.7, 0.8], radius_m: 0.16", True),
            ("shape: circle, centre_m: [0, 0], radius_m: 2, inverted: true", False),
            ("shape: circle, centre_m: [0, 0], radius_m: 0.8, inverted: true", True),
            ("shape: half_plane, through_m: [0.66, 0], normal: [1, 0]", False),
            ("shape: half_plane, through_m: [0.66, 0], normal: [-2, 0]", True),
            ("shape: rect, x_min_m: -0.66, x_max_m: 0.66, y_min_m: -0.9, y_max_m: 0.9, inverted: true", False),
            ("shape: polygon, points_m: [[0.5, 0.9], [0.5, 0.8], [0.9, 0.8]]", False),
            ("shape: polygon, points_m: [[0.9, 0.9], [0.5, 0.7], [0.9, 0.5]]", True),
        ],
    )
    def test_a_zone_without_a_point_on_the_field(self, zone, has_floor):
        assert kinds(f"zones: {{z: {{{zone}}}}}", rules=self.USE) == ([] if has_floor else ["zone_off_the_field"])

    @pytest.mark.parametrize(("x", "has_floor"), [(0.6, True), (0.8, False)])
    def test_a_circle_on_a_field_with_square_corners(self, x, has_floor):
        zone = f"field: {{corner_cut_m: 0}}\nzones: {{z: {{shape: circle, centre_m: [{x}, 0.8], radius_m: 0.1}}}}"
        assert kinds(zone, rules=self.USE) == ([] if has_floor else ["zone_off_the_field"])

    @pytest.mark.parametrize(
        ("zone", "covers"),
        [
            ("shape: circle, centre_m: [0, 0], radius_m: 45", True),  # 45 cm were meant
            ("shape: circle, centre_m: [0, 0], radius_m: 2.1", True),
            ("shape: circle, centre_m: [0, 0], radius_m: 1.2", False),  # who jumps over a wall is caught by it
            ("shape: rect, x_min_m: -30, x_max_m: 30, y_min_m: -40, y_max_m: 40", True),
            ("shape: rect, x_min_m: -30, x_max_m: 30, y_min_m: -40, y_max_m: 0", False),
            ("shape: rect, x_min_m: 30, inverted: true", True),
            ("shape: half_plane, through_m: [-20, 0], normal: [1, 0]", True),
        ],
    )
    @pytest.mark.parametrize("trigger", ["enters", "leaves"])
    def test_a_zone_that_covers_the_floor_by_far_is_never_entered_or_left(self, zone, covers, trigger):
        edge = rule("a", f"{{trigger: {trigger}, entity: ball, zone: z}}")
        assert kinds(f"zones: {{z: {{{zone}}}}}", rules=edge) == (["zone_covers_the_floor"] if covers else [])

    def test_it_is_told_once_and_how_it_came_about(self):
        both = "{trigger: enters, entity: ball, zone: z}, {trigger: leaves, entity: robots, zone: [z, pitch]}"
        zone = "zones: {z: {shape: circle, centre_m: [0, 0], radius_m: 45}}"
        (one,) = found_in(zone, rules=rule("a", both))
        told = (
            "zone 'z' covers the whole floor and half a metre more: nothing ever enters or leaves it; correct its numbers: "
            "lengths are in m"
        )
        assert told in str(one)

    def test_one_that_is_the_whole_field_is_no_slip_where_no_edge_is_waited_for(self):
        inside = ", conditions: [{condition: in_zone, entity: ball, zone: z}]"
        zone = "zones: {z: {shape: circle, centre_m: [0, 0], radius_m: 45}}"
        assert kinds(zone, rules=rule("a", "{trigger: touches, entity: Y1, other: ball}", more=inside)) == []

    def test_what_is_only_measured_to_may_lie_in_the_wall(self):
        near = "{condition: distance, entity: ball, to: z, at_least: 0.2}, {condition: distance, entity: ball, to: g, at_least: 0.2}"
        wall = "zones: {z: {shape: rect, x_min_m: 0.7}}\ngates: {g: {from_m: [-0.7, 0], to_m: [-0.7, 0.1]}}"
        assert kinds(wall, rules=rule("a", "{trigger: half_started}", more=f", conditions: [{near}]")) == []
        entered = "{trigger: enters, entity: ball, zone: z}, {trigger: crosses, entity: ball, gate: g}"
        found = kinds(wall, rules=rule("a", entered, more=f", conditions: [{near}]"))
        assert found == ["zone_off_the_field", "gate_off_the_field"]

    @pytest.mark.parametrize(("entered", "kinds_found"), [("", []), ("each", ["gate_off_the_field"] * 2)])
    def test_each_may_be_only_measured_to_as_well(self, entered, kinds_found):
        walls = "gates: {g: {from_m: [-0.7, 0], to_m: [-0.7, 0.1]}, h: {from_m: [0.7, 0], to_m: [0.7, 0.1]}}\ngroups: {gs: [g, h]}"
        near = ", for_each: gs, conditions: [{condition: distance, entity: ball, to: each, at_least: 0.2}]"
        trigger = f"{{trigger: crosses, entity: ball, gate: {entered}}}" if entered else "{trigger: half_started}"
        assert kinds(walls, rules=rule("a", trigger, more=near)) == kinds_found

    @pytest.mark.parametrize(("line", "count"), [("[[0.7, 0], [0.9, 0]]", 1), ("[[0.6, 0], [0.9, 0]]", 0)])
    def test_chance_that_would_set_a_spot_outside_the_walls(self, line, count):
        action = f"{{action: set_spot, spot: centre, to: {{on_line: {line}}}}}"
        found = [one for one in found_in(rules=rule("a", "{trigger: half_started}", action)) if "spot_off" in one.kind]
        assert len(found) == count
        if count:
            assert "no point of the line is on the field: the spot stays where it is" in str(found[0])

    def test_a_gate_or_a_spot_off_the_field(self):
        cross = rule("a", "{trigger: crosses, entity: ball, gate: g}")
        assert kinds("gates: {g: {from_m: [0.7, 0], to_m: [0.9, 0]}}", rules=cross) == ["gate_off_the_field"]
        assert kinds("gates: {g: {from_m: [0.7, 0], to_m: [-0.9, 0.1]}}", rules=cross) == []
        put = rule("a", "{trigger: half_started}", more=", conditions: [{condition: spot_free, spot: s}]")
        assert kinds("spots: {s: {x_m: 0.3, y_m: 0.8}}", rules=put) == ["spot_off_the_field"]
        assert kinds("spots: {s: {x_m: 0.1, y_m: 0.8}}", rules=put) == []

    @pytest.mark.parametrize(
        ("obstacle", "is_off"),
        [
            ("shape: box, centre_m: [3, 3], size_m: [0.1, 0.1]", True),
            ("shape: box, centre_m: [0.7, 0], size_m: [0.02, 0.1]", True),
            ("shape: box, centre_m: [0.65, 0], size_m: [0.02, 0.1]", False),
            ("shape: cylinder, centre_m: [0.68, 0.8], radius_m: 0.05", True),  # behind the chamfer
            ("shape: cylinder, centre_m: [0, 0.8], radius_m: 0.02", False),  # in the goal
            ("shape: wall, from_m: [0.7, -0.5], to_m: [0.7, 0.5]", True),
            ("shape: wall, from_m: [0.7, -0.5], to_m: [0.5, 0.5]", False),
        ],
    )
    def test_a_fixed_obstacle_wholly_off_the_field(self, obstacle, is_off):
        assert kinds(f"obstacles: {{it: {{{obstacle}}}}}") == ["obstacle_off_the_field"] * is_off

    @pytest.mark.parametrize(
        ("one", "other", "inside"),
        [
            ("cylinder, centre_m: [0, 0.6], radius_m: 0.05", "cylinder, centre_m: [0.02, 0.6], radius_m: 0.05", True),
            ("cylinder, centre_m: [0, 0.6], radius_m: 0.05", "cylinder, centre_m: [0.09, 0.6], radius_m: 0.05", False),
            ("cylinder, centre_m: [0, 0.6], radius_m: 0.05", "box, centre_m: [0, 0.6], size_m: [0.01, 0.01]", True),
            ("box, centre_m: [0, 0.6], size_m: [0.01, 0.01]", "cylinder, centre_m: [0, 0.6], radius_m: 0.05", True),
            ("wall, from_m: [0, 0.5], to_m: [0, 0.7]", "wall, from_m: [-0.1, 0.6], to_m: [0.1, 0.6]", False),  # a cross
            ("wall, from_m: [0, 0.5], to_m: [0, 0.7]", "wall, from_m: [0, 0.7], to_m: [0.1, 0.7]", False),  # a corner
            (
                "wall, from_m: [0, 0.5], to_m: [0, 0.7]",
                "cylinder, centre_m: [0, 0.7], radius_m: 0.005",
                False,
            ),  # an end
            ("wall, from_m: [0, 0.5], to_m: [0, 0.7]", "wall, from_m: [0, 0.55], to_m: [0, 0.72]", True),
        ],
    )
    def test_two_fixed_obstacles_inside_each_other(self, one, other, inside):
        obstacles = f"obstacles: {{one: {{shape: {one}}}, another: {{shape: {other}}}}}"
        assert kinds(obstacles) == ["obstacles_in_each_other"] * inside

    def test_a_robot_that_nobody_drives(self):
        assert kinds("entrants: {yellow: {robots: {Y3: null}}}") == ["robot_without_program"]
        assert kinds("entrants: {yellow: {robots: {Y3: null}}}", "robots: {Y3: {idle: true}}") == []

    def test_an_entity_that_is_taken_off_at_the_start_and_never_comes_back(self):
        off = rule("a", "{trigger: half_started}", "{action: remove, entity: Y3}")
        assert kinds(rules=off) == ["entity_never_on_the_field"]
        back = rule("b", "{trigger: time_reached, at_s: 5}", "{action: place, entity: yellow, at: start}")
        assert kinds(rules=off + back) == []

    @pytest.mark.parametrize(
        ("placings", "reason"),
        [
            ("{entity: ball, at: {point: [0.64, 0]}}", "in a wall"),
            ("{entity: ball, at: {point: [0.8, 0]}}", "off the field"),
            ("{entity: ball, at: {point: [0.45, 0]}}", "in a wall or an obstacle"),
            ("{entity: Y1, at: {spot: centre}}, {entity: ball, at: {point: [0.03, 0]}}", "'ball' would stand on 'Y1'"),
            ("{entity: [Y1, Y2], at: {spot: centre}}", "'Y2' would stand on 'Y1'"),
            ("{entity: robots, at: {nearest_free: [centre, middle_blue]}}", "6 things cannot share 2 spots"),
            ("{entity: ball, at: {uniform_in: slit}}", "in a wall"),
            ("{entity: ball, at: {on_line: [[0.7, 0.1], [0.8, 0.1]]}}", "off the field"),
            ("{entity: ball, at: {point: [-0.45, 0]}, mirror: {axis: x}}", "in a wall or an obstacle"),
        ],
    )
    def test_a_layout_that_cannot_find_room(self, placings, reason):
        sections = (
            "obstacles: {crate: {shape: box, centre_m: [0.45, 0], size_m: [0.1, 0.1]}}",
            "zones: {slit: {shape: rect, x_min_m: 0.635, x_max_m: 0.65, y_min_m: -0.2, y_max_m: 0.2}}",
            f"placements: {{l: [{placings}]}}",
        )
        use = rule("a", "{trigger: time_reached, at_s: 1}", "{action: place, layout: l}")
        use += rule("b", "{trigger: enters, entity: ball, zone: slit}")
        (finding,) = found_in(*sections, rules=use)
        assert finding.kind == "layout_without_room"
        assert reason in finding.problem.message

    def test_without_room_it_is_said_what_places_and_what_follows(self):
        use = "{action: place, %s}"
        at_s_1 = "{trigger: time_reached, at_s: 1}"
        both = use % "entity: [Y1, Y2], at: {point: [0, 0]}, on_failure: stay"
        (finding,) = found_in(rules=rule("a", at_s_1, both))
        assert (
            finding.problem.message == "there is no room: 'Y2' would stand on 'Y1', which this action places before it"
        )
        assert finding.remedy == "correct the place, or make it larger; on the field it would stay where it is"
        layout = "placements: {l: [{entity: Y1, at: {spot: centre}}, {entity: Y2, at: {spot: centre}}]}"
        (finding,) = found_in(layout, rules=rule("a", at_s_1, use % "layout: l"))
        assert finding.problem.message.endswith("which this layout places before it")
        assert finding.remedy.endswith("it would be tried again on every tick")

    @pytest.mark.parametrize(
        "placings",
        [
            "{entity: Y1, at: {point: [0, 0.1]}}, {entity: ball, at: {spot: centre}}",
            "{entity: [Y1, Y2], at: {nearest_free: [centre, middle_blue]}}",
            "{entity: ball, at: {on_line: [[-0.6, 0], [0.9, 0]]}}",
            "{entity: ball, at: {point: [0.64, 0]}, noise_m: [0.1, 0]}",
            "{entity: Y1, at: {spot: centre}}, {entity: Y1, at: {point: [0.4, 0]}}, {entity: ball, at: {spot: centre}}",
        ],
    )
    def test_where_there_is_or_may_be_room_nothing_is_said(self, placings):
        use = rule("a", "{trigger: time_reached, at_s: 1}", "{action: place, layout: l}")
        assert kinds(f"placements: {{l: [{placings}]}}", rules=use) == []


class TestThingsPutWhereAnotherOneStands:
    CRATE = "obstacles: {crate: {shape: cylinder, centre_m: [0.45, 0], radius_m: 0.05, movable: true}}"

    def told(
        self, action: str, more: str = "", trigger: str = "{trigger: touches, entity: Y1, other: crate}", each: str = ""
    ) -> list[str]:
        """Return what is said of an action that puts something beside another thing."""
        rules = f"  a: {{{each} triggers: [{trigger}], actions: [{action}], says: It is so.}}\n"
        return [str(one) for one in found_in(self.CRATE, rules=rules + more) if one.kind == "layout_without_room"]

    @pytest.mark.parametrize(
        ("action", "what", "whom"),
        [
            ("{action: place, entity: crate, at: {relative_to: Y1}}", "crate", "Y1"),
            ("{action: place, entity: ball, at: {relative_to: crate, offset_m: [0, 0.05]}}", "ball", "crate"),
            ("{action: place, entity: Y2, at: {relative_to: Y1, offset_m: [0.04, 0.04]}}", "Y2", "Y1"),
        ],
    )
    def test_it_never_finds_room_there(self, action, what, whom):
        (one,) = self.told(action)
        assert (
            f"there is no room: '{what}' would stand in '{whom}', beside which it is put; write a larger offset_m; on "
            "the field it would be tried again on every tick [layout_without_room]"
        ) in one

    def test_a_board_that_is_longer_than_wide_covers_a_circle_of_its_width_in_any_case(self):
        board = "obstacles: {board: {shape: box, centre_m: [0.4, 0], size_m: [0.3, 0.06], movable: true}}"
        for away_m, warned in (("0.04", True), ("0.051", False), ("0.12", False)):  # the ball's radius is 0.021
            touch = "{trigger: touches, entity: Y1, other: board}"
            put = f"{{action: place, entity: ball, at: {{relative_to: board, offset_m: [0, {away_m}]}}}}"
            found = found_in(board, rules=rule("a", touch, put))
            assert ("layout_without_room" in {one.kind for one in found}) is warned, away_m

    def test_in_a_layout_it_finds_no_room_either(self):
        beside = "{entity: crate, at: {relative_to: Y1, offset_m: [0.02, 0]}}"
        use = rule("a", "{trigger: time_reached, at_s: 1}", "{action: place, layout: l}")
        for placings, count in (
            (beside, 1),
            (f"{{entity: ball, at: start}}, {beside}", 1),
            (f"{{entity: Y1, at: start}}, {beside}", 0),
            (beside.replace("0.02", "0.12"), 0),
        ):
            found = found_in(self.CRATE, f"placements: {{l: [{placings}]}}", rules=use)
            told = [one for one in found if one.kind == "layout_without_room"]
            assert len(told) == count, placings
            assert all("'crate' would stand in 'Y1', beside which it is put" in str(one) for one in told)

    def test_each_beside_the_other_one(self):
        each = "for_each: robots,"
        touch = "{trigger: touches, entity: each, other: crate}"
        (one,) = self.told(
            "{action: place, entity: crate, at: {relative_to: each}, on_failure: stay}", trigger=touch, each=each
        )
        assert "'crate' would stand in 'each', beside which it is put" in one
        assert "on the field it would stay where it is" in one

    @pytest.mark.parametrize(
        "action",
        [
            "{action: place, entity: crate, at: {relative_to: Y1, offset_m: [0.12, 0]}}",
            "{action: place, entity: Y1, at: {relative_to: Y1}}",
            "{action: place, entity: ball, at: {relative_to: ball}, kick: {towards: {spot: centre}, speed_mps: 1}}",
            "{action: place, entity: crate, at: {relative_to: centre}}",
            "{action: place, entity: crate, at: {relative_to: Y1}, noise_m: [0.2, 0]}",
            # Where Y1 stood there is room when Y1 is put elsewhere, or taken off.
            "{action: place, entity: crate, at: {relative_to: Y1}}, {action: place, entity: Y1, at: start}",
            "{action: remove, entity: Y1, for_s: 1}, {action: place, entity: crate, at: {relative_to: Y1}}",
        ],
    )
    def test_there_may_be_room(self, action):
        assert self.told(action) == []

    def test_another_rule_takes_it_off(self):
        off = rule("b", "{trigger: time_reached, at_s: 1}", "{action: remove, entity: Y1}")
        assert self.told("{action: place, entity: crate, at: {relative_to: Y1}}", more=off) == []

    def test_another_rule_puts_it_elsewhere_in_the_same_tick(self):
        touch = "{trigger: touches, entity: Y1, other: crate}"
        elsewhere = rule("b", touch, "{action: place, entity: Y1, at: start}")
        assert self.told("{action: place, entity: crate, at: {relative_to: Y1}}", more=elsewhere) == []
        later = rule("b", "{trigger: time_reached, at_s: 1}", "{action: place, entity: Y1, at: start}")
        assert len(self.told("{action: place, entity: crate, at: {relative_to: Y1}}", more=later)) == 1
