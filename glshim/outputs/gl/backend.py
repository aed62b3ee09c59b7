"""Lines and passes of stylers into the app's framebuffer."""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import groupby

import numpy as np
from numpy.typing import NDArray

from glshim.driver.ask import integer
from glshim.driver.context import MODERN, UNAVAILABLE, shortcoming, version_text
from glshim.driver.functions import current_context
from glshim.errors import RenderError
from glshim.linework.crowded import crowded
from glshim.linework.finder import LineFinder
from glshim.linework.groups import Group, grouped
from glshim.model.batch import Item
from glshim.model.camera import Camera
from glshim.notices import say_once
from glshim.outputs.gl.device.arrays import put_the_apps_arrays_away
from glshim.outputs.gl.device.devices import Device, ModernDevice, attach
from glshim.outputs.gl.device.guard import Guard, possible
from glshim.outputs.gl.device.plain import plainly
from glshim.outputs.gl.device.programs import Lost
from glshim.outputs.gl.device.textures import Textures
from glshim.outputs.gl.frame.cameras import box_of, scissor, stencil, turned
from glshim.outputs.gl.frame.canvas import Canvas
from glshim.outputs.gl.frame.depth import Box, DepthCopy
from glshim.outputs.gl.frame.depth_fill import DepthFill
from glshim.outputs.gl.frame.frame import Frame, depth_margin
from glshim.outputs.gl.frame.own_ink import OwnInk
from glshim.outputs.gl.lines.crossings import Crossings
from glshim.outputs.gl.lines.legacy import LegacyPen
from glshim.outputs.gl.lines.pen import Pen
from glshim.outputs.gl.passes.runner import Runner
from glshim.outputs.output import WINDOW, Destination
from glshim.spec.constants import (
    GL_DEPTH_BITS,
    GL_DEPTH_FUNC,
    GL_DRAW_FRAMEBUFFER_BINDING,
    GL_GEQUAL,
    GL_GREATER,
)
from glshim.styling.lines import Lines
from glshim.styling.passes import Pass
from glshim.styling.values import in_order
from glshim.styling.wishes import Choice

_FILLED_BITS = 24
"""Bits of the depth buffer that stands in where a window has none."""


class Backend:
    """Draws extra geometry in one GL context. Make it with `attach` while that is current."""

    def __init__(self, device: Device, cache_bytes: int, ring_bytes: int) -> None:
        self._device = device
        self.pen: Pen | LegacyPen
        self._crossings: Crossings | None = None
        if isinstance(device, ModernDevice):
            self.pen = Pen(device, ring_bytes)
            self._crossings = Crossings(device, cache_bytes // 2)
        else:
            self.pen = LegacyPen(device)
        self._finder = LineFinder(cache_bytes)
        self._depth = DepthCopy()
        self._canvas = Canvas(device)
        self.own_ink = OwnInk(device)
        self._textures = Textures()
        self._depth_fill: DepthFill | None = None
        self._runner: Runner | None = None
        self._met: dict[Hashable, NDArray[np.float32]] = {}
        """Where polygons of a group of the layer cross each other."""
        self._cache_bytes = cache_bytes

    @classmethod
    def attach(cls, *, cache_bytes: int = 256 << 20, ring_bytes: int = 8 << 20) -> Backend:
        """A backend in the current context, whose state stays as it was.

        cache_bytes bounds the memory of the edges of batches with a key; ring_bytes is the GPU
        memory through which lines stream (it grows when one draw needs more). Raises
        `RenderError` when no context is current, or it is not one that lines can be drawn in.
        """
        if not current_context() or not version_text():
            raise RenderError("no GL context is current: nothing can be drawn")
        lacking = shortcoming()
        if lacking:
            raise RenderError(lacking)
        if not possible():
            raise RenderError("GL is compiling a list, selecting, or its attribute stack is full")
        try:
            device = attach()
            with Guard():
                return cls(device, cache_bytes, ring_bytes)
        except Exception as error:
            text = f"no drawing in this context ({version_text()}): {error}"
            raise RenderError(text) from error

    def abandon(self) -> None:
        """Its context is gone: see `Device.abandon`."""
        self._device.abandon()

    def render(self, draws: Iterable[Lines | Pass], destination: Destination = WINDOW) -> None:
        """Add draws to the framebuffer that is bound, against its depth, and touch nothing else.

        Where it has no depth buffer, the batches' own depth is laid down elsewhere. Does nothing
        where GL cannot draw now (a list being compiled, selection, a full attribute stack). Raises
        `RenderError` when a shader does not compile, and `Lost`.
        """
        self._finder.tick()
        self._met.clear()
        if self._crossings is not None:
            self._crossings.tick()
        if self._runner is not None:
            self._runner.residents.tick()
        runs = _runs(draws)
        items = [item for run in runs for item in run.items]
        if not items or not possible():
            return
        if not self._device.is_whole:
            raise Lost
        box = box_of((camera for _, camera in items), destination.bounds)
        if not box[2] or not box[3]:
            return
        with Guard():
            frame = self._frame(box, items, destination)
            for run in runs:
                if run.passes:
                    self._run(run.passes, frame)
                # The app's stencil test holds where the ink goes over its picture.
                for _, alike in groupby(run.lines, key=lambda group: group.camera.stencil):
                    self._ink(list(alike), frame)

    def _frame(self, box: Box, items: list[Item], destination: Destination) -> Frame:
        """The framebuffer that is bound, and plain state for drawing over it."""
        framebuffer = integer(GL_DRAW_FRAMEBUFFER_BINDING)
        bits = integer(GL_DEPTH_BITS)
        reversed_depth = integer(GL_DEPTH_FUNC) in (GL_GREATER, GL_GEQUAL)
        plainly()
        put_the_apps_arrays_away()
        if not bits or not self._depth.take(box, bits):
            if self._depth_fill is None:
                self._depth_fill = DepthFill(self._device)
            self._depth_fill.fill(self._depth, items, box, reversed_depth)
        margin = depth_margin(bits or _FILLED_BITS)
        return Frame(self._depth, margin, reversed_depth, framebuffer, box, destination)

    def _run(self, passes: list[Pass], frame: Frame) -> None:
        """Passes in turn, laid over the frame."""
        if not isinstance(self._device, ModernDevice):
            say_once("this style's passes need OpenGL {}.{}".format(*MODERN))
            return
        if self._runner is None:
            self._runner = Runner(self._device, self._finder.objects, self._cache_bytes)
        for camera, some in _by_stencil(passes):
            self._runner.run(some, frame, self._textures, last=camera)

    def _ink(self, groups: list[Group], frame: Frame) -> None:
        """Gather the ink of groups and lay it over the frame."""
        self._canvas.open(frame.box)
        for group in groups:
            medium = group.medium
            records = self._finder.records(group)
            crossing = isinstance(group.wanted, Choice) and group.wanted.intersections
            if crossing and self._crossings is None:
                say_once(f"{UNAVAILABLE}; the other lines are drawn")
            elif crossing and self._crossings:
                records = np.concatenate((records, self._crossed(group, frame)))
            if not len(records):
                continue
            if group.uniforms.get("hidden_share", 0.0):
                records = crowded(records, group.camera)
            camera = turned(group.camera, frame.reversed_depth)
            if medium.image is not None:
                self._textures.bind(medium.image)
            scissor(camera, frame.box)
            self.pen.draw(records, camera, medium.shader, group.uniforms, frame)
        stencil(groups[0].camera)
        tidy = all(group.medium.image is None for group in groups)
        self._canvas.put_over(frame.framebuffer, frame.box, tidy=tidy)

    def _crossed(self, group: Group, frame: Frame) -> NDArray[np.float32]:
        """Records of the crossings of a group's polygons, found once a layer."""
        name = group.name
        found = self._met.get(name)
        if found is None:
            assert self._crossings is not None
            found = self._crossings.find(group.items, frame)
            if group.wanted.pattern is not None:
                self._finder.lay_on_crossings(found, group)
            self._met[name] = found
        return found


@dataclass(frozen=True, slots=True)
class _Run:
    """Lines, or passes, that follow each other in one coat."""

    lines: list[Group]
    passes: list[Pass]

    @property
    def items(self) -> list[Item]:
        """All batches, each with its camera."""
        drawn = [item for group in self.lines for item in group.items]
        return drawn + [item for one in self.passes for item in in_order(one.bodies)]


def _by_stencil(passes: list[Pass]) -> Iterator[tuple[Camera, list[Pass]]]:
    """Passes parted by the app's stencil tests, which hold where they go over its picture, and
    a camera that has the test. What prepares the depth of whole windows is in every part."""
    cameras = {body.camera.stencil: body.camera for one in passes for body in one.bodies}
    if len(cameras) == 1:
        yield next(iter(cameras.values())), passes
        return
    for test, camera in cameras.items():
        parts = []
        for one in passes:
            whole = one.element == "screen" and not one.state.writes_colour
            own = [body for body in one.bodies if whole or body.camera.stencil == test]
            parts.append(replace(one, bodies=tuple(own)))
        yield camera, [one for one in parts if one.bodies]


def _runs(draws: Iterable[Lines | Pass]) -> list[_Run]:
    """Neighbours of one kind and one coat together."""
    found: list[_Run] = []
    for (passes, _), alike in groupby(draws, key=lambda one: (_is_pass(one), one.coat)):
        run = list(alike)
        lines = [] if passes else grouped(one for one in run if isinstance(one, Lines))
        found.append(_Run(lines, [one for one in run if isinstance(one, Pass)]))
    return found


def _is_pass(one: object) -> bool:
    if not isinstance(one, (Lines, Pass)):
        raise TypeError(f"a styler draws with Lines and Pass, not with {type(one).__name__}")
    return isinstance(one, Pass)
