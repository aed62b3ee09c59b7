"""Random programs run plain and under a style: pixels, gets, errors and exceptions are equal."""

from __future__ import annotations

import os

from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.differential.world import run

from .calls import Step, play, programs

FUZZ = int(os.environ.get("PROPERTY_EXAMPLES", "0"))
"""How many random programs; 0: a short run that is the same every time."""
AT_LENGTH = settings(
    max_examples=FUZZ or 120, derandomize=not FUZZ, deadline=None, database=None,
    suppress_health_check=list(HealthCheck),
)  # fmt: skip


@AT_LENGTH
@given(programs())
def test_none_is_plain_to_the_byte(program: list[Step]) -> None:
    def scene(app):
        play(app, program)

    assert run(scene).differences(run(scene, "none")) == {}


@AT_LENGTH
@given(programs(), st.sampled_from(("raskar", "raskar:ridges=off", "raskar:fill=app")))
def test_raskar_changes_nothing_but_the_picture(program: list[Step], style: str) -> None:
    def scene(app):
        play(app, program)

    assert run(scene).differences(run(scene, style), pictures=False) == {}
