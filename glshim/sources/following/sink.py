"""What the follower hands on, and to whom."""

from __future__ import annotations

from typing import Protocol

from glshim.model.boxes import Box, Unbacked
from glshim.model.lights import MaterialChange, Materials, Shade
from glshim.sources.following.layers import FinishedLayer
from glshim.sources.following.ownink import Run
from glshim.sources.following.scene import Scene
from glshim.sources.state import DrawState


class LayerSink(Protocol):
    """Where layers go, and what must be known on the way."""

    @property
    def background(self) -> Shade | None:
        """That is to be laid before the app draws on it; None: it stays the app's."""

    def lay_background(self, places: Unbacked) -> bool:
        """Lay it in places of the framebuffer that is bound. Whether that was possible."""

    def lift_background(self, box: Box, own: tuple[float, float, float]) -> tuple[Box, ...]:
        """Have pixels of a small box that nothing lies on in the program's own colour. Those."""

    def cover(self, materials: Materials = Materials.STAY) -> None:
        """Polygons that carry lines are about to be drawn by the app. materials: what
        they do during the draw."""

    @property
    def shows_paints(self) -> bool:
        """Whether what covers them shows the program's paints, which materials change."""

    def material(self, change: MaterialChange) -> None:
        """A material has changed inside the primitive that is covered."""

    def uncover(self) -> None:
        """They have been drawn."""

    @property
    def gathers_ink(self) -> bool:
        """Whether the program's own ink is gathered apart: `gather_ink`, `lay_ink`."""

    def gather_ink(self, state: DrawState, scene: Scene, *, first: bool, listed: bool) -> bool:
        """The app is about to draw lines or text, which shall not go into its picture; whether that
        can be had. first: nothing waits to be laid. listed: a display list draws them, which may
        change what it is drawn with."""

    def ink_gathered(self) -> None:
        """It has drawn them."""

    def lay_ink(self, run: Run, scene: Scene, *, recoloured: bool) -> None:
        """What was gathered goes into the picture. recoloured: so that it can be read there."""

    def layer_ends(self, layer: FinishedLayer, scene: Scene) -> None:
        """The depth of a layer with polygons is final, in the current context's scene."""

    def context_ended(self, handle: int) -> None:
        """A context is gone, and another one is current: at its address perhaps."""

    def give_up(self, error: BaseException) -> None:
        """A fault of ours: no more styling; the app's call goes on."""
