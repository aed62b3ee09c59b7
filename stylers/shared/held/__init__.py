"""Patterns that surfaces hold: where each pixel's surface lies on its object, for shaders over the
window.

A pass over the meshes writes it into the G-buffer; `HELD` is what a `tone_shader` reads it with.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from glshim.styling.glsl import glsl
from glshim.styling.passes import MeshShader, Pass, State, Weld
from glshim.styling.values import Layer

HELD = glsl(__file__, "held")
"""Follows ``tone.glsl``."""
_SHADER = MeshShader(
    "held", glsl(__file__, "held.vert"), glsl(__file__, "held.frag"), needs=("rest",)
)
_NEAREST = State(depth="less", writes_depth=True, blend="off")


def held(layer: Layer, coat: int, weld: Weld, *, by_light: bool = False) -> Iterator[Pass]:
    """Places of surfaces on their objects, for passes of the same coat that follow. by_light: they
    are told which surfaces the program lit."""
    parts = {True: layer.bodies}
    if by_light:
        parts = {
            lit: replace(layer, items=tuple(i for i in layer.items if i[1].lit is lit)).bodies
            for lit in (True, False)
        }
    for lit, bodies in parts.items():
        if bodies:
            yield Pass(
                bodies, _SHADER, "surface", state=_NEAREST, weld=weld, buffer=True, coat=coat,
                uniforms={"lit": float(lit)},
            )  # fmt: skip
