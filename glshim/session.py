"""One run of a program under GLSHIM_* variables: the style, the frames to write, the end."""

from __future__ import annotations

import os

from glshim import options
from glshim.capture import frames
from glshim.errors import GlshimError
from glshim.notices import say, say_fault
from glshim.reload import Reloader
from glshim.styling.protocol import Styler

LOOKS_AT_THE_PICTURE, COUNTS = 1, 2
"""Ranks of the listeners to frame ends; the pipeline draws at 0."""


def begin(folder: str) -> None:
    """Read the environment and install what it asks for; its paths are relative to the folder.
    What it asks for wrongly is said in one line each, and the program runs on without it."""
    settings, complaints = options.read_environment(os.environ, folder)
    for complaint in complaints:
        say(complaint)
    if settings.style is not None:
        _install(settings.style, folder)
    if settings.capture is not None:
        from glshim.render.framegrab import FrameWriter

        writer = FrameWriter(settings.capture, frames.drawable_size, frames.drawable_framebuffer)
        frames.install(writer.write, rank=LOOKS_AT_THE_PICTURE)
    if settings.frames is not None:
        FrameLimit(settings.frames).install()


def _install(style: str, folder: str) -> None:
    reloader = Reloader(style, folder, _switch)
    try:
        styler = reloader.begin()
    except GlshimError as error:
        say(f"GLSHIM_STYLE: {error}; the program runs unstyled")
    else:
        try:
            _switch(styler)
        except Exception as error:  # the frames asked for still come, and the end
            say_fault("cannot install the style, the program runs unstyled", error)
            return
    reloader.install()


def _switch(styler: Styler) -> None:
    from glshim import pipeline

    pipeline.install(styler)


class FrameLimit:
    """Ends the program once so many frames were presented."""

    def __init__(self, frames_left: int) -> None:
        self._left = frames_left

    def install(self) -> None:
        frames.install(self._before, self._count, rank=COUNTS)

    def _before(self) -> None:
        pass

    def _count(self) -> None:
        self._left -= 1
        if self._left <= 0:
            frames.end_program()
