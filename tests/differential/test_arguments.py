"""Every argument that PyOpenGL takes or refuses is taken or refused alike: a few by chance of the
cases of ``python -m tests.arguments``."""

from __future__ import annotations

import pytest

from tests.arguments import FLAGS, STYLES, differences, told
from tests.sweep import FULL, SEED, some

OTHERS = (*((flags, False) for flags in tuple(FLAGS)[1:]), ("as it is", True))


@pytest.mark.parametrize(
    ("flags", "styles", "handler"),
    [
        ("as it is", STYLES, False),
        *((flags, STYLES[:1], handler) for flags, handler in some(OTHERS, 1)),
    ],
)
def test_what_comes_of_a_call(flags: str, styles: tuple[str, ...], handler: bool) -> None:
    count, functions = (20_000, 0) if FULL else (700, 60)
    how = {"count": count, "functions": functions, "seed": SEED, "handler": handler}
    plain = told(flags, "", **how)
    assert len(plain.came) > 0.9 * count
    for style in styles:
        styled = told(flags, style, skipped=tuple(plain.crashed), **how)
        assert (style, differences(plain, styled)) == (style, {})
