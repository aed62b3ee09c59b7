"""Work of ours of which the program hears nothing: not by its error flag, nor by debug output, nor
in what its transform feedback captures. What its queries count: `glshim.driver.queries`."""

from __future__ import annotations

from glshim.driver import errorflag
from glshim.driver.ask import integer, is_enabled
from glshim.driver.context import has_debug_output, has_pauses
from glshim.driver.functions import gl
from glshim.spec.constants import (
    GL_DEBUG_OUTPUT,
    GL_TRANSFORM_FEEDBACK_ACTIVE,
    GL_TRANSFORM_FEEDBACK_PAUSED,
)
from glshim.system.interrupts import Held


class Unnoticed:
    """``with Unnoticed():`` around GL calls, outside primitives. Signal handlers of the program's
    wait until it is left. Costs a few questions."""

    __slots__ = ("_captures", "_errors", "_held", "_speaks")

    def __enter__(self) -> Unnoticed:
        self._held = Held()
        self._held.__enter__()
        try:
            self._errors = errorflag.taken()
            self._speaks = has_debug_output() and is_enabled(GL_DEBUG_OUTPUT)
            if self._speaks:
                gl.glDisable(GL_DEBUG_OUTPUT)
            self._captures = (
                has_pauses()
                and bool(integer(GL_TRANSFORM_FEEDBACK_ACTIVE))
                and not integer(GL_TRANSFORM_FEEDBACK_PAUSED)
            )
            if self._captures:
                gl.glPauseTransformFeedback()
        except BaseException:
            self._held.__exit__()
            raise
        return self

    def __exit__(self, *_: object) -> None:
        """With the program's own program, or pipeline, in use again."""
        try:
            if self._captures:
                gl.glResumeTransformFeedback()
            errorflag.drain()
            errorflag.put_back(self._errors)
            if self._speaks:
                gl.glEnable(GL_DEBUG_OUTPUT)
        finally:
            self._held.__exit__()
