"""Styles for pictures in tests."""

from __future__ import annotations

from typing import Any

from glshim_stylers.raskar import Raskar

LINES = ("contours", "ridges", "valleys", "intersections")


def only(*kinds: str, **options: Any) -> Raskar:
    """Style raskar with these kinds of line on and the others off."""
    kinds = tuple("contours" if kind == "silhouettes" else kind for kind in kinds)
    unknown = {*kinds} - {*LINES}
    assert not unknown, f"style raskar has no {unknown}"
    return Raskar(**({kind: kind in kinds for kind in LINES} | options))
