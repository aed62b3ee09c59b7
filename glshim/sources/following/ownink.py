"""The program's own ink: text and lines that it draws itself. With a style that wants it, they are
gathered apart from the picture, so that paper does not cover them, and laid over it in time."""

from __future__ import annotations

from dataclasses import dataclass

from glshim.sources.following.layers import LayerCollector


@dataclass(frozen=True, slots=True)
class Run:
    """Draws of ink that are laid over the picture together."""

    framebuffer: int
    held: bool
    """They belong to a layer, or come before anything that lies there: laid when the layer ends."""
    tested: bool
    """Surfaces that are nearer hide them."""


class OwnInk:
    """What is gathered in one context."""

    def __init__(self) -> None:
        self.run: Run | None = None
        """What waits to be laid."""
        self.is_drawn = False
        """A draw of ink is under way."""
        self.lost = False
        """The picture was cleared with ink in it before any frame was known to end: nobody knows
        when this program shows its pictures, so they get its ink at once."""
        self._shown = False

    def shown(self) -> None:
        """A picture is shown, with its ink."""
        self._shown, self.lost = True, False

    def cleared(self, *, colour: bool) -> None:
        """The program clears its picture, or only the depths."""
        self.lost |= colour and self.run is not None and not self._shown

    def joins(self, run: Run | None, carries: bool, layer: LayerCollector) -> bool:
        """Whether the ink that waits may wait on while something is drawn. run: the one that this
        belongs to, None for what is no ink; carries: that are polygons of a layer."""
        if self.run is None or self.run == run:
            return True
        return run is None and self.run.held and (carries or layer.pending)
