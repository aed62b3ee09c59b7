"""What glshim knows of a window toolkit: a class, in a file of its own in this folder.

A file that defines ``TOOLKITS`` is all that a new toolkit takes: see `glshim.toolkits.stub`, the
smallest complete one. Importing such a file must not import the toolkit.

A hook must reach the app's calls however it imported them. Functions that ctypes made are changed
in place (their class), so that names taken long before are hooked too; a module's own function is
replaced right after the module's import, before anyone else sees it.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from enum import Enum
from types import MappingProxyType, ModuleType
from typing import Any, ClassVar

from glshim.bindings.imports import after_import
from glshim.notices import say_fault
from glshim.toolkits.frames import Drawable, Size
from glshim.toolkits.moment import MOMENT, Moment


class Part(Enum):
    """What glshim wants of a toolkit; the values are for people."""

    FRAMES = "frame ends"
    SIZE = "window size"
    KEYS = "keys"
    REDRAW = "redraw"
    CLOCK = "still clock"
    DISPLAYLESS = "no display"


Lacks = Mapping[Part, str]
"""What is not done for a toolkit, and what a user notices of it."""


class Changes:
    """What one hook changed in a toolkit."""

    def __init__(self) -> None:
        self._undo: list[Callable[[], object]] = []

    def set(self, owner: Any, name: str, value: Any) -> None:
        """Set an attribute, until `undo`; what somebody else set over it stays theirs."""
        before, was_own = vars(owner).get(name), name in vars(owner)
        setattr(owner, name, value)
        ours = vars(owner).get(name)

        def undo() -> None:
            if vars(owner).get(name) is not ours:
                return
            if was_own:
                setattr(owner, name, before)
            else:
                delattr(owner, name)

        self._undo.append(undo)

    def add(self, undo: Callable[[], object]) -> None:
        """What undoes another change."""
        self._undo.append(undo)

    def undo(self) -> None:
        """Leave the toolkit as it was found."""
        while self._undo:
            self._undo.pop()()


@dataclass(frozen=True, slots=True)
class Hook:
    """One place in a toolkit that is hooked."""

    part: Part
    module: str
    """The module after whose import it is put."""
    put: Callable[[Any, Changes], None]
    """Given that module and where to note what it changes."""
    place: str
    """What is hooked, for people: ``glfw.swap_buffers``."""


class Toolkit:
    """One toolkit: what its file says (the first half) and what follows from that."""

    name: str
    """For people."""
    package: str
    """Its top package. A file of that name is read as soon as the package is imported; others
    when PyOpenGL is, which is early enough where classes and ctypes functions are hooked."""
    distribution: str = ""
    """What installers call it, where that is not the package's name."""
    may_raise: bool = True
    """Whether an exception that leaves its present call gets through to the app's main loop."""
    hears_threads: bool = False
    """Whether `redraw` and `leave` may be called in any thread."""
    lacks: ClassVar[Lacks] = MappingProxyType({})
    tested: str = ""
    """What glshim was tried with, for people: ``PySDL2 0.9.17 on X``. Empty where nobody of ours
    could run it, which `glshim doctor` says."""
    displayless: ClassVar[Mapping[str, str] | None] = None
    """Variables under which it draws where there is no display, besides hooks of that part; None:
    it needs one."""
    example: bool = False
    """Whether it is there to be read and tested, and not for use."""

    def hooks(self) -> Iterable[Hook]:
        """Where it is hooked."""
        raise NotImplementedError

    def size(self, window: Any) -> Size | None:
        """Pixels of what is presented."""
        return None

    def framebuffer(self, window: Any) -> int:
        """The framebuffer object that it is drawn into, 0 for the window's own."""
        return 0

    def redraw(self) -> None:
        """Ask for another frame: programs that draw only on demand would show nothing new."""

    def redraw_from_a_thread(self) -> None:
        """The same from another thread than the program's, where that can be."""
        if self.hears_threads:
            self.redraw()

    def leave(self) -> bool:
        """Ask the app's main loop to return once the callback that is running has: where
        exceptions get no further than there. False where no loop of this thread's can be asked."""
        return False

    def window_is_there(self) -> None:
        """Called at each frame end while keys are watched: for what can be hooked only then."""

    # -- for a toolkit's own hooks ---------------------------------------------------------------

    def drawable(self, window: Any = None) -> Drawable:
        """What the window is to those who listen to frame ends."""
        return Drawable(
            functools.partial(self.size, window),
            self.may_raise,
            functools.partial(self.framebuffer, window),
            self.leave,
            owner=self.name,
        )

    # -- for all of them -------------------------------------------------------------------------

    def __init__(self, moment: Moment = MOMENT) -> None:
        self.moment = moment
        """What its clocks show while they stand still."""
        self._watched: set[Part] = set()
        self._hooked: dict[tuple[Part, str, str], Changes] = {}

    def watch(self, part: Part) -> None:
        """Put the hooks of a part: now where the toolkit is imported, else when it is."""
        if part in self._watched:
            return
        self._watched.add(part)
        for hook in self.hooks():
            if hook.part is part:
                after_import(hook.module, functools.partial(self._put, hook))

    def _put(self, hook: Hook, module: ModuleType) -> None:
        key = hook.part, hook.module, hook.place
        if hook.part not in self._watched or key in self._hooked:
            return
        changes = self._hooked[key] = Changes()
        try:
            hook.put(module, changes)
        except Exception as error:  # an import of the app's must not fail for us
            changes.undo()
            del self._hooked[key]
            say_fault(f"{self.name}: {hook.place} cannot be hooked ({hook.part.value})", error)

    def release(self, part: Part) -> None:
        """Leave the toolkit as it was found."""
        self._watched.discard(part)
        for key in [key for key in self._hooked if key[0] is part]:
            self._hooked.pop(key).undo()

    def is_hooked(self, part: Part) -> bool:
        """Whether a hook of that part has been put."""
        return any(key[0] is part for key in self._hooked)

    def places(self, part: Part) -> tuple[str, ...]:
        """What is hooked for a part, for people; each once."""
        return tuple(dict.fromkeys(hook.place for hook in self.hooks() if hook.part is part))
