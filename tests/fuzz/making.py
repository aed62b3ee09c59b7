"""Programs from a seed and a number, the same on each machine."""

from __future__ import annotations

import random
from functools import cache

import tests.fuzz.areas  # noqa: F401 (registers what programs do)
from tests.fuzz.program import FLAGS, Program
from tests.fuzz.writing import AREAS, Writer

BATCH = 50
"""So many neighbours share flags and a style, and thereby processes."""
OTHERS = (
    "raskar:ridges=off", "edge_mesh:marked=on,smooth=on,suggestive=on,texture=pen,hidden=dashed",
    "edge_mesh:strokes=half,outer=on,hidden=dimmed", "two_pass:fill=#ff8000", "shadow:light=fixed",
    "fins:fill=cel,joints=overhang", "crease:texture=pen,hidden_by=back_faces,indicator=verifiers",
    "sketch:boil=8", "blueprint:dimensions=1", "hiddenline:edges=all,hidden=dashed",
    "cartoon:textures=off,shade_unlit=head", "cartoon+crease:contour.dash=9", "fur+hiddenline",
    "two_pass:dash=12,ridges=on,ridge.texture=pen", "fins:dash=9,valleys=on", "pencil:dash=12",
)  # fmt: skip
"""Beside every installed styler and look: options that take other ways."""


@cache
def styles() -> tuple[str, ...]:
    """Every style that draws."""
    from glshim.styling import registry

    return (*(name for name in registry.names() if name != "none"), *registry.looks(), *OTHERS)


def program(seed: int, number: int) -> Program:
    """The program of that number."""
    batch = number // BATCH
    flags = _flags(seed, batch)
    w = Writer(random.Random(f"{seed} {number}"))
    w.sizes = flags != "unsized"
    _window(w)
    for _ in range(w.whole(1, 3)):
        _frame(w)
    _end(w)
    return Program(
        seed,
        number,
        flags,
        styles()[(seed + batch) % len(styles())],
        tuple(w.steps),
    )


def _flags(seed: int, batch: int) -> str:
    chance = random.Random(f"flags {seed} {batch}")
    return chance.choice(list(FLAGS)) if chance.random() < 0.35 else ""


def _window(w: Writer) -> None:
    hints = w.weighted({
        "": 20, "SAMPLES=4": 1, "DOUBLEBUFFER=0": 1.5, "STENCIL_BITS=0": 1, "DEPTH_BITS=0": 1,
        "OPENGL_DEBUG_CONTEXT=1": 2, "ALPHA_BITS=0": 0.5,
        "ACCUM_RED_BITS=16, ACCUM_GREEN_BITS=16": 1,
        "CONTEXT_VERSION_MAJOR=2, CONTEXT_VERSION_MINOR=1": 1,
        "CONTEXT_VERSION_MAJOR=3, CONTEXT_VERSION_MINOR=3, OPENGL_PROFILE=0x32001": 0.5,
        "STEREO=1": 0.1,
    })  # fmt: skip
    w.say(f"a = window({hints})")
    w.names["window"] = ["a"]


def _frame(w: Writer) -> None:
    if w.maybe(0.85):
        w.say("GL.glClear(0x4100)")
    if w.maybe(0.8):
        w.say("GL.glEnable(GL.GL_DEPTH_TEST)")
    if w.maybe(0.5):
        w.say("GL.glMatrixMode(GL.GL_PROJECTION)", "GL.glLoadIdentity()",
              "GL.glFrustum(-1.0, 1.0, -0.75, 0.75, 2.0, 20.0)",
              "GL.glMatrixMode(GL.GL_MODELVIEW)", "GL.glLoadIdentity()",
              "GL.glTranslatef(0.0, 0.0, -4.0)")  # fmt: skip
    areas, weights = list(AREAS), list(AREAS.values())
    for _ in range(w.whole(1, 9)):
        w.chance.choices(areas, weights)[0](w)
    w.say("swap()" if w.maybe(0.7) else "swap(False)")


def _end(w: Writer) -> None:
    """Whatever is open is closed, and every stack is looked through."""
    w.say("GL.glEnd()", "GL.glEndList()", "GL.glGetError()", "GL.glGetError()", "swap()")
