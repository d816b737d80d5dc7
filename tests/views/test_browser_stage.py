"""The browser that tests of pages share: it hears every complaint, and no test finds what another left."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from tests.views.browser_stage import Stage


@pytest.mark.parametrize(
    ("script", "complaint"),
    [
        ("console.error('no field')", "no field"),
        ("console.warn('no goal')", "no goal"),
        ("throw new Error('no ball')", "no ball"),
        ("new Image().src = 'other.png'", "asked for file:"),
        ("fetch('http://127.0.0.1:9/').catch(() => 0)", "asked for http://127.0.0.1:9/"),
    ],
)
def test_errors_and_requests_of_a_page_are_collected(
    script: str, complaint: str, watch: Callable[..., Any], browser_stage: Stage, tmp_path: Path
) -> None:
    page = tmp_path / "page.html"
    page.write_text(f"<!doctype html><link rel=icon href='data:,'><p>Here.</p><script>{script}</script>", "utf-8")
    watch(page.as_uri(), ready="p")
    browser_stage.clear()
    assert any(complaint in heard for heard in browser_stage.complaints)
    browser_stage.complaints.clear()
