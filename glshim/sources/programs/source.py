"""Draws under the app's own shader program: recognised, and passed through untouched.

The driver knows where such a program puts its vertices; nothing here asks it yet.
"""

from __future__ import annotations

from collections.abc import Iterable

from glshim.model.camera import Camera
from glshim.sources.source import Drawn, Polygons
from glshim.sources.state import DrawState

IN_USE = "the program's own shaders are in use"


class Programs:
    """A `glshim.sources.source.Source`."""

    def obstacle(self, state: DrawState) -> str | None:
        """All draws while a program is in use are this source's."""
        return IN_USE if state.program else None

    def polygons(self, drawn: Drawn, state: DrawState) -> Iterable[tuple[Polygons, Camera]]:
        """None, as long as there is an obstacle to all."""
        return ()
