"""Random programs run plain and under a style: pixels, gets, errors and exceptions are equal."""

from __future__ import annotations

import os
from collections.abc import Iterator

import pytest
from hypothesis import HealthCheck, given, seed, settings
from hypothesis import strategies as st

from tests import sweep

from .calls import Step, programs
from .worker import Worker

FUZZ = int(os.environ.get("PROPERTY_EXAMPLES", "120" if sweep.FULL else "0"))
"""How many random programs; 0: some, others each day (tests/sweep.py)."""
AT_LENGTH = settings(
    max_examples=FUZZ or 30, deadline=None, database=None,
    suppress_health_check=list(HealthCheck),
)  # fmt: skip
BY_DAY = (lambda test: test) if FUZZ else seed(sweep.SEED)


@pytest.fixture(scope="module")
def worker() -> Iterator[Worker]:
    made = Worker()
    yield made
    made.close()


@BY_DAY
@AT_LENGTH
@given(program=programs())
def test_none_is_plain_to_the_byte(worker: Worker, program: list[Step]) -> None:
    assert worker.differences(program, "none", True) == {}


@BY_DAY
@AT_LENGTH
@given(program=programs(), style=st.sampled_from(("raskar", "raskar:ridges=off")))
def test_raskar_changes_nothing_but_the_picture(
    worker: Worker, program: list[Step], style: str
) -> None:
    assert worker.differences(program, style, False) == {}


def test_the_comparison_sees_a_difference(worker: Worker) -> None:
    program: list[Step] = [("primitive", 7, [("glVertex3f", x, y, 0.0)
                           for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1))], 1, None)]  # fmt: skip
    assert set(worker.differences(program, "raskar", True)) == {"picture"}
    assert worker.differences(program, "none", True) == {}
