"""Live control: what the keys of `glshim.control.keys` do while the program runs.

A key only leaves a wish, in whatever thread the toolkit tells of it; wishes come true at the next
frame end, in the context whose frame it is. A style that was switched to draws from the frame after
that on.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence

from glshim import pipeline, toolkits
from glshim.control import owners
from glshim.control.keys import KEYS, LiveSettings
from glshim.control.panel import FrameClock, Panel
from glshim.control.pictures import Pictures
from glshim.errors import GlshimError
from glshim.notices import say_once
from glshim.styling import registry, texts
from glshim.styling.descriptions import changed_options
from glshim.styling.protocol import Styler

_PLAIN = "none"
_LABELS = {
    "cycle": "next", "back": "previous", "toggle": "on/off", "save": "save PNG", "overlay": "hide",
}  # fmt: skip


class Controls:
    """A `glshim.toolkits.keyboard.KeyListener`, and a listener to frame ends."""

    def __init__(self, settings: LiveSettings, style: str | None, folder: str) -> None:
        """style: the text of the one that is on already; relative paths are the folder's."""
        self._keys = settings.keys
        self._folder, self._pictures = folder, Pictures(settings.folder)
        self._styles = cycle_of(settings.styles, style)
        self._at = 0 if style and style != _PLAIN else -1
        self._first = style or ""
        self._named: tuple[tuple[Styler | None, str], ...] = ((pipeline.current(), style or ""),)
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
                f"the program uses {chord} itself ({user}); "
                f"choose another key with {KEYS}={action}=KEY"
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
        self._named = (self._named[-1], (styler, self._first))
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
                say_once(f"skipped style {text!r}: {error}")
                continue
            self._off = None
            self._named = (self._named[-1], (styler, text))
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
        return texts.name_of(self._text_of(drawing))

    def _text_of(self, drawing: Styler) -> str:
        return next((text for styler, text in self._named if styler is drawing), drawing.name)

    def _lines(self) -> list[str]:
        """What the panel says."""
        drawing, counted = pipeline.current(), pipeline.counted()
        title = self._name
        if drawing is not None:
            text = self._text_of(drawing)
            if drawing.name != title:
                title = f"{title} ({drawing.name})"
            if text in self._styles:
                number = self._styles.index(text) + 1
                title = f"{number}/{len(self._styles)}  {title}"
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
