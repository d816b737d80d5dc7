"""A drawing as PNG: it shows what the SVG shows, its words too."""

from __future__ import annotations

from io import BytesIO

import pytest
from typer.testing import CliRunner

from rcj_challenges.cli.commands import load_app
from rcj_challenges.scenario.load import load
from rcj_challenges.views.drawing import draw_scenario, png

pytest.importorskip("resvg_py")
Image = pytest.importorskip("PIL.Image")

DARK = 100


@pytest.fixture(autouse=True)
def fonts_are_looked_up_again():
    png.written_with.cache_clear()
    yield
    png.written_with.cache_clear()


def test_picture_has_the_words():
    # The renderer takes a general name such as sans-serif for Arial, and where that is missing it leaves all words out.
    if png.written_with() is None:
        pytest.skip("this computer has no font")
    loaded = load("match")
    with Image.open(BytesIO(png.png_from_svg(draw_scenario(loaded.scenario, loaded.roster)))) as picture:
        # On the right of the field there is the legend: coloured marks, and nothing dark but words.
        legend = picture.convert("L").crop((picture.width * 3 // 4, 0, picture.width, picture.height))
        assert legend.getextrema()[0] < DARK


def test_missing_font_is_reported(tmp_path, monkeypatch):
    monkeypatch.setattr(png, "written_with", lambda: None)
    done = CliRunner().invoke(load_app(), ["draw", "match", "--out", str(tmp_path / "field.png")])
    assert done.exit_code == 0
    assert (tmp_path / "field.png").exists()
    assert "field.png has no words" in done.stderr
