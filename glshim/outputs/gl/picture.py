"""The OpenGL picture as an output: what stylers give is drawn over the app's own frame."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress

from glshim.driver.functions import current_context
from glshim.driver.objects import context_ended, tidy
from glshim.errors import RenderError
from glshim.model.boxes import Box, Unbacked
from glshim.model.lights import MaterialChange, Materials
from glshim.notices import say_once
from glshim.outputs.gl.backend import Backend
from glshim.outputs.gl.background import lay, lift
from glshim.outputs.gl.device.programs import Lost
from glshim.outputs.gl.fixed import FixedPen
from glshim.outputs.gl.frame.behind import brightness_behind
from glshim.outputs.gl.frame.cover import Cover
from glshim.outputs.output import Context, Destination, Given, Ink, Output
from glshim.styling.protocol import BackFaces, Colour, Layer, Styler


class Picture(Output):
    """One serves all contexts. What it makes in them outlives a style: switching styles makes no
    new buffers and programs."""

    def __init__(self) -> None:
        self._cover = Cover()
        self._background: Colour | None = None
        self._fixed = FixedPen()
        self._backends: dict[int, tuple[Context, Backend]] = {}
        """By the current context's handle, with the context that each was made for, which knows
        when it is gone."""

    def set_styler(self, styler: Styler | None) -> None:
        self._cover.set_surface(styler.surface if styler is not None else "app")
        self._background = styler.background if styler is not None else None

    def lay_background(self, places: Unbacked) -> bool:
        return self._background is not None and lay(places, self._background)

    def lift_background(self, box: Box, own: Colour) -> tuple[Box, ...]:
        return () if self._background is None else lift(box, self._background, own)

    def cover(self, materials: Materials = Materials.STAY) -> None:
        try:
            self._cover.cover(materials)
        except Lost:
            self._cover.uncover()
            self._lost()
            self._cover.cover(materials)

    def material(self, change: MaterialChange) -> None:
        self._cover.material(change)

    def uncover(self) -> None:
        self._cover.uncover()

    def gather_ink(self, ink: Ink, context: Context, *, first: bool) -> bool:
        try:
            backend = self._backend(context) if first else self._known()
            return backend is not None and backend.own_ink.begin(ink)
        except (RenderError, Lost):
            return False

    def ink_gathered(self) -> None:
        backend = self._known()
        if backend is not None:
            backend.own_ink.end()

    def lay_ink(
        self, framebuffer: int, destination: Destination, *, tested: bool, recoloured: bool
    ) -> None:
        backend = self._known()
        if backend is not None:
            with suppress(Lost):
                backend.own_ink.lay(
                    framebuffer, destination, tested=tested, recoloured=recoloured
                )  # fmt: skip

    def _known(self) -> Backend | None:
        """The backend of the current context, if one was made."""
        return self._backends.get(current_context(), (None, None))[1]

    def add(
        self, given: Sequence[Given], layer: Layer, destination: Destination, context: Context
    ) -> None:
        faces = [one for one in given if isinstance(one, BackFaces)]
        others = [one for one in given if not isinstance(one, BackFaces)]
        tidy()
        if faces:
            context.mark()
            self._fixed.render(faces)
        if others:
            try:
                self._backend(context).render(others, destination)
            except Lost:
                self._lost()
                self._backend(context).render(others, destination)

    def brightness_behind(self, layer: Layer) -> float | None:
        return brightness_behind(layer.items[0][1].viewport)

    def forget(self, handle: int) -> None:
        self._cover.forget(handle)
        context_ended(handle)
        _, backend = self._backends.pop(handle, (None, None))
        if backend is not None:
            backend.abandon()

    def release(self) -> None:
        self._cover.release()

    def _lost(self) -> None:
        """What is left of ours in the current context is of no use."""
        say_once("the program has deleted objects of glshim's: they are made anew")
        self.forget(current_context())
        tidy()  # before what is made anew gets such names

    def _backend(self, context: Context) -> Backend:
        """The current context's backend."""
        handle = current_context()
        # Asked before the new one gets its mark: in another context that may have the same name.
        owner, backend = self._backends.get(handle, (context, None))
        if backend is not None and owner.stale:
            self.forget(handle)
            backend = None
        if backend is None:
            # What was followed by another pipeline is looked after here.
            for gone in [other for other, (owner, _) in self._backends.items() if owner.gone]:
                self.forget(gone)
            backend = Backend.attach()
            self._backends[handle] = context, backend
        context.mark()
        return backend
