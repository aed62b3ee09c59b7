"""The program's own text and lines, gathered on a canvas of ours while it draws them, and laid over
its picture in colours that can be read there.

What they are drawn with stays the program's: only the framebuffer is another. So smooth edges,
stipples, fog and fonts are as ever, and what the style lays under them does not cover them.
"""

from __future__ import annotations

from glshim.driver.ask import integer, is_enabled, reals
from glshim.driver.context import has_turned_framebuffers
from glshim.driver.functions import gl
from glshim.outputs.gl.device.arrays import put_the_apps_arrays_away
from glshim.outputs.gl.device.devices import Device
from glshim.outputs.gl.device.guard import Guard, possible
from glshim.outputs.gl.device.plain import plainly
from glshim.outputs.gl.device.programs import shader_text
from glshim.outputs.gl.device.target import RenderTarget
from glshim.outputs.gl.frame.canvas import fill_viewport
from glshim.outputs.gl.frame.colour import UNIT as COLOUR_UNIT
from glshim.outputs.gl.frame.colour import ColourCopy
from glshim.outputs.gl.frame.depth import UNIT as DEPTH_UNIT
from glshim.outputs.gl.frame.depth import Box, DepthCopy
from glshim.outputs.gl.frame.frame import depth_margin
from glshim.outputs.output import Destination, Ink
from glshim.spec.constants import (
    GL_BLEND,
    GL_BLEND_DST_ALPHA,
    GL_BLEND_DST_RGB,
    GL_BLEND_EQUATION,
    GL_BLEND_SRC_ALPHA,
    GL_BLEND_SRC_RGB,
    GL_COLOR_BUFFER_BIT,
    GL_COLOR_CLEAR_VALUE,
    GL_COLOR_LOGIC_OP,
    GL_DEPTH_BITS,
    GL_DEPTH_BUFFER_BIT,
    GL_DEPTH_COMPONENT24,
    GL_DEPTH_COMPONENT32F,
    GL_DEPTH_TEST,
    GL_DRAW_FRAMEBUFFER,
    GL_FRAMEBUFFER,
    GL_FRAMEBUFFER_FLIP_Y_MESA,
    GL_FUNC_ADD,
    GL_LESS,
    GL_NO_ERROR,
    GL_ONE,
    GL_ONE_MINUS_SRC_ALPHA,
    GL_RGBA8,
    GL_SCISSOR_TEST,
    GL_SRC_ALPHA,
    GL_STENCIL_TEST,
    GL_ZERO,
)

_INK_UNIT, _DEPTH_UNIT = 13, 14
_LAID = {
    (GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA): (GL_ONE, GL_ONE_MINUS_SRC_ALPHA),
    (GL_ONE, GL_ONE_MINUS_SRC_ALPHA): (GL_ONE, GL_ONE_MINUS_SRC_ALPHA),
    (GL_SRC_ALPHA, GL_ONE): (GL_ZERO, GL_ONE),
    (GL_ONE, GL_ONE): (GL_ZERO, GL_ONE),
    (GL_ONE, GL_ZERO): (GL_ONE, GL_ZERO),
}
"""By blend factors of the program's colours, those with which alpha becomes what is covered; light
that is added covers nothing by itself. Ink that is blended in another way is drawn as ever."""
_FACTORS = (GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA, GL_BLEND_DST_ALPHA)


class OwnInk:
    """Of one context."""

    def __init__(self, device: Device) -> None:
        self._device = device
        # Floats, as depths are before a buffer rounds them: what is written back is rounded alike.
        kind = GL_DEPTH_COMPONENT32F if device.modern else GL_DEPTH_COMPONENT24
        self._target = RenderTarget(GL_RGBA8, unit=_INK_UNIT, deep=(kind, _DEPTH_UNIT))
        self._ground, self._depth = ColourCopy(), DepthCopy()
        self._turned = False
        """Its rows lie from the top downwards."""
        self._box: Box = (0, 0, 0, 0)
        """Where something was gathered, at most."""
        self._waits = False
        """Something was gathered and not laid."""
        self._hides = True
        """All of it writes depth."""
        self._program = device.program("own ink", *_texts(device))
        self._ink: Ink | None = None
        """The draw that is under way."""
        self._factors: tuple[int, ...] = ()
        """Blend factors of the program's that were changed for it."""

    def begin(self, ink: Ink) -> bool:
        """Before the app's draw, outside primitives. Whether it is gathered."""
        if self._ink is not None or is_enabled(GL_COLOR_LOGIC_OP) or is_enabled(GL_STENCIL_TEST):
            return False
        factors: tuple[int, ...] = ()
        if is_enabled(GL_BLEND):
            factors = tuple(integer(name) for name in _FACTORS)
            if factors[:2] not in _LAID or integer(GL_BLEND_EQUATION) != GL_FUNC_ADD:
                return False
        if not self._open(ink.viewport):
            return False
        # Each step can be undone before it is made, and twice: a signal handler may raise between.
        self._ink, self._factors = ink, () if ink.listed else factors
        gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, self._target.name)
        if self._factors:
            gl.glBlendFuncSeparate(*factors[:2], *_LAID[factors[0], factors[1]])
        if not ink.listed and ink.tested and not ink.written:
            gl.glDepthMask(1)
        self._waits = True
        self._hides &= ink.written
        return True

    def end(self) -> None:
        """After it."""
        ink = self._ink
        if ink is None:
            return
        gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, ink.framebuffer)
        if self._factors:
            gl.glBlendFuncSeparate(*self._factors)
        if not ink.listed and ink.tested and not ink.written:
            gl.glDepthMask(0)
        self._ink, self._factors = None, ()

    def lay(
        self, framebuffer: int, destination: Destination, *, tested: bool, recoloured: bool
    ) -> None:
        """Over the app's picture; afterwards nothing waits. tested: behind surfaces it does not.
        recoloured: in colours that can be read there."""
        if not self._waits or not possible():
            return
        with Guard():
            plainly()
            put_the_apps_arrays_away()
            gl.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer)
            box = self._box
            bits = integer(GL_DEPTH_BITS)
            tested = tested and bits > 0 and self._depth.take(box, bits)
            if recoloured:
                self._ground.take(framebuffer, box)
            self._draw(box, destination.scale, depth_margin(bits or 24), tested, recoloured)
            self._clear()
        self._waits, self._hides = False, True

    def _draw(
        self, box: Box, scale: float, margin: float, tested: bool, recoloured: bool
    ) -> None:
        """What was gathered, over the framebuffer that is bound."""
        self._target.bind_texture()
        self._target.bind_depth()
        gl.glEnable(GL_SCISSOR_TEST)
        gl.glScissor(*box)
        gl.glViewport(0, 0, *self._target.size)
        gl.glEnable(GL_BLEND)
        gl.glBlendEquation(GL_FUNC_ADD)
        gl.glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA)
        x, y, width, height = box
        self._program.use({
            "ink": _INK_UNIT, "ink_depth": _DEPTH_UNIT, "ground": COLOUR_UNIT,
            "finished_depth": DEPTH_UNIT, "ink_size": self._target.size,
            "ground_size": self._ground.size, "depth_size": self._depth.size,
            "home": reals(GL_COLOR_CLEAR_VALUE, 3),
            "tested": int(tested), "recoloured": int(recoloured), "hair": margin, "scale": scale,
            "turned": int(self._turned),
            "box": (x + 0.5, y + 0.5, x + width - 0.5, y + height - 0.5),
        })  # fmt: skip
        fill_viewport()
        if tested and self._hides:
            gl.glEnable(GL_DEPTH_TEST)
            gl.glDepthFunc(GL_LESS)
            gl.glDepthMask(1)
            gl.glDepthRange(0.0, 1.0)
            gl.glColorMask(0, 0, 0, 0)
            self._program.set({"tested": 0, "recoloured": 0})
            fill_viewport()

    def _open(self, viewport: Box) -> bool:
        """Have room for what a viewport shows; whether there is some."""
        x, y, width, height = viewport
        right, top = x + width, y + height
        size = self._target.size
        if right > size[0] or top > size[1] or not self._target.name:
            if self._waits or not possible() or min(right, top) <= 0:
                return False
            with Guard():
                plainly()
                self._target.fit(right, top)
                self._target.bind()
                self._turned = _turn()
                self._clear()
        self._box = 0, 0, max(right, self._box[2]), max(top, self._box[3])
        return True

    def _clear(self) -> None:
        """Nothing is gathered. Inside the guard."""
        self._target.bind(GL_DRAW_FRAMEBUFFER)
        gl.glDisable(GL_SCISSOR_TEST)
        gl.glColorMask(1, 1, 1, 1)
        gl.glDepthMask(1)
        gl.glClearColor(0.0, 0.0, 0.0, 0.0)
        gl.glClearDepth(1.0)
        gl.glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)


def _texts(device: Device) -> tuple[str, str]:
    head = f"#version {130 if device.modern else 120}\n"
    return head + shader_text("over.vert.glsl"), head + shader_text("own_ink.frag.glsl")


def _turn() -> bool:
    """Have the framebuffer object that is bound the way up that windows are in Mesa, so that lines
    fall on the same pixels, at the same depths; whether that can be had."""
    if not has_turned_framebuffers():
        return False
    gl.glFramebufferParameteri(GL_FRAMEBUFFER, GL_FRAMEBUFFER_FLIP_Y_MESA, 1)
    return bool(gl.glGetError() == GL_NO_ERROR)
