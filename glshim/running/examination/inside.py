"""Counts what the program does, in its own process, and writes it down as it goes: it may be
killed."""

from __future__ import annotations

import os
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any, cast

from glshim import pipeline
from glshim.bindings.base import Watcher
from glshim.bindings.pyopengl.raw import RAW
from glshim.driver.ask import text
from glshim.notices import say_fault
from glshim.running.examination.findings import BEGIN, Findings
from glshim.spec.attributes import RECORD_BYTES
from glshim.spec.constants import GL_RENDERER, GL_VERSION
from glshim.spec.roles import Role, role_of
from glshim.system.ending import at_end
from glshim.system.writing import write_text
from glshim.toolkits import frames
from glshim.toolkits.frames import Stage

_OFTEN = 0.25
"""Seconds between two writes."""
_HEARD = frozenset((Role.ARRAY_DRAW, Role.OPAQUE_DRAW, Role.CLEAR, Role.FLUSH))
"""Calls, outside primitives, at which is looked whether to write."""

RECORDED = "glVertex, glNormal and others, recorded"

Call = Callable[..., Any]


class _Counting:
    """A `glshim.bindings.base.Watcher` that counts what is recorded and never comes to PyOpenGL's
    own calls, and tells another one everything."""

    def __init__(self, watcher: Watcher, count: Callable[[str, str, int], None]) -> None:
        self._watcher = watcher
        self._count = count

    def __getattr__(self, name: str) -> Any:
        return getattr(self._watcher, name)

    def begin(self, mode: int) -> None:
        self._count("begin", "glBegin", 1)
        self._watcher.begin(mode)

    def end(self, mode: int, stream: bytes) -> None:
        self._count("end", "glEnd", 1)
        self._count("attribute", RECORDED, len(stream) // RECORD_BYTES)
        self._watcher.end(mode, stream)

    def before_shape(self, name: str) -> None:
        self._count("shape", name, 1)
        self._watcher.before_shape(name)


class Examination:
    """Of this process."""

    def __init__(self, folder: str) -> None:
        self._path = Path(folder, f"{os.getpid()}.json")
        self._process = os.getpid()
        self._found = Findings()
        self._written = 0.0

    def begin(self) -> None:
        """Before the style is installed: calls are counted below every other hook."""
        RAW.hook_below(self._counting)
        pipeline.hear_first(lambda watcher: cast(Watcher, _Counting(watcher, self._count)))
        frames.listen(Stage.COUNT, before=self._frame_ends, after=self._look)
        at_end(self._write)
        self._write()

    def installed(self) -> None:
        """After that."""
        seen = pipeline.census()
        if seen is not None:
            seen.count_polygons()

    def _counting(self, name: str) -> Callable[[Call], Call] | None:
        role = role_of(name)
        words = role.name.lower().replace("_", " ")
        heard = role in _HEARD

        def maker(real: Call) -> Call:
            def call(*args: Any, **named: Any) -> Any:
                self._count(words, name, 1)
                result = real(*args, **named)
                if heard:
                    self._look()
                return result

            return call

        return maker

    def _count(self, role: str, name: str, times: int) -> None:
        counts = self._found.calls.setdefault(role, {})
        counts[name] = counts.get(name, 0) + times

    def _frame_ends(self) -> None:
        by = frames.drawable_owner()
        self._found.frame_ends[by] = self._found.frame_ends.get(by, 0) + 1
        self._found.added += pipeline.counted().draws
        if not self._found.opengl:
            self._found.opengl = f"{text(GL_VERSION)}, {text(GL_RENDERER)}"

    def _look(self) -> None:
        if time.perf_counter() - self._written > _OFTEN:
            self._write()

    def _write(self) -> None:
        if os.getpid() != self._process:  # a fork, which has no file
            return
        self._written = time.perf_counter()
        found, seen = self._found, pipeline.census()
        if seen is not None:
            found.carried, found.others = seen.carried, seen.others
            found.passed, found.refused = dict(seen.passed), sorted(seen.refused)
            found.polygons = {path.value: n for path, n in (seen.polygons or {}).items()}
            found.why = pipeline.silent_because()
        try:
            write_text(self._path, found.text(), BEGIN)
        except OSError as error:
            say_fault("cannot write the report", error)
