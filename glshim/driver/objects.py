"""Objects of ours, under names that no program comes to.

A program shares the names of objects with us, in all contexts that share. What it is given by
glGen* and glCreate*, what glIs* says, and objects that it names by itself are as they are without
us: ours have names of our own choice, far from any that it is given or thinks of. How drivers give
names is in `docs/internals/decisions/0010-names-of-objects.md`.
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from functools import partial
from itertools import count
from typing import Any

from glshim.driver import kinds
from glshim.driver.ask import integer
from glshim.driver.context import has_fixed_function
from glshim.driver.functions import current_context, gl
from glshim.spec.constants import GL_FRAGMENT_SHADER, GL_MAX_TEXTURE_SIZE
from glshim.spec.kinds import BUFFER, PROGRAM, RENDERBUFFER, TEXTURE, Kind

_FAR = 0x5B400000
"""Where our names begin with a driver that counts upwards: memory is the same for any name."""
_OFF = 0x3D0900
"""Where they begin with others, which may keep a bit for each lesser name."""
_ROOM = 1 << 24
"""Names from there on that are ours, or those of C code that was given names after us."""
_END = 0xFFFF0000
"""From here on drivers do not count upwards any more."""
_STEP = 4096
"""Names between the program's and ours where a driver lets nobody choose."""
_STOCK, _SHADERS = 32, 1 << 14
"""Programs that are made at once, and shaders before them."""
_NOBODY = 0xFFFFFFFF
"""A name that no program or shader has."""


@dataclass(slots=True, eq=False)
class Space:
    """The names of contexts that share."""

    flag: int = 0
    """A buffer of ours by which its contexts are known."""
    contexts: set[int] = field(default_factory=set)
    """By handle."""
    last: dict[Kind, int] = field(default_factory=dict)
    """Of kinds whose names the driver counts upwards, never to give one again: the greatest that
    the program has had so far. The driver goes on from ours."""
    tried: set[Kind] = field(default_factory=set)
    stock: list[int] = field(default_factory=list)
    """Programs of ours that are empty yet, with a driver that gives the least free name. The first
    stays: a program that deletes very many names deletes that one, too."""
    losses: int = 0
    programs: Programs | None = None
    """With one that counts upwards."""
    left: dict[Kind, set[int]] = field(default_factory=dict)
    """By contexts that are gone: objects of ours that others share."""

    def given(self, kind: Kind, number: int, *, ask: bool = True) -> list[int]:
        """The names that the program would be given without us. ask: see `space`."""
        names: list[int] = []
        following = self.last[kind] + 1
        while len(names) < number:
            name = following
            following += 1
            if ask and kinds.is_there(kind, name):  # the program's, made where we do not hear it
                names.clear()
            else:
                names.append(name)
        self._reach(kind, names[-1])
        return names

    def met(self, kind: Kind, name: int) -> None:
        """The program may have made an object of a name of its choice."""
        ours = _FAR <= name < _FAR + _ROOM
        if not ours and self.last[kind] < name < _END and kinds.is_there(kind, name):
            self._reach(kind, name)

    def _reach(self, kind: Kind, name: int) -> None:
        self.last[kind] = name
        floors[kind] = min(each.last[kind] for each in [self, *_spaces] if kind in each.last)


class Programs:
    """The program's names of programs and shaders, where the driver counts upwards and has given
    ours some in between: the two differ from then on."""

    def __init__(self, space: Space) -> None:
        self._space = space
        global _first
        self._first = space.last[PROGRAM]
        _first = min(_first, self._first)
        self.ours: set[int] = set()
        self._drivers: dict[int, int] = {}
        """By the program's name."""
        self._own: dict[int, int] = {}
        """By the driver's."""
        self._most = 1024

    def entered(self, name: int, *, ask: bool = True) -> int:
        """What the program calls that which the driver has just made. ask: see `space`."""
        own = self._space.last[PROGRAM] + 1
        while ask and self._is_foreign(own):
            own += 1
        self._space._reach(PROGRAM, own)
        if ask and len(self._drivers) >= self._most:
            self._tidy()
        self._drivers[own], self._own[name] = name, own
        return own

    def drivers(self, own: int) -> int:
        """What the driver calls that which the program has a name for."""
        if own <= self._first:
            return own
        found = self._drivers.get(own)
        if found is None:
            known = own in self.ours or own in self._own
            found = _NOBODY if known and kinds.is_there(PROGRAM, own) else own
        return found

    def own(self, name: int) -> int:
        """What the program calls that which the driver has a name for."""
        return self._own.get(name, name)

    def _is_foreign(self, name: int) -> bool:
        """Whether C code has made what has that name, unheard."""
        return name not in self.ours and name not in self._own and kinds.is_there(PROGRAM, name)

    def _tidy(self) -> None:
        """Forget what is deleted: its names do not come again."""
        for own, name in [*self._drivers.items()]:
            if not kinds.is_there(PROGRAM, name):
                del self._drivers[own], self._own[name]
        self._most = 2 * len(self._drivers) + 1024


_spaces: list[Space] = []
heard: list[Callable[[Kind], None]] = []
"""Called with a kind whose names the program has to be given by us from now on."""
floors: dict[Kind, int] = {}
"""By kind the least of `Space.last`: what is met up to there is no news."""
_first = 1 << 32
"""The least name that is the same for the program and its driver wherever there are others."""
_far, _off = count(_FAR), count(_OFF)
_spare: dict[tuple[Kind, bool], list[int]] = {}
"""Of ours, names of objects that have been deleted."""
_made_in: dict[int, dict[Kind, set[int]]] = {}
"""What there is of ours, by the handle of the context that it was made in."""
_SHARED = (TEXTURE, BUFFER, RENDERBUFFER, PROGRAM)
_MOST_DESERTED = 8
"""Spaces without contexts that are kept: one of them may still be met that shares with them."""


def made(kind: Kind) -> int:
    """The name of a new object, empty. Outside primitives and lists."""
    name = _made(kind)
    _note(kind, name)
    return name


def _note(kind: Kind, name: int) -> None:
    _made_in.setdefault(current_context(), {}).setdefault(kind, set()).add(name)


def _made(kind: Kind) -> int:
    if not has_fixed_function():  # nothing of ours stays in a core profile
        return kinds.generate(kind, 1)[0]
    if not kinds.is_free(kind):
        return _reserved(kind)
    counts = kind in _space(kind).last
    spare = _spare.setdefault((kind, counts), [])
    while True:
        name = spare.pop() if spare else next(_far if counts else _off)
        if not kinds.is_there(kind, name):
            break
    kinds.create(kind, name)
    return name if kinds.is_there(kind, name) else _reserved(kind)


def delete(kind: Kind, names: Iterable[int]) -> None:
    """Delete objects that were `made`."""
    listed = [name for name in names if name]
    kinds.delete(kind, listed)
    _made_in.get(current_context(), {}).get(kind, set()).difference_update(listed)
    for name in listed:
        if name >= _OFF and kind is not PROGRAM:
            _spare.setdefault((kind, name >= _FAR), []).append(name)


def context_ended(handle: int) -> None:
    """A context is gone. Its objects are, too, but for those that others share: they go by
    `tidy`. Calls no GL."""
    made_there = _made_in.pop(handle, {})
    for each in [each for each in _spaces if handle in each.contexts]:
        each.contexts.discard(handle)
        for kind in _SHARED:
            each.left.setdefault(kind, set()).update(made_there.get(kind, ()))
    deserted = [each for each in _spaces if not each.contexts]
    for each in deserted[:-_MOST_DESERTED]:
        _spaces.remove(each)


def tidy() -> None:
    """Delete what contexts have left that shared with the current one. Outside primitives and
    lists."""
    if not any(each.left for each in _spaces):
        return
    here = space()
    if here is not None:
        for kind, names in here.left.items():
            delete(kind, filter(partial(kinds.is_there, kind), names))
        here.left = {}
        if here.programs is not None:
            here.programs.ours = set(filter(partial(kinds.is_there, PROGRAM), here.programs.ours))


def is_news(name: int) -> bool:
    """Whether a program or shader of that name, if there is one, may have another with the
    driver."""
    return name > _first


def is_late(name: int) -> bool:
    """Whether a driver that counts upwards has given a name after one of ours."""
    return name > _FAR


def made_program() -> int:
    """The name of a new program. Its shaders are to be detached when it is linked: they may have
    any names until then."""
    name = _made_program()
    _note(PROGRAM, name)
    return name


def _made_program() -> int:
    here = _space(PROGRAM)
    if here.programs is not None:
        name = int(gl.glCreateProgram())
        here.programs.ours.add(name)
        return name
    losses()
    if len(here.stock) < 2:
        between = [gl.glCreateShader(GL_FRAGMENT_SHADER) for _ in range(_SHADERS)]
        here.stock += kinds.generate(PROGRAM, _STOCK)
        for shader in between:
            gl.glDeleteShader(shader)
    return here.stock.pop()


def losses() -> int:
    """How often programs of ours have been deleted by the current context's program. Outside
    primitives and lists."""
    here = space()
    if here is None:
        return 0
    if here.stock and not kinds.is_there(PROGRAM, here.stock[0]):
        # Deleted and forgotten before new ones have such names.
        made_here = [_made_in.get(handle, {}).pop(PROGRAM, set()) for handle in here.contexts]
        lost = {*here.left.pop(PROGRAM, ()), *here.stock}.union(*made_here)
        kinds.delete(PROGRAM, filter(partial(kinds.is_there, PROGRAM), lost))
        here.stock.clear()
        here.losses += 1
    return here.losses


def space(*, ask: bool = True) -> Space | None:
    """The names of the current context, if any of ours are among them. ask: False where the driver
    is inside a primitive, where to ask is an error that the program would find: the context is
    taken for the one that it was before."""
    handle = current_context()
    for each in _spaces:
        if handle in each.contexts:
            if not ask:
                return each
            # Inside a primitive nothing can be asked: it is the context that it was before.
            if kinds.is_there(BUFFER, each.flag) or not integer(GL_MAX_TEXTURE_SIZE):
                return each
            each.contexts.discard(handle)  # another context has the address of that one
            if not each.contexts:
                _spaces.remove(each)
            break
    if not ask:
        return None
    for each in _spaces:
        if kinds.is_there(BUFFER, each.flag):
            each.contexts.add(handle)
            return each
    return None


def _space(kind: Kind) -> Space:
    """The names of the current context, of which it is known how its driver gives those of a
    kind."""
    found = space()
    if found is None:
        found = Space(contexts={current_context()})
        _look(found, BUFFER)
        _spaces.append(found)
        found.flag = next(_far if BUFFER in found.last else _off)
        kinds.create(BUFFER, found.flag)
    if kind not in found.tried:
        _look(found, kind)
    return found


def _look(space: Space, kind: Kind) -> None:
    """See how the driver gives names. This changes none that it will give if it gives the least
    that is free; if it counts upwards, they are given by us from now on."""
    names = []
    for _ in range(2):
        names += kinds.generate(kind, 1)
        kinds.delete(kind, names[-1:])
    space.tried.add(kind)
    if names[1] == names[0] + 1:
        space._reach(kind, names[0] - 1)
        if kind is PROGRAM:
            space.programs = Programs(space)
        for hear in heard:
            hear(kind)


def _reserved(kind: Kind) -> int:
    """A name of the driver's choice, beyond many that the program may be given."""
    *others, name = kinds.generate(kind, _STEP)
    kinds.delete(kind, others)
    return name


# -- for a library that makes objects for us ------------------------------------------------------


def _make_buffers(number: int, address: int) -> None:
    names = (ctypes.c_uint * number).from_address(address)
    for k in range(number):
        names[k] = made(BUFFER)


def _delete_buffers(number: int, address: int) -> None:
    delete(BUFFER, (ctypes.c_uint * number).from_address(address))


def _delete_program(name: int) -> None:
    delete(PROGRAM, (name,))


_OWN: dict[str, Callable[..., Any]] = {
    "glGenBuffers": _make_buffers, "glDeleteBuffers": _delete_buffers,
    "glCreateProgram": made_program, "glDeleteProgram": _delete_program,
}  # fmt: skip


def function_for_ours(name: str) -> Callable[..., Any] | None:
    """What a library that makes objects for us is to call in place of a driver's function that
    gives names or takes them back; None for all others."""
    return _OWN.get(name)
