"""The display lists of one context: what is compiled into them, and what their calls do to the
primitive that is being recorded."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from glshim.bindings.base import PrimitiveStream
from glshim.driver.ask import integer
from glshim.model.batch import Wanted
from glshim.model.lights import MaterialChange, Materials
from glshim.sources.fixed import normals
from glshim.sources.fixed.lists import ListBook, list_names
from glshim.sources.fixed.steps import Closing, LooseVertices, Opening, Step
from glshim.sources.source import Call
from glshim.spec.constants import GL_COMPILE, GL_LIST_BASE
from glshim.spec.roles import Role


class ListCompiler:
    """Follows glNewList and what comes after it."""

    def __init__(self, stream: PrimitiveStream, wanted: Wanted) -> None:
        self.book = ListBook(wanted)
        self._stream = stream
        self._partial = False
        """Some list adds to primitives of others, or ends them."""
        self._base = 0
        # Plain values: they are looked at in every draw.
        self.is_open = False
        """A list is being compiled."""
        self.only_compiles = False
        """A list is open that does not draw while it is compiled."""
        self.needs_base = False
        """A list that is called inside a primitive may matter: some add vertices, or end it."""

    def open(self, name: int, mode: int) -> None:
        """glNewList."""
        self.book.begin(name)
        self.is_open = self.needs_base = True
        self.only_compiles = mode == GL_COMPILE

    def close(self) -> int | None:
        """glEndList: the list takes effect. Its name."""
        self.is_open = self.only_compiles = False
        self.needs_base = self._partial
        return self.book.end()

    def called(self, role: Role, args: Sequence[Any]) -> tuple[bool, Materials]:
        """Of a call of LIST_CALLS: whether it draws lines, points, text or nothing, and what
        materials do while it draws."""
        facts = [self.book.facts(name) for name in self.names(role, args)]
        found = {each.materials for each in facts}
        first = next((m for m in (Materials.SHADE, Materials.VARY) if m in found), Materials.STAY)
        return all(each.draws_ink for each in facts), first

    def material_inside(self, change: MaterialChange) -> None:
        """An open list changes a material inside a primitive."""
        if self.book.open is not None:
            self.book.open.changed.add(change.parameter)

    def held(self) -> int:
        """How many things an open list holds so far."""
        program = self.book.open
        return 0 if program is None else len(program.items)

    def add(self, item: Step) -> None:
        """Note what an open list holds; without an open list, nothing."""
        program = self.book.open
        if program is not None:
            if not isinstance(item, LooseVertices):
                self._stream.settle()  # what was said before it comes before it
            program.items.append(item)
            if isinstance(item, (LooseVertices, Closing)):
                self._partial = True

    def look_at_base(self) -> None:
        """Before a primitive, where it :attr:`needs_base`: inside, nothing may be asked."""
        self._base = integer(GL_LIST_BASE)

    def names(self, role: Role, args: Sequence[Any], *, inside: bool = False) -> tuple[int, ...]:
        """The lists that a call of LIST_CALLS runs."""
        if role is Role.LIST_CALL:
            return list_names(role, args, 0)
        return list_names(role, args, self._base if inside else integer(GL_LIST_BASE))

    def left_open(self, names: tuple[int, ...]) -> int | None:
        """The first list that, called, ends inside a primitive that it began."""
        return next(filter(self.book.leaves_open, names), None)

    def resume(self, name: int) -> None:
        """A list was called that left a primitive open: its rest is recorded from now on."""
        said = b""
        for item in self.book.items(name):
            if isinstance(item, Opening):
                record = normals.after(said, normals.UNKNOWN) + item.stream
                self._stream.resume(item.mode, record)
            # The list's own normal before it, if nothing else came between.
            said = item.stream if isinstance(item, LooseVertices) else b""

    def called_inside(self, names: tuple[int, ...]) -> tuple[int, bytes] | None:
        """Lists were called inside a primitive: they add vertices. Mode and record of the primitive
        when they ended it."""
        self.add(Call(names))
        for item in (item for name in names for item in self.book.items(name)):
            if isinstance(item, LooseVertices):
                self._stream.extend(item.stream)
            elif isinstance(item, Closing):
                return self._stream.finish()
        return None
