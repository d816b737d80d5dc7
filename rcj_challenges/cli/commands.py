"""All commands, in the order in which ``--help`` lists them below each heading."""

# ruff: noqa: F401, I001 - each module adds its command to the app when it is imported, so their order counts
from rcj_challenges.cli import run
from rcj_challenges.cli import validate
from rcj_challenges.cli import test
from rcj_challenges.cli import explain
from rcj_challenges.cli import new
from rcj_challenges.cli import schema
from rcj_challenges.cli import draw
from rcj_challenges.cli import sheet
from rcj_challenges.cli import simulate
from rcj_challenges.cli import compare
from rcj_challenges.cli import teams
from rcj_challenges.cli import view
from rcj_challenges.cli import replay
from rcj_challenges.cli import check
from rcj_challenges.cli import judge
from rcj_challenges.cli import stats
from rcj_challenges.cli import video
from rcj_challenges.cli import snapshot
from rcj_challenges.cli import tournament
from rcj_challenges.cli import site
from rcj_challenges.cli import submit
from rcj_challenges.cli import verify
from rcj_challenges.cli.app import app

__all__ = ["app"]
