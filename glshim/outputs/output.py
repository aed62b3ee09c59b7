"""What becomes of the layers that a styler has finished: one interface for every way out.

The OpenGL picture (`gl`) is the first output. Another one (a file of vectors, the model itself)
takes the same values, and needs no OpenGL.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

from glshim.model.boxes import Box, Unbacked
from glshim.model.lights import MaterialChange, Materials
from glshim.styling.lines import Lines
from glshim.styling.passes import Pass
from glshim.styling.protocol import BackFaces, Layer, Styler
from glshim.styling.values import Colour

Given = Lines | Pass | BackFaces
"""What stylers give."""


@dataclass(frozen=True, slots=True)
class Destination:
    """What the program draws into: its window, or during a shot a tile of a larger picture, the
    sheet. Pixels are those of the framebuffer."""

    origin: tuple[float, float] = (0.0, 0.0)
    """Pixels from the sheet's lower left corner to the framebuffer's."""
    scale: float = 1.0
    """Pixels for one of the window."""
    bounds: tuple[int, int] = (8192, 8192)
    """Pixels of the framebuffer, at most: how far drawing goes."""
    double_buffered: bool | None = None
    """Whether the window is; None: the driver knows."""


WINDOW = Destination()
"""The program's own window."""


class Context(Protocol):
    """The GL context that a layer was drawn in."""

    @property
    def stale(self) -> bool:
        """Whether the current context is another one, at the address of the one that was."""

    @property
    def gone(self) -> bool:
        """Whether it was destroyed. Asked while another is current."""

    def mark(self) -> None:
        """Leave a mark in it, so that :attr:`stale` can tell."""


@dataclass(frozen=True, slots=True)
class Ink:
    """How the program draws some text or lines."""

    framebuffer: int
    viewport: tuple[int, int, int, int]
    tested: bool
    """With a depth test."""
    written: bool
    """It writes depth."""
    listed: bool = False
    """A display list draws it, which may set for itself what else is said here."""


class Output:
    """One way out. The base does nothing but for `add`, which every output must."""

    def set_styler(self, styler: Styler | None) -> None:
        """What comes from now on is of this styler, None: of nobody."""

    def lay_background(self, places: Unbacked) -> bool:
        """The app has drawn nothing solid yet in places of the framebuffer that is bound: lay the
        styler's background there. Whether that was done."""
        return False

    def lift_background(self, box: Box, own: Colour) -> tuple[Box, ...]:
        """The app is about to look at some pixels of it: have those that nothing lies on in the
        app's own colour. Which those are."""
        return ()

    def cover(self, materials: Materials = Materials.STAY) -> None:
        """The app is about to draw polygons that carry lines, outside primitives. materials: what
        they do during the draw."""

    def material(self, change: MaterialChange) -> None:
        """A material has changed inside the primitive that is covered."""

    def uncover(self) -> None:
        """It has drawn them."""

    def gather_ink(self, ink: Ink, context: Context, *, first: bool) -> bool:
        """The app is about to draw text or lines, outside primitives: keep them apart. Whether that
        can be had. first: nothing is kept so far."""
        return False

    def ink_gathered(self) -> None:
        """It has drawn them."""

    def lay_ink(
        self, framebuffer: int, destination: Destination, *, tested: bool, recoloured: bool
    ) -> None:
        """What was kept apart goes into the app's picture. tested: behind surfaces it does not.
        recoloured: in colours that can be read there."""

    def add(
        self, given: Sequence[Given], layer: Layer, destination: Destination, context: Context
    ) -> None:
        """What the styler gave for a finished layer, in the order of drawing, while the app's
        context is current and before anything of the next layer is drawn. Raises `RenderError`
        where this output cannot show it."""
        raise NotImplementedError

    def brightness_behind(self, layer: Layer) -> float | None:
        """0..1, how bright the app's picture is behind a finished layer; None where that cannot be
        known."""
        return None

    def frame_ends(self) -> None:
        """A frame was presented: no layer of it comes any more."""

    def forget(self, handle: int) -> None:
        """The context of this handle is gone with what was made in it. Calls no GL: the current one
        is another, at the same address perhaps."""

    def release(self) -> None:
        """Give back what the current context holds for this style alone. Outside primitives."""
