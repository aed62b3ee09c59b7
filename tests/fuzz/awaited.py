"""What is known and will be mended: not generated, or not counted, until it is. Empty is right."""

from __future__ import annotations

import re

STEPS: tuple[tuple[str, str], ...] = ()
"""Steps that no program has."""
DIFFERENCES: tuple[tuple[str, str], ...] = ()
"""Differences, after who makes them, that are not counted."""


def step(text: str) -> bool:
    """Whether a step waits."""
    return not text.startswith("a = window") and any(re.search(p, text) for p, _ in STEPS)


def difference(style: str, what: str) -> bool:
    """Whether a difference waits. style: ``none`` or another."""
    whole = f"{'none' if style == 'none' else 'a style'}: {what}"
    return any(re.match(pattern, whole) for pattern, _ in DIFFERENCES)
