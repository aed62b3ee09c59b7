"""Live control: what the keys of `glshim.control.keys` do while the program runs.

A key only leaves a wish, in whatever thread the toolkit tells of it; wishes come true at the next
frame end, in the context whose frame it is. A style that was switched to draws from the frame after
that on.
"""

from __future__ import annotations

import re
import sys
import time
from collections import deque
from collections.abc import Callable, Sequence
from itertools import count
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from glshim import pipeline, toolkits
from glshim.control import owners
from glshim.control.keys import KEYS, LiveSettings
from glshim.errors import GlshimError
from glshim.notices import say, say_once
from glshim.outputs.gl.frame import grab, overlay
from glshim.styling import registry, texts
from glshim.styling.descriptions import changed_options
from glshim.styling.protocol import Styler
from glshim.toolkits import frames

_PLAIN = "none"
_LABELS = {"cycle": "style", "back": "back", "toggle": "on/off", "save": "PNG", "overlay": "hide"}
_REWRITTEN_AFTER = 0.25
"""Seconds for which the panel's numbers stand: they shall be read."""
_WEIGHT = 0.1
"""Of the last frame in the smoothed time."""


class Controls:
    """A `glshim.toolkits.keyboard.Listener`, and a listener to frame ends."""

    def __init__(self, settings: LiveSettings, style: str | None, folder: str) -> None:
        """style: the text of the one that is on already; relative paths are the folder's."""
        self._keys = settings.keys
        self._folder, self._pictures = folder, Pictures(settings.folder)
        self._styles = cycle_of(settings.styles, style)
        self._at = 0 if style and style != _PLAIN else -1
        self._first = style or ""
        self._worn: tuple[tuple[Styler | None, str], ...] = ((pipeline.current(), style or ""),)
        """The last two styles and their texts: one draws, and another may be about to."""
        self._off: Styler | None = None
        """What draws when the shim is switched on again."""
        self._wishes: deque[str] = deque()
        self._clock = FrameClock()
        self._panel: Panel | None = None

    # -- keys: any thread, no GL -----------------------------------------------------------------

    def owns(self, chord: str) -> bool:
        """Whether a key is ours: one that the user named, or a default key that the program's own
        code does not name."""
        action = self._keys.action(chord)
        if action is None:
            return False
        user = self._user_of(action)
        if user is not None:
            say_once(
                f"{chord} stays the program's own, {user} names it; "
                f"{KEYS}={action}=KEY chooses another key"
            )
        return user is None

    def _user_of(self, action: str) -> str | None:
        """The file that keeps an action from its default key."""
        if action in self._keys.named:
            return None
        return owners.user_of(self._keys.chords[action].rpartition("+")[2])

    def claims(self, chord: str) -> bool:
        """Whether the user named it."""
        return self._keys.action(chord) in self._keys.named

    def press(self, chord: str) -> None:
        """Leave a wish."""
        action = self._keys.action(chord)
        if action is not None:
            self._wishes.append(action)
            toolkits.redraw()

    # -- the style that the program began with, saved anew --------------------------------------

    def renew(self, styler: Styler) -> None:
        """Its file was saved: it draws so if it is on, or when it is switched on again. Where
        another one of the row is on nothing changes; each is read when its turn comes."""
        drawing = pipeline.current()
        shown = self._off if drawing is None and self._off is not None else drawing
        if shown is not None and self._text_of(shown) != self._first:
            return
        self._worn = (self._worn[-1], (styler, self._first))
        if self._off is not None:
            self._off = styler
        else:
            pipeline.switch(styler)

    # -- frame ends ------------------------------------------------------------------------------

    def frame_ends(self) -> None:
        """The picture is whole, and is about to be presented."""
        self._clock.tick()
        toolkits.window_is_there()
        # What is wished for after a switch is wished of the next picture.
        while self._wishes:
            action = self._wishes.popleft()
            getattr(self, f"_{action}")()
            if action in ("cycle", "back", "toggle"):
                toolkits.redraw()  # a program that draws on demand has to show the new style
                break
        if self._panel is not None:
            self._panel.show(pipeline.current(), self._lines)

    def _cycle(self) -> None:
        self._go(1)

    def _back(self) -> None:
        self._go(-1)

    def _go(self, step: int) -> None:
        """To the next style that there is."""
        for _ in self._styles:
            if self._at < 0:  # none of the row is on yet
                self._at = 0 if step > 0 else len(self._styles) - 1
            else:
                self._at = (self._at + step) % len(self._styles)
            text = self._styles[self._at]
            try:
                styler = texts.parse_style(text, self._folder)
            except GlshimError as error:
                say_once(f"style {text!r} is passed over: {error}")
                continue
            self._off = None
            self._worn = (self._worn[-1], (styler, text))
            pipeline.switch(styler)
            return

    def _toggle(self) -> None:
        drawing = pipeline.current()
        if drawing is not None:
            self._off = drawing
            pipeline.switch(None)
        elif self._off is not None:
            pipeline.switch(self._off)
            self._off = None
        else:
            self._go(1)

    def _save(self) -> None:
        self._pictures.save(self._name)

    def _overlay(self) -> None:
        self._panel = Panel() if self._panel is None else None

    # -- words -----------------------------------------------------------------------------------

    @property
    def _name(self) -> str:
        """Of the style that the picture shows."""
        drawing = pipeline.current()
        if drawing is None:
            return "off" if self._off is not None else _PLAIN
        text = self._text_of(drawing)
        return Path(text).stem if text.endswith(".toml") else text.partition(":")[0].strip()

    def _text_of(self, worn: Styler) -> str:
        return next((text for styler, text in self._worn if styler is worn), worn.name)

    def _lines(self) -> list[str]:
        """What the panel says."""
        drawing, counted = pipeline.current(), pipeline.counted()
        title = self._name
        if drawing is not None:
            if drawing.name != title:
                title = f"{title} ({drawing.name})"
            title = " ".join((title, *changed_options(drawing)))
        numbers = f"{self._clock.seconds * 1e3:.1f} ms, {1.0 / self._clock.seconds:.0f} fps"
        if drawing is not None:
            numbers += f", {counted.polygons:,} polygons, {counted.draws} draws"
        keys = [
            f"{key} {_LABELS[action]}"
            for action, key in self._keys.chords.items()
            if self._user_of(action) is None
        ]
        return [title, numbers, "   ".join(keys)]


def cycle_of(styles: Sequence[str], first: str | None) -> tuple[str, ...]:
    """The texts of styles to go through: those given, or all that are installed; the one that is on
    is among them, or comes first."""
    texts = tuple(styles) or tuple(n for n in (*registry.names(), *registry.looks()) if n != _PLAIN)
    if not first or first == _PLAIN:
        return texts
    at = texts.index(first) if first in texts else len(texts)
    return (first, *texts[at + 1 :], *texts[:at])


class FrameClock:
    """The time from one frame end to the next, smoothed."""

    def __init__(self) -> None:
        self._last: float | None = None
        self.seconds = 1e-3

    def tick(self) -> None:
        """A frame ends now."""
        now = time.perf_counter()
        if self._last is not None:
            new = max(now - self._last, 1e-6)
            first = self.seconds == 1e-3
            self.seconds = new if first else self.seconds + _WEIGHT * (new - self.seconds)
        self._last = now


class Panel:
    """The overlay, which is made anew a few times a second."""

    def __init__(self) -> None:
        self._pixels: NDArray[np.uint8] | None = None
        self._said: list[str] = []
        self._state = (0, 0)
        self._since = -_REWRITTEN_AFTER

    def show(self, drawing: Styler | None, lines_of: Callable[[], list[str]]) -> None:
        """Draw it over the picture that is about to be presented."""
        size = frames.drawable_size()
        width = size[0] if size is not None else 1 << 16
        now, state = time.monotonic(), (id(drawing), width)
        if self._pixels is None or state != self._state or now - self._since >= _REWRITTEN_AFTER:
            lines = lines_of()
            if self._pixels is None or lines != self._said or width != self._state[1]:
                self._pixels = overlay.panel(lines, width)
            self._said, self._state, self._since = lines, state, now
        overlay.show(self._pixels, size, frames.drawable_framebuffer())


class Pictures:
    """Writes pictures of frames, each to a file of its own."""

    def __init__(self, folder: str) -> None:
        self._folder = Path(folder)
        self._program = program_name()

    def save(self, style: str) -> None:
        """The frame that is about to be presented, as
        ``glshim-PROGRAM-STYLE-NNN.png``; a line says where, or why not."""
        size = frames.drawable_size()
        if size is not None and 0 in size:
            return
        name = f"glshim-{self._program}-{_word(style)}"
        try:
            self._folder.mkdir(parents=True, exist_ok=True)
            picture = grab.grab(size, frames.drawable_framebuffer())
            for number in count(1):
                path = self._folder / f"{name}-{number:03d}.png"
                try:
                    with path.open("xb") as file:
                        picture.save(file, "PNG")
                except FileExistsError:
                    continue
                say(f"saved {path}")
                return
        except OSError as error:
            say(f"cannot save a picture in {self._folder}: {error.strerror or error}")


def program_name() -> str:
    """The program's, as part of a file's name."""
    main = sys.modules.get("__main__")
    spec = getattr(main, "__spec__", None)
    if spec is not None:  # python -m package, or package.module
        return _word(spec.name.removesuffix(".__main__").rpartition(".")[2])
    return _word(Path(getattr(main, "__file__", "") or "program").stem)


def _word(text: str) -> str:
    return re.sub(r"[^A-Za-z0-9_.]+", "_", text).strip("._") or "program"
