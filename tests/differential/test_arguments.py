"""Every argument that PyOpenGL takes or refuses is taken or refused alike: a few by chance of the
cases of ``python -m tests.arguments``."""

from __future__ import annotations

from typing import Any

import pytest

from tests.arguments import FLAGS, STYLES, differences, told
from tests.sweep import FULL, SEED, some

OTHERS = (*((flags, {}) for flags in tuple(FLAGS)[1:]), ("as it is", {"handler": True}),
          ("as it is", {"others": "last"}), ("numpy scalars", {"others": "last"}),
          ("numpy scalars", {"libraries": True}))  # fmt: skip


@pytest.mark.parametrize(
    ("flags", "styles", "more"),
    [
        ("as it is", STYLES, {}),
        ("as it is", STYLES[1:], {"libraries": True}),
        *((flags, STYLES[:1], more) for flags, more in some(OTHERS, 1)),
    ],
)
def test_what_comes_of_a_call(flags: str, styles: tuple[str, ...], more: dict[str, Any]) -> None:
    count, functions = (20_000, 0) if FULL else (700, 60)
    if "libraries" in more and not FULL:
        count, functions = 300, 20
    how = {"count": count, "functions": functions, "seed": SEED, **more}
    plain = told(flags, "", **how)
    assert len(plain.came) > 0.9 * count
    for style in styles:
        styled = told(flags, style, skipped=tuple(plain.crashed), **how)
        assert (style, differences(plain, styled)) == (style, {})
