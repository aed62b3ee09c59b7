"""What lies in the framebuffers while a frame is drawn: the pictures of finished layers, and their
depths, until a clear takes them away."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from glshim.driver.arguments import name as name_among
from glshim.driver.ask import integer, integers, is_enabled
from glshim.model.boxes import Box, covers, overlap, without
from glshim.spec.constants import (
    GL_COLOR,
    GL_COLOR_BUFFER_BIT,
    GL_COLOR_WRITEMASK,
    GL_DEPTH,
    GL_DEPTH_BUFFER_BIT,
    GL_DEPTH_STENCIL,
    GL_DEPTH_WRITEMASK,
    GL_DRAW_BUFFER,
    GL_DRAW_FRAMEBUFFER_BINDING,
    GL_NONE,
    GL_RENDER,
    GL_RENDER_MODE,
    GL_SCISSOR_BOX,
    GL_SCISSOR_TEST,
    GL_STENCIL,
)
from glshim.spec.roles import Role

_BITS = {
    GL_COLOR: GL_COLOR_BUFFER_BIT, GL_DEPTH: GL_DEPTH_BUFFER_BIT,
    GL_DEPTH_STENCIL: GL_DEPTH_BUFFER_BIT, GL_STENCIL: 0,
}  # fmt: skip
"""Of the buffers that are cleared one by one."""
_MOST = 64
"""Boxes of a framebuffer that are told apart."""


@dataclass(frozen=True, slots=True)
class Clear:
    """What a clear does."""

    framebuffer: int
    box: Box | None
    """Pixels; None: all."""
    colour: bool
    """It changes some channel of the picture."""
    blank: bool
    """Nothing of the picture stays there."""
    depth: bool


def clear(role: Role, args: tuple[Any, ...]) -> Clear:
    """What a call of CLEAR or CLEAR_BUFFER will do in the state of now. Outside primitives."""
    framebuffer = integer(GL_DRAW_FRAMEBUFFER_BINDING)
    if role is Role.CLEAR:
        bits = name_among(args, 0)
    else:
        buffer = name_among(args, 0)
        if buffer not in _BITS:  # the name of a framebuffer is before it
            framebuffer, buffer = buffer, name_among(args, 1)
        bits = _BITS.get(buffer, 0)
    written = any(integers(GL_COLOR_WRITEMASK, 4)[:3]) and integer(GL_DRAW_BUFFER) != GL_NONE
    real = integer(GL_RENDER_MODE) == GL_RENDER
    colour = bool(real and bits & GL_COLOR_BUFFER_BIT and written)
    box = integers(GL_SCISSOR_BOX, 4) if is_enabled(GL_SCISSOR_TEST) else None
    return Clear(
        framebuffer,
        None if box is None else (box[0], box[1], box[2], box[3]),
        colour,
        colour and all(integers(GL_COLOR_WRITEMASK, 4)[:3]),
        bool(real and bits & GL_DEPTH_BUFFER_BIT and integer(GL_DEPTH_WRITEMASK)),
    )


class Ground:
    """Boxes of framebuffers in which something lies."""

    def __init__(self) -> None:
        self._boxes: dict[int, list[Box]] = {}

    def add(self, framebuffer: int, boxes: Iterable[Box]) -> None:
        """More lies there."""
        own = self._boxes.setdefault(framebuffer, [])
        for box in boxes:
            if not any(covers(other, box) for other in own):
                own.append(box)
        if len(own) > _MOST:
            x, y = min(b[0] for b in own), min(b[1] for b in own)
            right, top = max(b[0] + b[2] for b in own), max(b[1] + b[3] for b in own)
            own[:] = [(x, y, right - x, top - y)]

    def remove(self, framebuffer: int, box: Box | None) -> None:
        """Nothing lies there any more; None: in all of it."""
        if box is None:
            self._boxes.pop(framebuffer, None)
        else:
            self._boxes[framebuffer] = without(self._boxes.get(framebuffer, ()), box)

    def clear(self) -> None:
        """Nothing lies anywhere."""
        self._boxes.clear()

    def has(self, framebuffer: int) -> bool:
        """Whether something lies in a framebuffer."""
        return bool(self._boxes.get(framebuffer))

    def touches(self, framebuffer: int, boxes: Iterable[Box]) -> bool:
        """Whether something lies in some of these boxes."""
        own = self._boxes.get(framebuffer, ())
        return any(overlap(box, other) for box in boxes for other in own)

    def free(self, framebuffer: int, boxes: Iterable[Box]) -> list[Box]:
        """Where in boxes nothing lies, as boxes."""
        left = list(boxes)
        for other in self._boxes.get(framebuffer, ()):
            left = without(left, other)
        return left
