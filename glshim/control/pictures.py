"""Pictures of frames that a key saves, each in a file of its own."""

from __future__ import annotations

import os
import re
import sys
from itertools import count
from pathlib import Path

from glshim.errors import shown
from glshim.notices import say, say_once
from glshim.outputs.gl.frame.grab import grab
from glshim.system.reading import has_elevated_rights
from glshim.system.writing import add_picture
from glshim.toolkits import frames

NAME = "GLSHIM_NAME"
"""The variable that pictures are named after. Read anew for each: a viewer may set it to what it
shows."""
_MOST_NAME = 200
"""Characters of a name before its number."""


class Pictures:
    """Writes pictures of frames, each to a file of its own."""

    def __init__(self, folder: str) -> None:
        self._folder = Path(folder)

    def save(self, style: str) -> None:
        """The frame that is about to be presented, as
        ``glshim-NAME-STYLE-NNN.png``; a line says where, or why not."""
        if has_elevated_rights():
            say_once("no pictures are saved in a setuid or setgid program")
            return
        size = frames.drawable_size()
        if size is not None and 0 in size:
            return
        name = f"glshim-{_subject()}-{_word(style)}"[:_MOST_NAME]
        try:
            self._folder.mkdir(parents=True, exist_ok=True)
            picture = grab(size, frames.drawable_framebuffer())
            for number in count(1):
                path = self._folder / f"{name}-{number:03d}.png"
                try:
                    add_picture(path, picture)
                except FileExistsError:
                    continue
                say(f"saved {shown(path, 500)}")
                return
        except OSError as error:
            folder, reason = shown(self._folder, 500), error.strerror or error
            say(f"cannot save a picture in {folder}: {reason}")


def _subject() -> str:
    return _word(os.environ.get(NAME, "").strip() or program_name())


def program_name() -> str:
    """The program's, as part of a file's name."""
    main = sys.modules.get("__main__")
    spec = getattr(main, "__spec__", None)
    if spec is not None:  # python -m package, or package.module
        return _word(spec.name.removesuffix(".__main__").rpartition(".")[2])
    return _word(Path(getattr(main, "__file__", "") or "program").stem)


def _word(text: str) -> str:
    return re.sub(r"[^A-Za-z0-9_.]+", "_", text).strip("._") or "program"
