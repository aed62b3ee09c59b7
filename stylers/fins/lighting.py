"""Surfaces lit from the G-buffer: normals and depths first, light pixel by pixel after that.

P. Rideout, "Silhouette Extraction", 2010, "The Spine Test", and the dragon.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from importlib.resources import files
from math import isfinite, radians

from glshim.geometry.creases import Criterion
from glshim.styling.passes import Body, MeshShader, Pass, State
from glshim.styling.protocol import Colour, Uniform

Light = tuple[float, float, float, float]
_HERE = files(__package__)
_UNDER = -1
"""The sheet: fins go over it."""


def _shader(name: str) -> MeshShader:
    texts = ((_HERE / f"{name}.{stage}.glsl").read_text("utf-8") for stage in ("vert", "frag"))
    return MeshShader(f"fins {name}", *texts)


BUFFER, SURFACE = _shader("surface_buffer"), _shader("surface")
_CREASES = Criterion("either", radians(50.0), radians(1.0))
"""Light breaks where the app's normals do, or where triangles meet at an angle: a cube that came
without normals is not round."""
_NEAREST = State(depth="less", writes_depth=True, blend="off")
_OVER_ALL = State(depth="always", blend="off")


@dataclass(frozen=True, slots=True)
class Lighting:
    """How surfaces are lit."""

    paint: str | Colour
    """``app``: the hue and saturation of the app's own picture."""
    shine: float
    """Brightness of highlights, 0..1."""
    bands: int
    """Flat shades of light; 0: smooth."""


def lit_passes(
    found: tuple[Body, ...], light: Light, look: Lighting, tolerance: float
) -> Iterator[Pass]:
    """For bodies that are seen through one lens after the other, the G-buffer and the light on
    it. light: in eye space, homogeneous; tolerance: object units at which corners are one."""
    paint = (0.0, 0.0, 0.0, 0.0) if isinstance(look.paint, str) else (*look.paint, 1.0)
    for lens in _lenses(found):
        first = lens[0].camera
        whole = first.affine() is first and any(light) and all(map(isfinite, light))
        uniforms: dict[str, Uniform] = {
            "lamp": light if whole else (0.0, 0.0, 0.0, 0.0),
            "paint": paint, "shine": look.shine, "bands": float(look.bands),
        }  # fmt: skip
        yield Pass(
            BUFFER, lens, "surface", state=_NEAREST, creases=_CREASES, buffer=True, sheet=_UNDER,
            tolerance=tolerance,
        )  # fmt: skip
        yield Pass(
            SURFACE, lens[:1], "screen", state=_OVER_ALL, uniforms=uniforms, sheet=_UNDER
        )


def _lenses(found: tuple[Body, ...]) -> list[tuple[Body, ...]]:
    """Bodies by all of their cameras but the modelview: of their places on the screen one lens
    gives back places in eye space."""
    alike: dict[object, list[Body]] = {}
    for body in found:
        camera = body.camera.affine()
        key = camera.projection.tobytes(), camera.viewport, camera.depth_range, camera.scissor
        alike.setdefault(key, []).append(body)
    return [tuple(some) for some in alike.values()]
