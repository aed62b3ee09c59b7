"""A shot, from the frame before it to the file: tile by tile, while the clocks stand still."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from glshim import pipeline
from glshim.bindings.pyopengl.raw import RAW
from glshim.driver.ask import integer, integers
from glshim.driver.functions import current_context, gl
from glshim.errors import RenderError
from glshim.notices import say
from glshim.outputs.gl.frame.grab import grab
from glshim.outputs.output import WINDOW, Destination
from glshim.running.shots.calls import Calls, convert
from glshim.running.shots.glyphs import Glyphs
from glshim.running.shots.mapping import Mapping
from glshim.running.shots.plan import Plan, Size, Tile, tiles_of
from glshim.running.shots.target import Target
from glshim.spec.constants import (
    GL_DOUBLEBUFFER,
    GL_DRAW_BUFFER,
    GL_DRAW_FRAMEBUFFER,
    GL_DRAW_FRAMEBUFFER_BINDING,
    GL_MAX_RENDERBUFFER_SIZE,
    GL_MAX_TEXTURE_SIZE,
    GL_MAX_VIEWPORT_DIMS,
    GL_READ_BUFFER,
    GL_READ_FRAMEBUFFER,
    GL_VIEWPORT,
)
from glshim.system.writing import write_picture
from glshim.toolkits import frames

_UNLIKE = 24
"""Levels of a channel by which pixels of two tiles differ where they were not drawn alike."""
_BAND = 8
"""Pixels on either side of where tiles meet that are compared."""
_SOME, _FEW = 0.0005, 30
"""Share of such pixels in what is drawn twice that drawing by itself does not bring about, and a
number of them that it may."""
Pixels = NDArray[np.uint8]


class Clock(Protocol):
    """The program's time."""

    held: bool
    """It stands: the same moment is drawn again."""


class Shot:
    """A `calls.OpenTile`, and what listens to the ends of frames."""

    def __init__(self, plan: Plan, clock: Clock) -> None:
        self.plan = plan
        self._clock = clock
        self.mapping: Mapping = Mapping((1, 1), (1, 1), (0, 0))
        self.target: Any = None
        self.home = 0
        self.buffers: dict[int, int] = {}
        self.double = False
        self._context = 0
        self._left: list[Tile] = []
        self._tile: Tile | None = None
        self._sheet: Pixels = np.zeros((0, 0, 3), np.uint8)
        self._seen: NDArray[np.bool_] = np.zeros((0, 0), bool)
        self._unlike = self._shared = 0
        self._frames = 0
        self._plainly = self._rehearsing = False
        self._settled = True
        self._guess: Mapping | None = None
        self._calls = Calls(self._current, self._ahead, self._settle)
        self._glyphs = Glyphs(self._mapping)

    def prepare(self) -> None:
        """Before PyOpenGL is followed: stand below all its calls."""
        RAW.hook_below(self._calls.maker)
        self._glyphs.install()

    def begin(self) -> None:
        """From now on, listen: the frame before the one asked for opens the shot."""
        frames.listen(frames.Stage.CAPTURE, before=self._before, after=self._after)
        if self.plan.frame == 1:
            self._frames = 1  # the one that comes up to now is the only one: see `_settle`
            self._settled = False

    # -- ends of frames --------------------------------------------------------------------------

    def _before(self) -> None:
        if self._plainly and self._context == current_context():
            size, home = frames.drawable_size(), frames.drawable_framebuffer()
            self._sheet = np.array(grab(size, home))[::-1]
            self._try(self._write)
        elif self._tile is not None and self._context == current_context():
            self._clock.held = True
            self._take(self._tile)
        elif self._rehearsing and self._context == current_context():
            self._clock.held = True
            self._try(lambda: self.target.remember(self.home, self.mapping.window))

    def _after(self) -> None:
        if self._plainly or (self._context and self._context != current_context()):
            return
        if self._rehearsing:
            self._rehearsing = False
            self._try(self._next)
            return
        if self._tile is None:
            self._context = current_context()
            self._frames += 1
            if self._frames >= self.plan.frame - 1 and not self._left:
                self._try(self._open)
            return
        self._tile = None
        if self._left:
            self._try(self._next)
        else:
            self._try(self._write)

    def _try(self, step: Callable[[], None]) -> None:
        try:
            step()
        except (RenderError, OSError, MemoryError) as error:
            say(f"cannot take the shot: {error or type(error).__name__}")
            self._close()
            frames.end_program()

    def _open(self) -> None:
        """The window is known now: the frame that comes is the first tile."""
        window = self._window()
        sheet = self.plan.sheet_for(window)
        most = integers(GL_MAX_VIEWPORT_DIMS, 2)
        if sheet[0] > most[0] or sheet[1] > most[1]:
            raise RenderError(
                f"{sheet[0]}x{sheet[1]} pixels are more than this driver can draw: its limit is "
                f"{most[0]}x{most[1]} (GL_MAX_VIEWPORT_DIMS)"
            )
        self._context = current_context()
        self.home = frames.drawable_framebuffer() or integer(GL_DRAW_FRAMEBUFFER_BINDING)
        self.double = bool(integer(GL_DOUBLEBUFFER))
        self.buffers = {name: integer(name) for name in (GL_DRAW_BUFFER, GL_READ_BUFFER)}
        side = min(self.plan.tile, integer(GL_MAX_RENDERBUFFER_SIZE), integer(GL_MAX_TEXTURE_SIZE))
        self.mapping = Mapping(window, sheet, (0, 0))
        self._left = tiles_of(sheet, self.mapping.scale, side)
        if len(self._left) > 1:  # the first once more, to see whether the program stands still
            self._left.append(self._left[0])
        if sheet == window and len(self._left) == 1:  # the window is as good: drivers may draw
            self._plainly = True  # into it and into objects by other rules for ties
            return
        self.target = Target((self._left[0].width, self._left[0].height))
        self._sheet = np.zeros((sheet[1], sheet[0], 3), np.uint8)
        self._seen = np.zeros((sheet[1], sheet[0]), bool)
        # What programs read back may lie in another tile: a frame in the window shows it all.
        self._rehearsing = len(self._left) > 1
        self._settled = False
        if not self._rehearsing:
            self._next()

    def _next(self) -> None:
        """The frame that comes is the next tile."""
        tile = self._left.pop(0)
        fresh = not self.target.is_drawn_to
        before = None if fresh else self.mapping
        self.mapping = Mapping(self.mapping.window, self.mapping.sheet, (tile.x, tile.y))
        convert(before, self.mapping)
        if fresh:
            self.target.bind()
        origin = float(tile.x), float(tile.y)
        pipeline.draw_into(Destination(origin, self.mapping.scale, self.target.size, self.double))
        self._tile, self._settled = tile, False

    def _take(self, tile: Tile) -> None:
        """The frame is drawn: keep its part of the picture."""
        picture = np.asarray(self.target.picture())[::-1]
        left, low, right, top = tile.inner
        # What lies a little beyond is compared with what the neighbour draws there.
        outer = (max(left - _BAND, tile.x), max(low - _BAND, tile.y),
                 min(right + _BAND, tile.x + tile.width), min(top + _BAND, tile.y + tile.height))
        sheet, drawn = _slices(outer, (0, 0)), _slices(outer, (tile.x, tile.y))
        known, mine = self._seen[sheet], picture[drawn]
        apart = np.abs(self._sheet[sheet].astype(np.int16) - mine).max(axis=2) > _UNLIKE
        self._unlike += int((apart & known).sum())
        self._shared += int(known.sum())
        self._sheet[sheet][~known] = mine[~known]
        self._sheet[_slices(tile.inner, (0, 0))] = picture[_slices(tile.inner, (tile.x, tile.y))]
        known[:] = True

    def _write(self) -> None:
        if self._unlike > max(_SOME * self._shared, _FEW):
            say(
                "the tiles do not match: the program moves with each frame that it draws, not with "
                "a clock; draw the picture as one tile (a smaller size, or a larger --tile)"
            )
        picture = Image.fromarray(self._sheet[::-1])
        wanted = self.plan.size or picture.size
        if picture.size != wanted:
            shapes = ("{}x{}".format(*size) for size in (self.mapping.window, wanted))
            say("the window is {}, the picture {}: they differ in shape, and the margins are filled"
                .format(*shapes))  # fmt: skip
            sheet = Image.new("RGB", wanted, picture.getpixel((0, 0)))
            sheet.paste(picture, ((wanted[0] - picture.width) // 2,
                                  (wanted[1] - picture.height) // 2))  # fmt: skip
            picture = sheet
        write_picture(Path(self.plan.output), picture)
        self._close()
        frames.end_program()

    def _close(self) -> None:
        """Leave the driver as the program thinks it to be."""
        if self.target is not None and self._context == current_context():
            if self.target.is_drawn_to:
                convert(self.mapping, None)
                gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, self.home)
            if self.target.is_read:
                gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, self.home)
            self.target.release()
        pipeline.draw_into(WINDOW)
        self._tile, self.target = None, None
        self._clock.held = False

    # -- what calls ask --------------------------------------------------------------------------

    def _current(self) -> Shot | None:
        """The tile being drawn in the current context: ourselves."""
        drawing = self._tile is not None and current_context() == self._context
        return self if drawing else None

    def _settle(self) -> None:
        """At the first call of a frame: what C code did since the last one counts as well."""
        if self._settled or not current_context():
            return
        self._settled = True
        if not self._context:
            self._try(self._open)
            self._settled = self._clock.held = True
            return
        if current_context() != self._context:
            self._settled = False
            return
        # Not before: what the program's timers do until it draws belongs to the frame.
        self._clock.held = True
        if self._rehearsing:
            return
        # Qt binds its own before it has a widget painted.
        if integer(GL_DRAW_FRAMEBUFFER_BINDING) == self.home:
            convert(None, self.mapping)
            self.target.bind()
            return
        box = integers(GL_VIEWPORT, 4)
        if not self.mapping.knows(box):
            gl.glViewport(*self.mapping.rect(box))

    def _ahead(self) -> Mapping | None:
        """The mapping for what goes into display lists, which may be called in a shot."""
        now = self._current()
        if now is not None:
            return now.mapping
        if self._guess is None and current_context():
            window = self._window()
            if min(window) > 0:
                self._guess = Mapping(window, self.plan.sheet_for(window), (0, 0))
        return self._guess

    def _mapping(self) -> Mapping | None:
        """The mapping for what is drawn to the window now."""
        now = self._current()
        if now is None or not self.target.is_drawn_to:
            return None
        return now.mapping

    def _window(self) -> Size:
        """Pixels of the window."""
        size = frames.drawable_size()
        if size is not None and min(size) > 0:
            return size
        _, _, width, height = integers(GL_VIEWPORT, 4)
        return width, height


def _slices(box: tuple[int, int, int, int], origin: tuple[int, int]) -> tuple[slice, slice]:
    """Rows and columns of a box (left, low, right, top)."""
    (left, low, right, top), (x, y) = box, origin
    return slice(low - y, top - y), slice(left - x, right - x)
