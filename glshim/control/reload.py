"""Reads a style anew when a file that it depends on is saved, while the program runs.

Looked at where frames end, so that nothing happens between them: a program that draws nothing
shows its new style with its next frame.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from pathlib import Path

from glshim.errors import GlshimError
from glshim.notices import forget, say, say_fault
from glshim.styling import texts
from glshim.styling.protocol import Styler
from glshim.system.reading import read_small
from glshim.toolkits import frames

INTERVAL = 0.25
"""Seconds between two looks at the files, at least."""

Stamp = tuple[tuple[int, int, int] | None, ...]


class Reloader:
    """Watches the files of one style text; ``switch`` puts a new styler in force."""

    def __init__(
        self,
        text: str,
        folder: str,
        switch: Callable[[Styler], None],
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._text, self._folder, self._switch, self._clock = text, folder, switch, clock
        self._files: tuple[Path, ...] = ()
        self._stamp: Stamp = ()
        self._next = 0.0
        self._styler: Styler | None = None
        self._doubtful = False
        self._listener: frames.Listener | None = None
        self._refused: tuple[str, int] | None = None
        """What was said of the files as they are, with a sum of their contents."""

    def read(self) -> Styler:
        """The styler that the files make now; they are watched from here on, also where they
        are not valid. Raises `GlshimError`."""
        files: list[Path] = []
        # Looked at first: what is written while it is read is read again.
        before = dict(zip(self._files, stamp(self._files), strict=True))
        try:
            return texts.parse_style(self._text, self._folder, files)
        finally:
            # A file that nobody gets to while one before it is broken stays watched.
            kept = (file for file, found in before.items() if found is not None)
            self._files = tuple(dict.fromkeys((*files, *kept)))
            self._stamp = tuple(before.get(file) or _stamp(file) for file in self._files)

    def begin(self) -> Styler:
        """`read` for the first time. Raises `GlshimError`; a mended file is then taken up."""
        try:
            self._styler = self.read()
        except GlshimError as error:
            self._refused = self._refusal(error)
            raise
        return self._styler

    @property
    def watches(self) -> bool:
        """Whether the text is that of a file."""
        return texts.is_path(self._text)

    def install(self) -> None:
        """Look at the files where frames end, if there are any to watch."""
        if self.watches and self._listener is None:
            self._listener = frames.listen(frames.Stage.RELOAD, after=self.look)

    def uninstall(self) -> None:
        """Look no more."""
        if self._listener is not None:
            self._listener.stop()
            self._listener = None

    def look(self) -> None:
        """Take up what was saved since, at most so often; a broken file is said once, and the
        last good style stays."""
        now = self._clock()
        if now < self._next:
            return
        self._next = now + INTERVAL
        if stamp(self._files) == self._stamp and not self._doubtful:
            return
        try:
            styler = self.read()
        except GlshimError as error:
            self._refuse(error)
            return
        self._doubtful = False
        mended, self._refused = self._refused is not None, None
        if mended:
            say(f"{self._text} is valid again; reloaded")
        if styler != self._styler:
            self._take(styler)

    def _take(self, styler: Styler) -> None:
        # A fault in what was saved before is not one in this.
        forget(f"style {styler.name!r}")
        try:
            self._switch(styler)
        except Exception as error:
            say_fault(f"style {styler.name!r} cannot be used; the previous one stays", error)
        else:
            self._styler = styler

    def _refuse(self, error: GlshimError) -> None:
        if not self._doubtful:  # it may be half written: look once more
            self._doubtful = True
            return
        self._doubtful = False
        refusal = self._refusal(error)
        if refusal != self._refused:
            self._refused = refusal
            say(f"{error}; the last good style stays")

    def _refusal(self, error: GlshimError) -> tuple[str, int]:
        return str(error), hash(tuple(map(_content, self._files)))


def stamp(files: tuple[Path, ...]) -> Stamp:
    """What changes when one of the files is written, replaced or removed."""
    return tuple(map(_stamp, files))


def _stamp(path: Path) -> tuple[int, int, int] | None:
    try:
        found = os.stat(path)
    except (OSError, ValueError):
        return None
    return found.st_mtime_ns, found.st_size, found.st_ino


def _content(path: Path) -> bytes:
    try:
        return read_small(path)
    except (OSError, ValueError):
        return b""
