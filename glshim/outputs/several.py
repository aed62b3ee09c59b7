"""Several outputs as one."""

from __future__ import annotations

from collections.abc import Sequence

from glshim.errors import RenderError
from glshim.model.boxes import Box, Unbacked
from glshim.model.lights import MaterialChange, Materials
from glshim.outputs.output import Context, Destination, Given, Ink, Output
from glshim.styling.protocol import Layer, Styler
from glshim.styling.values import Colour


class Several(Output):
    """Each is told all of it, in order."""

    def __init__(self, outputs: Sequence[Output]) -> None:
        self._outputs = outputs

    def set_styler(self, styler: Styler | None) -> None:
        for output in self._outputs:
            output.set_styler(styler)

    def lay_background(self, places: Unbacked) -> bool:
        return all([output.lay_background(places) for output in self._outputs])

    def lift_background(self, box: Box, own: Colour) -> tuple[Box, ...]:
        return tuple(each for output in self._outputs for each in output.lift_background(box, own))

    def cover(self, materials: Materials = Materials.STAY) -> None:
        for output in self._outputs:
            output.cover(materials)

    def material(self, change: MaterialChange) -> None:
        for output in self._outputs:
            output.material(change)

    def uncover(self) -> None:
        for output in self._outputs:
            output.uncover()

    def gather_ink(self, ink: Ink, context: Context, *, first: bool) -> bool:
        return any([output.gather_ink(ink, context, first=first) for output in self._outputs])

    def ink_gathered(self) -> None:
        for output in self._outputs:
            output.ink_gathered()

    def lay_ink(
        self, framebuffer: int, destination: Destination, *, tested: bool, recoloured: bool
    ) -> None:
        for output in self._outputs:
            output.lay_ink(framebuffer, destination, tested=tested, recoloured=recoloured)

    def add(
        self, given: Sequence[Given], layer: Layer, destination: Destination, context: Context
    ) -> None:
        """Raises `Refused` where some cannot show it, once the others have it."""
        refusals = []
        for output in self._outputs:
            try:
                output.add(given, layer, destination, context)
            except RenderError as error:
                refusals.append(str(error))
        if refusals:
            raise Refused(refusals, all_of_them=len(refusals) == len(self._outputs))

    def brightness_behind(self, layer: Layer) -> float | None:
        found = (output.brightness_behind(layer) for output in self._outputs)
        return next((one for one in found if one is not None), None)

    def frame_ends(self) -> None:
        for output in self._outputs:
            output.frame_ends()

    def forget(self, handle: int) -> None:
        for output in self._outputs:
            output.forget(handle)

    def release(self) -> None:
        for output in self._outputs:
            output.release()


class Refused(RenderError):
    """Outputs cannot show what was given."""

    def __init__(self, reasons: Sequence[str], *, all_of_them: bool) -> None:
        super().__init__("; ".join(reasons))
        self.reasons = tuple(reasons)
        self.all_of_them = all_of_them
        """No output shows it."""
