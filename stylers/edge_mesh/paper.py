"""The paper's own strokes: thin lines, quads and half quads with caps, silhouettes, hidden lines.

McGuire & Hughes 2004, sections 3.2 to 3.5 and 4; every edge is decided where it is drawn.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from math import cos, radians
from typing import Literal

from glshim.geometry.meshshaders.edge_mesh import BOUNDARY, CONTOUR, MARKED, RIDGE, VALLEY
from glshim.styling.glsl import glsl
from glshim.styling.passes import (
    Actions,
    MeshShader,
    Pass,
    Primitives,
    Sieve,
    State,
    Stencil,
)
from glshim.styling.pictures import Image, is_coloured
from glshim.styling.screen import SCREEN
from glshim.styling.values import Body, Colour, Layer, Uniform

KINDS = (CONTOUR, RIDGE, VALLEY, MARKED, BOUNDARY)
"""The order of what `PaperLook` says of each kind."""
_DASH = 9.0
"""Pixels after which dashes repeat, of thin lines; and the least number of widths."""
_DIM = 0.3
"""Ink of dimmed lines."""
_WIDE_DASH = 3.0


def _shader(name: str, define: str = "") -> MeshShader:
    fragment = define + glsl(__file__, "receded", "paper.frag")
    vertex = glsl(__file__, "paper", f"paper_{name}.vert")
    return MeshShader(f"paper {name}", vertex, fragment, needs=())


LINE, QUAD, CAP = (_shader(name) for name in ("line", "quad", "cap"))
ROUND = _shader("round", "#define ROUND\n")
RECEDE = MeshShader("paper recede", SCREEN, glsl(__file__, "receded", "recede.frag"), needs=())
MASK = MeshShader("paper mask", glsl(__file__, "mask.vert"), glsl(__file__, "mask.frag"), needs=())


@dataclass(frozen=True, slots=True)
class PaperLook:
    """What lines there are and what they look like. Kinds in the order of `KINDS`."""

    strokes: Literal["thin", "quads", "half"] = "thin"
    """half: contours are half quads, outside of the object; other kinds remain whole."""
    caps: Literal["none", "paper", "round"] = "paper"
    """paper: equations 4 and 5. round: half disks, ours."""
    drawn: tuple[bool, ...] = (True,) * 5
    widths: tuple[float, ...] = (3.0,) * 5
    """Pixels; thin lines have one."""
    inks: tuple[Colour, ...] = ((0.0, 0.0, 0.0),) * 5
    ridge_angle: float = 120.0
    """Degrees: internal angles less than this are ridges."""
    valley_angle: float = 120.0
    """Degrees: external angles less than this are valleys."""
    hidden: Literal["none", "dashed", "dimmed", "solid"] = "none"
    outer: bool = False
    """Of contours only those against what is not the object itself."""
    images: tuple[Image | None, ...] = (None,) * 5
    """What strokes other than thin ones are drawn with."""
    lengths: tuple[float, ...] = (0.0,) * 5
    """Pixels after which the images repeat, or of thin lines their dashes; 0: there are none."""
    parameters: Literal["object", "screen"] = "screen"
    """How the image lies along the lines (section 4)."""


def paper_passes(look: PaperLook, layer: Layer) -> Iterable[Pass]:
    """Models with a depth offset, hidden lines where they are asked for, then visible ones."""
    models = layer.bodies
    wanted = sum(bit for bit, on in zip(KINDS, look.drawn, strict=True) if on)
    if not models or not wanted:
        return
    yield _recede(look, models)
    inner = wanted & ~CONTOUR if look.outer else wanted
    if inner:
        yield from _strokes(look, models, inner, None)
    if look.outer and wanted & CONTOUR:
        yield from _silhouettes(look, models)


def _recede(look: PaperLook, models: tuple[Body, ...]) -> Pass:
    """Section 3.5: models with a depth offset, once for every viewport."""
    ports = {body.camera.viewport: body.camera for body in models}
    screens = tuple(
        Body((), replace(camera, scissor=None, depth_range=(0.0, 1.0))) for camera in ports.values()
    )
    state = State(depth="always", writes_depth=True, writes_colour=False, blend="off")
    uniforms: dict[str, Uniform] = {"factor": _factor(look)}
    return Pass(screens, RECEDE, "screen", state=state, uniforms=uniforms, lines=True)


def _silhouettes(look: PaperLook, models: tuple[Body, ...]) -> Iterator[Pass]:
    """Section 3.4. Step 4 is printed as "pass where stencil == S"; S is where the model is, and
    what suppresses the contours within it is the opposite."""
    counted = 0
    for body in models:
        counted = (counted + 1) % 255
        every: Actions = ("keep", "replace" if look.hidden != "none" else "keep", "replace")
        yield Pass(
            (body,), MASK, "triangles", lines=True,
            state=State(
                writes_colour=False, blend="off", clears_stencil=counted == 0,
                stencil=Stencil("always", counted, every, every),
            ),
        )  # fmt: skip
        yield from _strokes(look, (body,), CONTOUR, Stencil("notequal", counted))


def _strokes(
    look: PaperLook, models: tuple[Body, ...], wanted: int, stencil: Stencil | None
) -> Iterator[Pass]:
    """Lines of the kinds that are wanted (bits): hidden ones, then visible ones over them."""
    if look.hidden != "none":
        state = State(depth="greater", blend="greatest", stencil=stencil)
        for shown in _alike(look, wanted):
            yield from _shapes(look, models, state, wanted, shown, hidden=True)
    state = State(depth="lequal", blend="greatest", stencil=stencil)
    for shown in _alike(look, wanted):
        yield from _shapes(look, models, state, wanted, shown, hidden=False)


def _alike(look: PaperLook, wanted: int) -> list[int]:
    """Bits of the kinds that are wanted, those with one picture together."""
    found: dict[object, int] = {}
    for bit, image, length in zip(KINDS, look.images, look.lengths, strict=True):
        if wanted & bit:
            found[id(image), length] = found.get((id(image), length), 0) | bit
    return [*found.values()]


def _shapes(
    look: PaperLook, models: tuple[Body, ...], state: State, wanted: int, shown: int, *,
    hidden: bool,
) -> Iterator[Pass]:  # fmt: skip
    uniforms, image = _uniforms(look, wanted, shown, hidden=hidden), _image(look, shown)
    sieve = Sieve(wanted, (radians(look.ridge_angle), radians(look.valley_angle)))
    if look.strokes == "thin":
        yield Pass(
            models, LINE, "edges", Primitives("lines"), state=state, uniforms=uniforms, sieve=sieve,
            lines=True,
        )  # fmt: skip
        return
    shader = ROUND if look.caps == "round" else QUAD
    yield Pass(
        models, shader, "edges", Primitives("quads"), state=state, uniforms=uniforms,
        image=image, sieve=sieve, lines=True,
    )  # fmt: skip
    if look.caps == "paper":
        yield Pass(
            models, CAP, "edges", Primitives("triangles", 2), state=state, uniforms=uniforms,
            image=image, sieve=sieve, lines=True,
        )  # fmt: skip


def _reaches(look: PaperLook) -> tuple[float, ...]:
    """Pixels from an edge to the side of its stroke: half its width; in half quads, all of it."""
    if look.strokes == "thin":
        return (0.5,) * 5
    return tuple(
        width if _is_half(look, bit) else width / 2.0
        for bit, width in zip(KINDS, look.widths, strict=True)
    )


def _is_half(look: PaperLook, bit: int) -> bool:
    return look.strokes == "half" and bit == CONTOUR


def _factor(look: PaperLook) -> float:
    """Slopes by which models go back: a pixel, and what lies beneath strokes on both sides of their
    edge. Half quads lie outside."""
    if look.strokes == "thin":
        return 1.0
    reaches = zip(KINDS, _reaches(look), look.drawn, strict=True)
    return 1.0 + max((r for bit, r, on in reaches if on and not _is_half(look, bit)), default=0.0)


def _image(look: PaperLook, shown: int) -> Image | None:
    """The picture of kinds that have it together."""
    return next(image for bit, image in zip(KINDS, look.images, strict=True) if shown & bit)


def _uniforms(look: PaperLook, wanted: int, shown: int, *, hidden: bool) -> dict[str, Uniform]:
    image, thin = _image(look, shown), look.strokes == "thin"
    lengths = (length for bit, length in zip(KINDS, look.lengths, strict=True) if shown & bit)
    dashed = (thin and any(lengths)) or (hidden and look.hidden == "dashed")
    textured = image is not None and not thin and not dashed
    space = 1 if look.parameters == "screen" else 0
    coloured = image is not None and is_coloured(image)
    return {
        "wanted": wanted,
        "shown": shown,
        "turns": (cos(radians(look.ridge_angle)), cos(radians(look.valley_angle))),
        "inks": tuple(channel for ink in look.inks for channel in ink),
        "reaches": _reaches(look),
        "lengths": _lengths(look, dashed),
        "halves": sum(bit for bit in KINDS if _is_half(look, bit)),
        "along": 2 if dashed else space,
        "capped": int(look.caps == "paper"),
        "textured": (2 if coloured else 1) if textured else 0,
        "strength": _DIM if hidden and look.hidden == "dimmed" else 1.0,
        "hidden": int(hidden),
        "dashed": int(dashed),
        "factor": _factor(look),
    }


def _lengths(look: PaperLook, dashed: bool) -> tuple[float, ...]:
    """Pixels after which dashes, or the image, repeat."""
    thin = look.strokes == "thin"
    widths = (1.0,) * 5 if thin else look.widths
    suits = (max(_DASH, _WIDE_DASH * width) for width in widths)
    if dashed and not thin:
        return tuple(suits)
    return tuple(length or one for length, one in zip(look.lengths, suits, strict=True))
