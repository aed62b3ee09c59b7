"""Calls that begin a picture, read it back or have it finished, told to one who stands around them:
whatever the style, and around its hooks."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from glshim.bindings.pyopengl.raw import RAW, Call, Maker
from glshim.spec.roles import PICTURE_CALLS, role_of

Around = Callable[[str, tuple[Any, ...], Call], Any]
"""In place of a call: its name, its arguments, and what makes it."""


def stand_around(around: Around | None) -> None:
    """Have the calls of `PICTURE_CALLS` go through a function, outside primitives and lists; None:
    no more."""
    from glshim.bindings.pyopengl.recorder import RECORDER  # and numpy: late, for who only asks

    record = RECORDER.record

    def matcher(name: str) -> Maker | None:
        if role_of(name) not in PICTURE_CALLS:
            return None

        def maker(call: Call) -> Call:
            def hook(*args: Any, **named: Any) -> Any:
                if around is None or record.inside() or record.list_open:
                    return call(*args, **named)
                return around(name, args, partial(call, **named) if named else call)

            return hook

        return maker

    RAW.hook_over(matcher if around is not None else None)
