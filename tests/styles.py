"""Styles for pictures in tests, asked for by the options that exist."""

from __future__ import annotations

from dataclasses import fields
from typing import Any

from stylers.raskar import Raskar

LINES = ("silhouettes", "ridges", "valleys", "intersections")
KNOWN = frozenset(field.name for field in fields(Raskar))


def only(*kinds: str, **options: Any) -> Raskar:
    """Style raskar with these kinds of line on and the others off; options that it does not have
    are left out."""
    switches = {kind: kind in kinds for kind in LINES}
    return Raskar(**{k: v for k, v in (switches | options).items() if k in KNOWN})
