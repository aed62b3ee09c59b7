"""Checks of stylers in a window: their shaders, and that a program notices nothing of them."""

from __future__ import annotations

import io
import time
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stderr
from statistics import median
from typing import Any

import glfw
from OpenGL import GL
from OpenGL.raw.GL import _errors

from glshim import notices, pipeline
from glshim.checks import layers, scenes
from glshim.checks.finding import Check, Fault
from glshim.checks.observe import App, Outcome, observe
from glshim.checks.values import draws_of, shader_of, variants
from glshim.errors import EnvironmentFault, RenderError
from glshim.outputs.gl.backend import Backend
from glshim.outputs.gl.fixed import FixedPen
from glshim.running import headless
from glshim.styling.protocol import BackFaces, Layer, Styler

_FRAMES = 12


@contextmanager
def window() -> Iterator[Any]:
    """A hidden window with a current context. Raises `EnvironmentFault` where there is none."""
    headless.prepare()
    glfw.ERROR_REPORTING = "ignore"
    if not glfw.init():
        raise EnvironmentFault("there is no display: use --headless")
    glfw.default_window_hints()
    glfw.window_hint(glfw.VISIBLE, False)
    glfw.window_hint(glfw.STENCIL_BITS, 8)
    handle = glfw.create_window(layers.SIDE, layers.SIDE, "glshim check-style", None, None)
    if not handle:
        raise EnvironmentFault("the display cannot open an OpenGL window: use --headless")
    glfw.make_context_current(handle)
    try:
        yield handle
    finally:
        glfw.destroy_window(handle)


def _shaders_link(styler: Styler) -> str:
    """Every shader that some setting brings in is drawn with once."""
    seen: set[int] = set()
    kept: list[Any] = []  # what is seen by identity must stay
    with window():
        backend, fixed = Backend.attach(), FixedPen()
        for text, variant in [("as given", styler), *variants(styler)]:
            for layer in (layers.usual(), layers.odd()["an open surface"]):
                drawn = draws_of(variant, layer)
                shaders = [shader_of(draw) for draw in drawn if not isinstance(draw, BackFaces)]
                if not drawn or (shaders and all(id(shader) in seen for shader in shaders)):
                    continue
                seen.update(map(id, shaders))
                kept.extend(shaders)
                try:
                    _draw(backend, fixed, layer, drawn)
                except RenderError as error:
                    raise Fault(f"{text}: {error}", "see the message of the driver") from error
                except Exception as error:
                    raise Fault(
                        f"{text}: {type(error).__name__}: {error}",
                        "texts follow the preludes of glshim/outputs/gl/shaders, without #version; "
                        "uniforms fit what the shader declares",
                    ) from error
    return f"{len(seen)} shaders"


def _draw(backend: Backend, fixed: FixedPen, layer: Layer, drawn: list[Any]) -> None:
    scenes.prepare(layers.SIDE)
    for mesh, _ in layer.items:
        scenes.draw(mesh)
    faces = [draw for draw in drawn if isinstance(draw, BackFaces)]
    others = [draw for draw in drawn if not isinstance(draw, BackFaces)]
    if faces:
        fixed.render(faces)
    if others:
        backend.render(others)


def _nothing_is_noticed(styler: Styler) -> str:
    for scene in (*scenes.RESTYLED, *scenes.UNTOUCHED):
        plain, styled = _outcome(scene, None), _outcome(scene, styler)
        different = plain.differences(styled, pictures=False)
        if different:
            name, what = next(iter(different.items()))
            raise Fault(
                f"{scene.__name__}: {name} is not as the program left it: {what}",
                "a styler calls no OpenGL: it gives draws, and their State says how",
            )
    return f"{len(scenes.RESTYLED) + len(scenes.UNTOUCHED)} scenes"


def _nothing_else_is_drawn_over(styler: Styler) -> None:
    for scene in scenes.UNTOUCHED:
        plain, styled = _outcome(scene, None), _outcome(scene, styler)
        count = plain.changed_pixels(styled)
        if count:
            raise Fault(
                f"{scene.__name__}: {count} pixels are not the program's own",
                "draw for the polygons of the layer alone",
            )
    half = layers.SIDE // 2
    plain, styled = _outcome(scenes.one_half, None), _outcome(scenes.one_half, styler)
    beside = int((plain.picture[:, half:] != styled.picture[:, half:]).any(axis=2).sum())
    if beside:
        raise Fault(
            f"{beside} pixels beside the viewport are not the program's own",
            "draw with the cameras of the layer",
        )


def _outcome(scene: scenes.Scene, styler: Styler | None) -> Outcome:
    """The scene in a window of its own, plain or styled. Raises `Fault` where the style was
    switched off."""
    app = App()
    with window() as handle, _installed(styler) as said:
        for _ in range(2):
            scenes.prepare(layers.SIDE)
            app.tries(scene)
            GL.glGetError()
            found = observe(app, layers.SIDE, layers.SIDE)
            glfw.swap_buffers(handle)
    if "is switched off" in said.getvalue():
        lines = [line.strip() for line in said.getvalue().splitlines()]
        place = next((line for line in reversed(lines) if line.startswith("File ")), "")
        raise Fault(
            f"{scene.__name__}: the style is switched off: {lines[-1]} ({place})",
            "fix the exception",
        )
    return found


@contextmanager
def _installed(styler: Styler | None) -> Iterator[io.StringIO]:
    """The style in force, and what glshim says meanwhile."""
    _errors._error_checker.onEnd()
    said = io.StringIO()
    notices.forget("")
    with redirect_stderr(said):
        if styler is not None:
            pipeline.install(styler)
        try:
            yield said
        finally:
            pipeline.uninstall()
            _errors._error_checker.onEnd()


def _time(styler: Styler) -> str:
    plain, styled = _milliseconds(None), _milliseconds(styler)
    return f"{styled:.1f} ms, plain {plain:.1f} ms: {styled / plain:.1f} times"


def _milliseconds(styler: Styler | None) -> float:
    """The median time of a frame of a list of 4,608 quads, all drawing done."""
    with window() as handle, _installed(styler):
        name = int(GL.glGenLists(1))
        scenes.prepare(layers.SIDE)
        GL.glNewList(name, GL.GL_COMPILE)
        scenes.draw(layers.torus(96, 48))
        GL.glEndList()
        times = []
        for frame in range(_FRAMES):
            begin = time.perf_counter()
            scenes.prepare(layers.SIDE)
            GL.glRotatef(3.0 * frame, 0.0, 0.0, 1.0)
            GL.glCallList(name)
            glfw.swap_buffers(handle)
            GL.glFinish()
            times.append(1000.0 * (time.perf_counter() - begin))
    return median(times[_FRAMES // 3 :])


CHECKS = (
    Check("its shaders compile and draw", _shaders_link),
    Check("state, errors and depth stay the program's own", _nothing_is_noticed),
    Check("what carries no lines looks as it does plain", _nothing_else_is_drawn_over),
    Check("a frame of 4,608 quads in a list", _time),
)
