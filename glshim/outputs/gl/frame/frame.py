"""The app's framebuffer as a layer leaves it: where ink goes, and what hides it."""

from __future__ import annotations

from dataclasses import dataclass

from glshim.outputs.gl.frame.depth import Box, DepthCopy
from glshim.outputs.output import WINDOW, Destination


@dataclass(frozen=True, slots=True)
class Frame:
    """What all draws of a layer share."""

    depth: DepthCopy
    """Its finished depth."""
    depth_margin: float
    """Window depth by which a line may lie behind the surface that it belongs to: a few steps of
    the depth buffer (``hair`` in shaders)."""
    reversed_depth: bool = False
    """The app's depth test lets greater depths win: farther is less depth."""
    framebuffer: int = 0
    """What ink goes over: the name of the app's framebuffer object, 0 for its window."""
    box: Box = (0, 0, 0, 0)
    """Pixels of it that the layer's cameras see."""
    destination: Destination = WINDOW

    @property
    def depth_sign(self) -> float:
        """1 where greater depth is farther, else -1 (``away`` in shaders)."""
        return -1.0 if self.reversed_depth else 1.0


_STEPS = 4.0
"""Of the depth buffer, between a line and the surface that it belongs to."""


def depth_margin(bits: int) -> float:
    """A few steps of a depth buffer in window depth; shaders have no more than 24 bits."""
    return _STEPS / 2.0 ** min(bits, 24)
