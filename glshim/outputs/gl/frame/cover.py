"""The base polygons in another surface than the app's: depth only, one flat colour, or the app's
own paints without its light.

The app's own draw is made with colour writes off, or with a program whose vertices are exactly the
fixed function's (``ftransform``), so its depth stays bit for bit the app's.
"""

from __future__ import annotations

import threading
from collections.abc import Sequence

from glshim.driver.ask import integer, integers, is_enabled
from glshim.driver.functions import current_context, gl
from glshim.driver.queries import counting
from glshim.driver.unnoticed import Unnoticed
from glshim.model.lights import MaterialChange, Materials
from glshim.outputs.gl.device.devices import Device, attach
from glshim.outputs.gl.device.programs import Program, shader_text
from glshim.outputs.gl.frame.all_around import AllAround
from glshim.outputs.gl.frame.flood import Flood
from glshim.outputs.gl.frame.paint import Paint
from glshim.spec.constants import (
    GL_ALPHA_TEST,
    GL_BLEND,
    GL_COLOR_MATERIAL,
    GL_COLOR_MATERIAL_PARAMETER,
    GL_COLOR_WRITEMASK,
    GL_DIFFUSE,
)
from glshim.styling.protocol import PAINTED, Colour


class _Draw(threading.local):
    """The draw of a thread."""

    covered = False
    enabled: Sequence[int] = ()
    """What flat colours turned off."""
    mask: tuple[int, ...] = (1, 1, 1, 1)
    flood: Flood | AllAround | None = None
    """What a paint whose materials change within the draw is seen by."""


def _flood(materials: Materials) -> Flood | AllAround:
    """What shows the changes of materials."""
    if materials is Materials.SHADE or (
        materials is Materials.VARY
        and is_enabled(GL_COLOR_MATERIAL)
        and integer(GL_COLOR_MATERIAL_PARAMETER) == GL_DIFFUSE
    ):
        return AllAround()
    return Flood(mirrors=materials is Materials.SAID)


class Cover:
    """Covers the app's draws with a styler's surface."""

    def __init__(self) -> None:
        self._surface: str | Colour = "app"
        self._devices: dict[int, Device] = {}
        self._flats: dict[int, Program] = {}
        """By context."""
        self._paints: dict[tuple[int, bool], Paint] = {}
        """By context, and whether they have textures."""
        self._draw = _Draw()

    def set_surface(self, surface: str | Colour) -> None:
        """Another one from now on: see `Styler.surface`; ``"app"`` covers nothing."""
        self.uncover()
        self._surface = surface

    def cover(self, materials: Materials = Materials.STAY) -> None:
        """Before the app's draw, outside primitives; no program of the app's is in use.
        materials: what they do during it; a program cannot follow their changes."""
        if self._surface == "app" or self._draw.covered:
            return
        if is_enabled(GL_ALPHA_TEST) and counting():  # what fails the test in its own colours
            return
        # Each step can be undone before it is made, and twice: a signal handler may raise between.
        if self._surface in PAINTED:
            if materials is not Materials.STAY:
                self._draw.flood = _flood(materials)
                self._draw.covered = True
                self._draw.flood.begin()
                return
            paint = self._paint()
            self._draw.covered = True
            self._draw.covered = paint.begin()
            return
        if isinstance(self._surface, str):
            self._draw.mask = integers(GL_COLOR_WRITEMASK, 4)
            self._draw.covered = True
            gl.glColorMaski(0, 0, 0, 0, 0)
            return
        program = self._flat()
        self._draw.enabled = [each for each in (GL_BLEND, GL_ALPHA_TEST) if is_enabled(each)]
        self._draw.covered = True
        for switch in self._draw.enabled:
            if switch == GL_BLEND:  # of the first buffer alone: others may be as they are
                gl.glDisablei(switch, 0)
            else:
                gl.glDisable(switch)
        program.use({"colour": (*self._surface, 1.0)})

    def uncover(self) -> None:
        """After it."""
        if not self._draw.covered:
            return
        if self._draw.flood is not None:
            self._draw.flood.end()
            self._draw.flood = None
        elif self._surface in PAINTED:
            self._paint().end()
        elif isinstance(self._surface, str):
            gl.glColorMaski(0, *(int(bool(m)) for m in self._draw.mask))
        else:
            gl.glUseProgram(0)
            for switch in self._draw.enabled:
                if switch == GL_BLEND:
                    gl.glEnablei(switch, 0)
                else:
                    gl.glEnable(switch)
        self._draw.covered = False

    def material(self, change: MaterialChange) -> None:
        """After a glMaterial inside the primitive that is covered."""
        if self._draw.covered and self._draw.flood is not None:
            self._draw.flood.say(change)

    def release(self) -> None:
        """Delete what was made in the current context, and forget what was in others, which may go
        unheard from now on and leave their addresses to new ones. Outside glBegin/glEnd."""
        here = current_context()
        if here in self._flats:
            self._flats[here].release()
        for (context, _), paint in self._paints.items():
            if context == here:
                paint.release()
        for context in [*self._devices]:
            self.forget(context)

    def forget(self, context: int) -> None:
        """What was made in a context is gone. Calls no GL."""
        self._flats.pop(context, None)
        for textures in (True, False):
            self._paints.pop((context, textures), None)
        device = self._devices.pop(context, None)
        if device is not None:
            device.abandon()

    def _paint(self) -> Paint:
        key = current_context(), self._surface == "paint"
        if key not in self._paints:
            with Unnoticed():
                self._paints[key] = Paint(self._device(), textures=key[1])
        return self._paints[key]

    def _device(self) -> Device:
        context = current_context()
        if context not in self._devices:
            self._devices[context] = attach()
        return self._devices[context]

    def _flat(self) -> Program:
        context = current_context()
        if context not in self._flats:
            texts = shader_text("surface.vert.glsl"), shader_text("surface.frag.glsl")
            with Unnoticed():
                self._flats[context] = self._device().program("surface", *texts)
        return self._flats[context]
