"""Style ``shadow``: shadow volumes for programs that have none.

M. McGuire, J. F. Hughes, "Hardware-Determined Feature Edges", NPAR 2004, section 7 and figure 1c:
contours as the light sees them, driven to infinity on the GPU. The stencil
counts the volumes that a surface lies in, from infinity (depth-fail; C. Everitt, M. J. Kilgard
2002), so that the viewer may stand in a shadow.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from math import cos, radians, sin
from typing import ClassVar

from glshim.styling.glsl import glsl
from glshim.styling.passes import Actions, MeshShader, Pass, Primitives, State, Stencil
from glshim.styling.protocol import Colour, Layer, Styler, option
from glshim.styling.values import Body, Place, Uniform

from ..shared import options

_LIT = 255
"""The stencil of what no volume holds: what it begins with. Counts wrap round it."""


def _shader(name: str, fragment: str, *needs: str) -> MeshShader:
    vertex = glsl(__file__, "volume", f"{name}.vert")
    return MeshShader(f"shadow {name}", vertex, glsl(__file__, fragment), needs=needs)


SIDES, SHADE = _shader("sides", "shade.frag", "light"), _shader("shade", "shade.frag")
CAPS, SURFACES = (_shader(name, "surface.frag", "light") for name in ("caps", "surfaces"))

_COUNT = Stencil(front=("keep", "decrease", "keep"), back=("keep", "increase", "keep"))
_VOLUME_STATE = State(depth="less", writes_colour=False, clamps=True, stencil=_COUNT)
_FARTHER: dict[str, Uniform] = {"push": 1.0, "slack": 1.0}
_NEARER: dict[str, Uniform] = {"push": -1.0, "slack": 0.05}
"""A lit surface lies before its own cap, by a pixel's slope: drivers cut bent quads along either
diagonal. What is acquitted must not reach through an edge to the other side of it: less there."""
_REPLACE: Actions = ("keep", "keep", "replace")
_ACQUIT = State(writes_colour=False, stencil=Stencil("always", _LIT, _REPLACE, _REPLACE))
# At the far plane: what lies on it is the background.
_SHADED = State(depth="greater", blend="off", stencil=Stencil("notequal", _LIT))


@dataclass(frozen=True)
class Shadow(Styler):
    """Shadows in the light of the program's GL_LIGHT0."""

    name: ClassVar[str] = "shadow"
    categories: ClassVar[tuple[str, ...]] = ("effects",)

    darkness: float = option(0.5, help="opacity of shadows", low=0.0, high=1.0)
    tint: Colour = option("#000000", help="colour of shadows")
    light: str = option(
        "app",
        help="light source: the program's GL_LIGHT0 (app), or azimuth and elevation (fixed); a "
        "light at the viewer, as GL_LIGHT0 is by default, casts no visible shadow",
        choices=("app", "fixed"),
    )
    azimuth: float = option(
        35.0, help="direction of the fixed light: 0 is behind the viewer, 90 is on the right",
        low=-180.0, high=180.0, unit="degrees",
    )  # fmt: skip
    elevation: float = option(
        50.0, help="height of the fixed light above the viewer's horizon",
        low=-90.0, high=90.0, unit="degrees",
    )  # fmt: skip
    self_shadows: bool = option(
        True, help="let objects cast shadows on themselves; one modelview matrix is one object"
    )
    turned_away: str = option(
        "app",
        help="surfaces that face away from the light: as the program shades them (app), which "
        "hides the facets of coarse meshes, or in shadow",
        choices=("app", "shadow"),
    )
    fill: str | Colour = options.fill()
    own_ink: str = options.own_ink()

    def draws(self, layer: Layer) -> Iterable[Pass]:
        """Volumes into the stencil, then the shade; where bodies do not shadow themselves, for
        each in turn."""
        found, light = layer.bodies, self._light(layer)
        for casting in [found] if self.self_shadows else [(body,) for body in found]:
            yield from _volumes(casting, light)
            if self.turned_away == "app":
                yield Pass(found, SURFACES, "triangles", state=_ACQUIT, light=light,
                           uniforms={"every": 0, **_NEARER})  # fmt: skip
            if not self.self_shadows:
                yield Pass(casting, SURFACES, "triangles", state=_ACQUIT, light=light,
                           uniforms={"every": 1, **_NEARER})  # fmt: skip
            shade = (*(self.darkness * channel for channel in self.tint), self.darkness)
            yield Pass(_windows(found), SHADE, "screen", state=_SHADED, uniforms={"shade": shade})

    def _light(self, layer: Layer) -> Place:
        """In eye space, homogeneous, w not negative: a direction leads towards it."""
        if self.light == "app":
            x, y, z, w = layer.light
            return (x, y, z, w) if w >= 0.0 else (-x, -y, -z, -w)
        turn, lift = radians(self.azimuth), radians(self.elevation)
        return cos(lift) * sin(turn), sin(lift), cos(lift) * cos(turn), 0.0


def _volumes(casting: tuple[Body, ...], light: Place) -> Iterator[Pass]:
    """Count, for each pixel, the volumes that its surface lies in, from nothing."""
    alike: dict[tuple[bool, int], list[Body]] = {}
    for body in casting:
        # Rays that are parallel meet at infinity in a point, which needs no cap.
        caps = 1 if light[3] == 0.0 and not body.camera.affine().orthographic else 2
        alike.setdefault((body.camera.mirrored, caps), []).append(body)
    clears = True
    for (mirrored, caps), some in alike.items():
        uniforms: dict[str, Uniform] = {"mirrored": int(mirrored), **_FARTHER}
        one, first = tuple(some), replace(_VOLUME_STATE, clears_stencil=clears)
        yield Pass(one, SIDES, "sides", Primitives("quads", 2), light=light,
                   uniforms=uniforms, state=first)  # fmt: skip
        yield Pass(one, CAPS, "triangles", Primitives(each=caps), light=light,
                   uniforms=uniforms, state=_VOLUME_STATE)  # fmt: skip
        clears = False


def _windows(found: tuple[Body, ...]) -> tuple[Body, ...]:
    """A body for each part of the window that any is seen in."""
    cameras = ((body, body.camera) for body in found)
    parts = {(c.viewport, c.depth_range, c.scissor): body for body, c in cameras}
    return tuple(parts.values())
