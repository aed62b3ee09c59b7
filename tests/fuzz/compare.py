"""What differs between two plays of one program."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple

from tests.fuzz import look
from tests.fuzz.program import functions
from tests.fuzz.stage import HEIGHT, WIDTH, Note

READS_PIXELS = re.compile(
    r"\bgl(Read(n?)Pixels|Get(n|Compressed|nCompressed)?Tex(ture)?(Sub)?Image|GetTextureSubImage"
    r"|GetTextureImage|GetCompressedTextureImage)"
)
NONE = "none"
_PICTURES = ("back", "front", "depth", "stencil")


class Difference(NamedTuple):
    """One."""

    step: int
    what: str
    """The cause as far as it can be told: groups equal ones."""
    plain: str
    other: str


def differences(
    steps: Sequence[str], plain: Sequence[Note] | str, other: Sequence[Note] | str, style: str
) -> list[Difference]:
    """Under ``none`` pictures count, too, and what the program reads of them. A text says how a
    play ended."""
    return list(_differences(steps, plain, other, style == NONE))


def _differences(
    steps: Sequence[str], plain: Sequence[Note] | str, other: Sequence[Note] | str, exact: bool
) -> Iterator[Difference]:
    if isinstance(plain, str) or isinstance(other, str):
        if isinstance(other, str):
            yield Difference(-1, other, "lives", other)
        return
    for note in other:
        if note.what == "fault":
            text = str(note.value)
            yield Difference(-1, f"a fault of glshim: {text.strip().splitlines()[-1]}", "", text)
    known = {(note.step, note.what, turn): note for turn, note in _counted(plain)}
    for turn, note in _counted(other):
        if note.what == "fault":
            continue
        match = known.pop((note.step, note.what, turn), None)
        if match is None:
            yield Difference(note.step, f"{note.what} is there", "no", "yes")
        elif match.value != note.value:
            yield from _told(steps[note.step], match, note, exact)
    for step, what, _ in known:
        yield Difference(step, f"{what} is there", "yes", "no")


def _counted(notes: Sequence[Note]) -> Iterator[tuple[int, Note]]:
    """With how many of the same name came before at that step."""
    turns: dict[tuple[int, str], int] = {}
    for note in notes:
        key = (note.step, note.what)
        turns[key] = turns.get(key, -1) + 1
        yield turns[key], note


def _told(step: str, plain: Note, other: Note, exact: bool) -> Iterator[Difference]:
    _, _, part = plain.what.partition(": ")
    if isinstance(plain.value, str) or isinstance(other.value, str):
        if exact or not READS_PIXELS.search(step):
            name = ", ".join(functions(step)) or step
            yield Difference(plain.step, f"result of {name}", str(plain.value), str(other.value))
    elif part in _PICTURES:
        if exact:
            yield Difference(plain.step, plain.what, "", _pixels(plain.value, other.value))
    else:
        for name, one, two in look.explain(part, plain.value, other.value):
            yield Difference(plain.step, name, one, two)


def _pixels(one: bytes, two: bytes) -> str:
    a, b = memoryview(one).cast("I"), memoryview(two).cast("I")
    changed = [i for i in range(min(len(a), len(b))) if a[i] != b[i]]
    if not changed:
        return "another size"
    first = changed[0]
    return (
        f"{len(changed)} of {WIDTH * HEIGHT} pixels, from {divmod(first, WIDTH)[::-1]}:"
        f" {a[first]:#x} then {b[first]:#x}"
    )
