"""A style for a block of the program's own code, and the picture that comes of it."""

from __future__ import annotations

import os
from contextlib import ExitStack
from types import TracebackType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from glshim import pipeline
from glshim.driver.ask import integer, integers
from glshim.driver.context import has_framebuffers
from glshim.driver.functions import current_context
from glshim.errors import RenderError
from glshim.spec.constants import GL_DRAW_FRAMEBUFFER_BINDING, GL_VIEWPORT
from glshim.styling import texts
from glshim.styling.protocol import Styler


class Restyling:
    """What `style` gives: a context manager, inside which everything is drawn in the style."""

    def __init__(self, styler: Styler) -> None:
        self.styler = styler
        """The style with its options."""
        self._undo: ExitStack | None = None

    def __enter__(self) -> Restyling:
        if self._undo is not None:
            raise RenderError("this block is open already: call glshim.style(...) again")
        self._undo = ExitStack()
        self._undo.enter_context(pipeline.styled(self.styler))
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:  # fmt: skip
        undo, self._undo = self._undo, None
        if undo is not None:
            undo.close()

    def image(self, size: tuple[int, int] | None = None) -> NDArray[np.uint8]:
        """The picture so far, restyled, as (height, width, 3) uint8 RGB, the first row on top.

        It is read from the framebuffer that is bound for drawing. size: width and height in pixels,
        from its lower left corner; None: the part that the viewport covers. What is drawn
        afterwards lies over it, as after a readback of the program's own.

        Raises `RenderError` outside the block, between glBegin and glEnd, where no OpenGL context
        is current, and where the style has failed.
        """
        if self._undo is None:
            raise RenderError("image() is called inside the block: with glshim.style(...) as s:")
        if not current_context():
            raise RenderError("no OpenGL context is current: make that of a window current first")
        if pipeline.BINDING.stream.inside():
            raise RenderError("image() is called between glBegin and glEnd: call it after glEnd")
        pipeline.finish()
        if self.styler.wants_polygons and pipeline.current() is not self.styler:
            raise RenderError(
                f"style {self.styler.name!r} has failed, or another one was installed; what failed "
                "is on standard error"
            )
        from glshim.outputs.gl.frame.grab import grab

        left, low, across, up = integers(GL_VIEWPORT, 4)
        whole = size or (left + across, low + up)
        bound = integer(GL_DRAW_FRAMEBUFFER_BINDING) if has_framebuffers() else 0
        found = np.asarray(grab(whole, bound))
        return np.array(found if size else found[: found.shape[0] - low, left:])


def style(style: str | os.PathLike[str] | Styler, /, **options: Any) -> Restyling:
    """A block in which everything is drawn in a style::

        with glshim.style("raskar", ridge_width=4, ink="#203040") as s:
            draw_scene()                # the program's own OpenGL
            picture = s.image()         # (height, width, 3) uint8, the first row on top

    style: a style text, a style file or a styler, as of `install`. options: of the style, by name,
    as Python values or as text. An OpenGL context may be current or come later. Blocks may be
    nested: each puts back the style that was in force, or takes glshim's hooks away if there was
    none. What was drawn before the block keeps the style of then.

    Raises `StyleError` for a style or an option that is not valid.
    """
    if not isinstance(style, Styler):
        style = texts.parse_style(os.fspath(style))
    return Restyling(texts.with_options(style, options))
