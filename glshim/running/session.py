"""One run of a program under GLSHIM_* variables: the style, the frames to write, the end."""

from __future__ import annotations

import atexit
import os
from dataclasses import replace
from typing import TYPE_CHECKING

from glshim import toolkits
from glshim.control.keys import LiveSettings
from glshim.control.reload import Reloader
from glshim.errors import GlshimError, StyleError
from glshim.notices import say, say_fault
from glshim.running import environment, rest, runners, stillness
from glshim.styling import texts
from glshim.styling.protocol import Styler
from glshim.system.modules import OURS_ALONE
from glshim.system.reading import has_elevated_rights
from glshim.toolkits import Part, frames, keyboard
from glshim.toolkits.frames import Stage
from glshim.toolkits.moment import MOMENT

if TYPE_CHECKING:
    from PIL.Image import Image

    from glshim.control.live import Controls
    from glshim.running.examination.inside import Examination
    from glshim.running.shots.shooter import Shot

REPORT = "GLSHIM_REPORT"
"""`glshim.running.examination.findings.VARIABLE`, which is not loaded but then."""
SHOT = "GLSHIM_SHOT"
"""`glshim.running.shots.plan.VARIABLE`, which is not loaded but then."""
NO_STYLE = "none"
_controls: Controls | None = None
"""What the keys do, where some are watched."""


def begin(folder: str) -> None:
    """Read the environment and install what it asks for; its paths are relative to the folder.
    What it asks for wrongly is said in one line each, and the program runs on without it."""
    settings, complaints = environment.read(os.environ, folder)
    for complaint in complaints:
        say(complaint)
    if (settings.capture is not None or SHOT in os.environ) and has_elevated_rights():
        say("setuid and setgid programs save no frames")
        settings = replace(settings, capture=None)
    shot = _shot() if SHOT in os.environ and not has_elevated_rights() else None
    examination = _examination() if REPORT in os.environ and not has_elevated_rights() else None
    if settings.style is not None or settings.live is not None:
        _install(settings.style or NO_STYLE, folder, live=settings.live is not None)
    if examination is not None:
        examination.installed()
    if shot is not None:
        shot.begin()
    if settings.capture is not None:
        from glshim.outputs.gl.frame.grab import FrameWriter

        writer = FrameWriter(settings.capture, _picture, lambda: frames.presented() + 1)
        frames.listen(Stage.CAPTURE, before=writer.write, read=writer.write)
    if settings.live is not None:
        _watch_keys(settings.live, settings.style, folder)
    if stillness.VARIABLE in os.environ:
        stillness.count_frames()
    if settings.frames is not None:
        FrameLimit(settings.frames).install()
    if frames.has_listeners():
        toolkits.watch(Part.FRAMES)


def _picture() -> Image | None:
    """Of the frame that ends; None where the window is minimised."""
    from glshim.outputs.gl.frame.grab import grab

    size = frames.drawable_size()
    if size is not None and 0 in size:
        return None
    return grab(
        size, frames.drawable_framebuffer(), frames.drawable_buffer(), frames.drawable_texture()
    )


def _examination() -> Examination:
    from glshim.running.examination.inside import Examination

    examination = Examination(os.environ[REPORT])
    examination.begin()
    return examination


def _shot() -> Shot | None:
    from glshim.running.shots.plan import Plan
    from glshim.running.shots.shooter import Shot

    try:
        shot = Shot(Plan.of_text(os.environ[SHOT]), MOMENT)
    except StyleError as error:
        say(f"{SHOT}: {error}; no picture is saved")
        return None
    shot.prepare()
    return shot


def _install(style: str, folder: str, *, live: bool) -> None:
    reloader = Reloader(style, folder, _switch)
    # A file is followed from the start: a style that is saved later knows what was drawn before.
    live = live or reloader.watches
    try:
        styler = reloader.begin()
    except GlshimError as error:
        say(f"{environment.STYLE}: {error}; the program runs unstyled")
        if not live:
            return
        styler = texts.parse_style(NO_STYLE)
    try:
        with OURS_ALONE:
            from glshim.pipeline import install

        install(styler, live=live)
    except Exception as error:  # the frames asked for still come, and the end
        say_fault("cannot install the style; the program runs unstyled", error)
    else:
        reloader.install()


def _switch(styler: Styler) -> None:
    """The style's file was saved: where keys may have chosen another style they decide."""
    if _controls is not None:
        _controls.renew(styler)
        return
    from glshim.pipeline import switch

    switch(styler)


def _watch_keys(settings: LiveSettings, style: str | None, folder: str) -> None:
    global _controls
    try:
        from glshim.control.live import Controls

        _controls = Controls(settings, style, folder)
        toolkits.watch(Part.KEYS)
        keyboard.listen(_controls)
        frames.listen(Stage.OVERLAY, before=_controls.frame_ends)
    except Exception as error:
        say_fault("cannot watch keys; live control is off", error)


class FrameLimit:
    """Ends the program once so many frames were presented."""

    def __init__(self, frames_left: int) -> None:
        self._frames = self._left = frames_left

    def install(self) -> None:
        """Count from now on."""
        frames.listen(Stage.COUNT, after=self._count)
        if stillness.VARIABLE not in os.environ:  # which looks after that by itself
            frames.want_more(True)
            rest.watch(frames.begun)

    def _count(self) -> None:
        self._left -= 1
        if self._left == 0 and (runner := runners.runner()):
            frames.want_more(False)
            told = f"{environment.FRAMES}={self._frames} did not end {runner}"
            # What is printed now, it may keep to itself.
            atexit.register(
                say, f"{told}, because tests or cells that have not run yet would be lost"
            )
        elif self._left == 0:
            # Whoever catches the end may be counting failures: a status of 0 would hide them.
            # A gallery or a report wants the frames alone.
            frames_alone = stillness.VARIABLE in os.environ or REPORT in os.environ
            frames.end_program(caught=0 if frames_alone else 1)
