"""A style that draws nothing and holds what it was given."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import ClassVar

from OpenGL import GL

from glshim.model.batch import PolygonBatch
from glshim.styling.protocol import Layer, Lines, Pass, Styler

from .world import HEIGHT, WIDTH, App, Scene, run


@dataclass(frozen=True)
class Gathering(Styler):
    """Every batch of every layer."""

    name: ClassVar[str] = "gathering"
    normals: bool = True
    batches: list[PolygonBatch] = field(default_factory=list)

    @property
    def wants_normals(self) -> bool:
        return self.normals

    def draws(self, layer: Layer) -> Iterable[Lines | Pass]:
        self.batches.extend(batch for batch, _ in layer.items)
        return ()


def gathered(scene: Scene, normals: bool = True) -> list[PolygonBatch]:
    """The batches of a scene."""
    style = Gathering(normals=normals)
    found: list[PolygonBatch] = []

    def end_layer() -> None:
        GL.glReadPixels(0, 0, WIDTH, HEIGHT, GL.GL_RGB, GL.GL_UNSIGNED_BYTE)

    def read(app: App) -> None:
        end_layer()  # of what prepares the scene
        style.batches.clear()
        scene(app)
        end_layer()
        found.extend(style.batches)

    run(read, style)
    return found
