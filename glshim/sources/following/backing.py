"""The style's background, which is laid before the program draws on it."""

from __future__ import annotations

from collections.abc import Iterable

from glshim.model.boxes import Box
from glshim.sources.following.ground import Ground


class Backing:
    """Where the style's background was laid in the frame."""

    def __init__(self) -> None:
        self._laid = Ground()
        self.awaited = True
        """Nothing was laid in the frame, or since a clear."""
        self.free_depth = False
        """Depth was cleared in the frame: what has some is drawn in front of the background."""
        self.used = False
        """A layer of the frame lies on it."""
        self.own = (0.0, 0.0, 0.0)
        """The program's own background."""
        self.lifted: tuple[Box, ...] = ()
        """Pixels that are the program's own while it looks at them."""
        self._proven: bool | None = None
        """Frames have layers: what is drawn without depth belongs to them. None: nobody knows."""
        self._early: set[int] = set()
        """Framebuffers that hold what belongs to a layer if one comes, before anybody knows."""

    def missing(self, framebuffer: int, boxes: Iterable[Box]) -> list[Box]:
        """What of boxes it was not laid in."""
        return self._laid.free(framebuffer, boxes)

    def lies_in(self, framebuffer: int) -> bool:
        """Whether it was laid anywhere in a framebuffer."""
        return self._laid.has(framebuffer)

    def fits(self, polygons: bool, *, flat: bool) -> bool:
        """Whether it goes below what is drawn without depth. polygons: else lines, of which alone
        some programs are made. flat: which a menu may be."""
        return polygons and not flat if self._proven is None else self._proven

    def came_early(self, framebuffer: int) -> None:
        """Something was drawn without depth that it would go below, if anybody knew of a layer."""
        if self._proven is None:
            self._early.add(framebuffer)

    def holds_early(self, framebuffer: int) -> bool:
        """Whether such things are in a framebuffer."""
        return framebuffer in self._early

    def add(self, framebuffer: int, boxes: Iterable[Box]) -> None:
        """It was laid there."""
        self.awaited = False
        self._laid.add(framebuffer, boxes)

    def cleared(self, framebuffer: int, box: Box | None) -> None:
        """It is there no more; None: in all of it."""
        self.awaited = True
        self._early.discard(framebuffer)
        self._laid.remove(framebuffer, box)

    def end_frame(self) -> None:
        """What is drawn now is another picture."""
        self._laid.clear()
        self._early.clear()
        self.awaited, self.free_depth = True, False
        self._proven, self.used = self.used, False
