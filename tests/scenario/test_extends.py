"""What a scenario may extend."""

import shutil
from pathlib import Path

import pytest

from rcj_challenges.scenario.errors import ScenarioError, place_of
from rcj_challenges.scenario.load import load, load_text
from rcj_challenges.scenario.resources import PRESETS_FOLDER, SCENARIOS_FOLDER, TEAMS_FOLDER, names_in


def write(folder, name, text):
    folder.mkdir(parents=True, exist_ok=True)
    (folder / name).write_text(text, encoding="utf-8")
    return folder / name


def complaint(path):
    with pytest.raises(ScenarioError) as caught:
        load(path)
    (problem,) = caught.value.diagnostics
    assert place_of(problem).path == "extends"
    return f"{problem.code}: {problem.message}; {problem.help}"


@pytest.mark.parametrize("name", names_in(PRESETS_FOLDER))
def test_every_preset_is_strict_yaml_and_can_be_extended(name):
    assert load_text(f"schema_version: 2\nid: x\ntitle: X\nextends: {name}\n").scenario.robots


def test_a_relative_path_is_read_beside_the_file_that_names_it(tmp_path):
    write(tmp_path / "deep" / "er", "base.yaml", "extends: ../../root.yaml\nmatch: {half_s: 5}\n")
    write(
        tmp_path, "root.yaml", "schema_version: 2\nid: root\ntitle: Root\nextends: soccersim_v2\nmatch: {halves: 3}\n"
    )
    found = load(write(tmp_path, "mine.yaml", "extends: deep/er/base.yaml\nid: mine\n")).scenario
    assert (found.id, found.title, found.match.halves, found.match.half_s) == ("mine", "Root", 3, 5)


def test_five_bases_behind_each_other_are_allowed_and_six_are_not(tmp_path):
    write(tmp_path, "b4.yaml", "schema_version: 2\nid: b\ntitle: B\nextends: soccersim_v2\n")
    for number in (3, 2, 1):
        write(tmp_path, f"b{number}.yaml", f"extends: b{number + 1}.yaml\n")
    five = write(tmp_path, "five.yaml", "extends: b1.yaml\n")
    assert load(five).scenario.title == "B"
    assert complaint(write(tmp_path, "six.yaml", "extends: five.yaml\n")).startswith("wrong-extends: too many bases")


@pytest.mark.parametrize(
    "name",
    [
        "/etc/passwd", "/etc/x.yaml", "https://example.org/x.yaml", "C:/x.yaml", "C:x.yaml", "..\\x.yaml", "~/x.yaml",
        "//host/x.yaml", "x.json", "x.yaml/", "base", "../base", ".yaml ", "a\\tb.yaml", "file:///x.yaml",
    ],
)  # fmt: skip
def test_nothing_but_a_preset_or_a_relative_yaml_file_can_be_extended(tmp_path, name):
    text = f'extends: "{name}"\n' if "\\t" in name else f"extends: '{name}'\n"
    assert complaint(write(tmp_path, "mine.yaml", text))


@pytest.mark.parametrize("value", ["[soccersim_v2]", "{preset: x}", "3", "true", "''"])
def test_extends_is_one_name(tmp_path, value):
    assert complaint(write(tmp_path, "mine.yaml", f"extends: {value}\n"))


def test_suggested_file_in_another_folder_has_its_folder(tmp_path):
    (tmp_path / "base").mkdir()
    write(tmp_path, "base/arena.yaml", "title: B\n")
    text = complaint(write(tmp_path, "mine.yaml", "extends: base/arna.yaml\n"))
    assert text.endswith("did you mean 'base/arena.yaml'?")
    write(tmp_path, "base/mine.yaml", "title: B\n")
    assert complaint(tmp_path / "mine.yaml").endswith("did you mean 'base/arena.yaml'?")
    text = complaint(write(tmp_path, "mine.yaml", "extends: base/mines.yaml\n"))
    assert text.endswith("did you mean 'base/mine.yaml'?")


@pytest.mark.parametrize("name", ["./" + "b" * 5000, "./" + "b" * 5000 + ".yaml", "x/" * 3000 + "y.yaml"])
def test_a_name_longer_than_any_file_has_is_refused_as_any_other(tmp_path, name):
    text = complaint(write(tmp_path, "mine.yaml", f"extends: {name}\n"))
    assert text.partition(":")[0] in ("unknown-base", "wrong-extends")
    assert len(text) < 500


def test_a_shipped_scenario_is_extended_by_its_name_as_a_preset_is():
    loaded = load_text("schema_version: 2\nid: mine\ntitle: Mine\nextends: fast_shooter\nmatch: {half_s: 60}\n")
    assert list(loaded.scenario.robots) == ["Y3"]
    assert loaded.scenario.match.half_s == 60
    assert [path.stem for path in loaded.bases] == ["fast_shooter"]


def test_unknown_preset_is_refused_with_the_nearest_one():
    with pytest.raises(ScenarioError, match=r"did you mean 'match'"):
        load_text("extends: mach\n")
    with pytest.raises(ScenarioError, match="did you mean 'fast_shooter'"):
        load_text("extends: fast-shooter\n")


def test_shipped_scenario_as_a_path_is_refused_with_its_name(tmp_path):
    assert complaint(write(tmp_path, "mine.yaml", "extends: match.yaml\n")).endswith("by its name alone: match")


def test_shipped_files_lie_in_the_checkout_or_in_the_package(tmp_path, monkeypatch):
    from rcj_challenges.scenario import resources

    assert (SCENARIOS_FOLDER / "match.yaml").is_file()
    assert TEAMS_FOLDER.is_dir()
    package = tmp_path / "rcj_challenges"
    shutil.copytree(SCENARIOS_FOLDER, package / "data" / "scenarios")
    monkeypatch.setattr(resources, "_PACKAGE", package)
    assert resources.data_folder("scenarios", "scenarios") == package / "data" / "scenarios"
    assert names_in(package / "data" / "scenarios") == names_in(SCENARIOS_FOLDER) != []
    assert resources.data_folder("teams", "examples/teams") == tmp_path / "examples" / "teams"


def test_bare_names_find_shipped_scenarios_and_files_come_first(tmp_path, monkeypatch):
    assert load("match").path == SCENARIOS_FOLDER / "match.yaml"
    assert load("match").name == "match"
    monkeypatch.chdir(tmp_path)
    write(tmp_path, "match", "schema_version: 2\nid: own\ntitle: Own\nextends: soccersim_v2\n")
    assert load("match").scenario.id == "own"


@pytest.mark.parametrize("path", sorted(SCENARIOS_FOLDER.rglob("*.yaml")), ids=lambda path: path.stem)
def test_every_shipped_scenario_is_found_and_extended_by_its_bare_name(path, tmp_path):
    assert load(path.stem).path == path
    own = f"schema_version: 2\nid: own\ntitle: Own\nextends: {path.stem}\nexpect: {{inherited: null}}\n"
    assert load(write(tmp_path, "own", own)).scenario.robots == load(path).scenario.robots


def test_a_file_of_ones_own_is_not_passed_over_for_a_shipped_example_of_that_name(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write(tmp_path, "slalom.yaml", "schema_version: 2\nid: own\ntitle: Own\nextends: soccersim_v2\n")
    with pytest.raises(ScenarioError, match=r"ambiguous-name(.|\n)*help: write slalom\.yaml for that"):
        load("slalom")
    assert load("slalom.yaml").scenario.id == "own"
    monkeypatch.chdir(SCENARIOS_FOLDER / "examples")
    assert load("slalom").path == SCENARIOS_FOLDER / "examples" / "slalom.yaml"


def test_shipped_example_is_found_in_an_unreadable_folder(tmp_path, monkeypatch):
    def refuse(path, *_, **__):
        raise PermissionError(13, "Permission denied", str(path))

    monkeypatch.chdir(tmp_path)
    stat = Path.stat
    monkeypatch.setattr(Path, "stat", lambda path, **how: stat(path, **how) if path.is_absolute() else refuse(path))
    assert load("slalom").path == SCENARIOS_FOLDER / "examples" / "slalom.yaml"


@pytest.mark.parametrize("name", ["slalom", "fast_shooter_v2"])
def test_a_file_of_ones_own_is_not_passed_over_by_extends_either(name, tmp_path):
    write(tmp_path, f"{name}.yaml", "schema_version: 2\nid: own\ntitle: Own\nextends: soccersim_v2\n")
    harder = "schema_version: 2\nid: harder\ntitle: Harder\nextends: %s\nexpect: {inherited: null}\n"
    with pytest.raises(ScenarioError, match=rf"ambiguous-name(.|\n)*help: write {name}\.yaml"):
        load(write(tmp_path, "harder.yaml", harder % name))
    assert load(write(tmp_path, "harder.yaml", harder % f"{name}.yaml")).path == tmp_path / "harder.yaml"


def test_a_file_of_ones_own_may_end_with_yml_too(tmp_path, monkeypatch):
    write(tmp_path, "slalom.yml", "schema_version: 2\nid: own\ntitle: Own\nextends: soccersim_v2\n")
    monkeypatch.chdir(tmp_path)
    with pytest.raises(ScenarioError, match=r"help: write slalom\.yml for that"):
        load("slalom")
    with pytest.raises(ScenarioError, match=r"help: write slalom\.yml for that"):
        load(write(tmp_path, "harder.yaml", "schema_version: 2\nid: harder\ntitle: Harder\nextends: slalom\n"))
    own = "schema_version: 2\nid: own\ntitle: Own\nextends: slalom\nexpect: {inherited: null}\n"
    assert load(write(tmp_path, "slalom.yml", own)).scenario.id == "own"


def test_a_file_may_extend_the_shipped_one_of_its_own_name(tmp_path):
    own = "schema_version: 2\nid: own\ntitle: Own\nextends: slalom\nexpect: {inherited: null}\n"
    assert load(write(tmp_path, "slalom.yaml", own)).scenario.id == "own"


def test_unknown_name_is_refused_with_all_shipped_scenarios():
    with pytest.raises(ScenarioError, match=r"did you mean 'slalom'\?.* colour_hunt, hot_spot.*; variants fast_"):
        load("slalon")


@pytest.mark.parametrize("name", ["x" * 5000, "/".join(["x" * 200] * 30), f"{'x' * 5000}.yaml"])
def test_a_name_that_no_system_takes_is_no_file(name):
    with pytest.raises(ScenarioError, match="no-such-file"):
        load(name)
