"""Writes a program: chance, the steps so far, and the texts of arguments in every kind."""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeVar

from tests.fuzz.registry import registry

T = TypeVar("T")
COORDINATES = (-1.0, -0.75, -0.5, -0.25, 0.0, 0.25, 0.5, 0.75, 1.0)
UNITS = (0.0, 0.25, 0.5, 0.75, 1.0)
_STRANGE = ("'x'", "None", "1j", "[]", "(0.5,)", "b'a'", "object", "np.zeros(3)", "float('nan')",
            "1e39", "10**30",
            "Holding(1.0)", "Striking(0.5)", "Striking(0.5, Refusal)")  # fmt: skip
"""Where a number is wanted."""
_ODD_NUMBERS = ("np.float32({})", "np.float64({})", "np.float16({})", "ctypes.c_float({})",
                "ctypes.c_double({})", "np.array({})", "Striking({}, None)",
                "np.longdouble({})")  # fmt: skip
_ODD_WHOLES = ("np.int32({})", "np.uint8({})", "ctypes.c_int({})", "ctypes.c_uint({})",
               "np.array({})", "Striking({}, None)", "{}.0", "str({})", "np.int64({})",
               "{} + 2**32")  # fmt: skip


_SIZED = re.compile(r"gl(Vertex|Color|Normal|TexCoord|Rect)\d?\w{1,2}v\(")
"""Calls whose arrays are of one size."""


class Writer:
    """One program in the making."""

    def __init__(self, chance: random.Random) -> None:
        self.chance = chance
        self.steps: list[str] = []
        self.names: dict[str, list[str]] = {}
        """Variables that hold names of objects, by class: texture, buffer, list and so on."""
        self._made = 0
        self.odd = chance.choice((0.0, 0.0, 0.02, 0.1))
        """How likely an argument is of an unusual kind, or strange."""
        self.sizes = True
        """Whether PyOpenGL looks at the sizes of arrays: else it reads what is not there."""
        self._sized = False
        self.compiles = False
        """A list is open."""

    # -- steps -----------------------------------------------------------------------------------

    def say(self, *steps: str) -> None:
        """Append them."""
        self.steps.extend(steps)

    def call(self, name: str, *args: Any) -> None:
        """A call of OpenGL.GL."""
        self.say(f"GL.{name}({', '.join(map(str, args))})")

    def make(self, kind: str, expression: str) -> str:
        """A step that names its value; gives the name."""
        name = self.fresh(kind[0])
        self.say(f"{name} = {expression}")
        self.names.setdefault(kind, []).append(name)
        return name

    def fresh(self, letter: str = "v") -> str:
        """A new variable."""
        self._made += 1
        return f"{letter}{self._made}"

    # -- chance ----------------------------------------------------------------------------------

    def maybe(self, probability: float) -> bool:
        """True so often."""
        return self.chance.random() < probability

    def pick(self, choices: Sequence[T]) -> T:
        """One of them."""
        return choices[int(self.chance.random() * len(choices))]

    def weighted(self, choices: Mapping[T, float]) -> T:
        """One of them, by weight."""
        return self.chance.choices(list(choices), list(choices.values()))[0]

    def some(self, choices: Sequence[T], most: int) -> list[T]:
        """Up to so many, none twice."""
        count = min(len(choices), self.chance.randint(1, most))
        return self.chance.sample(list(choices), count)

    def whole(self, low: int, high: int) -> int:
        """Both ends may come."""
        return self.chance.randint(low, high)

    # -- arguments -------------------------------------------------------------------------------

    def enum(self, name: str) -> str:
        """``GL_LIGHT0`` as an argument."""
        text = f"GL.{name}"
        if self.maybe(self.odd / 4):
            return self.pick((f"int({text})", f"np.uint32({text})", f"ctypes.c_uint({text})",
                              f"Holding({text})", f"float({text})", "0xFFFF", "-1"))  # fmt: skip
        return text

    def enums(self, *names: str) -> str:
        """One of these."""
        return self.enum("GL_" + self.pick(names))

    def real(self, *choices: float) -> str:
        """A number as an argument."""
        value = self.pick(choices or COORDINATES)
        if self.maybe(self.odd):
            return (
                self.pick(_STRANGE) if self.maybe(0.25) else self.pick(_ODD_NUMBERS).format(value)
            )
        return str(value)

    def reals(self, count: int, *choices: float) -> str:
        """So many, comma-separated."""
        return ", ".join(self.real(*choices) for _ in range(count))

    def integer(self, low: int, high: int) -> str:
        """A whole number as an argument."""
        value = self.whole(low, high)
        if self.maybe(self.odd):
            return self.pick(_STRANGE) if self.maybe(0.25) else self.pick(_ODD_WHOLES).format(value)
        return str(value)

    def vector(self, count: int, kind: str = "f", *choices: float) -> str:
        """A sequence of so many numbers, as one of all the things that PyOpenGL takes for an array.
        kind: a dtype's letter, which most of them have."""
        if self.maybe(self.odd / 2):
            count = max(0, count + self.pick((1, 13, -1, -count) if self._sized else (1, 13)))
        values = [self.pick(choices or COORDINATES) for _ in range(count)]
        if kind not in "fd":
            values = [int(value) for value in values]
        inside = ", ".join(map(str, values))
        if count == 1:
            inside += ","
        forms = ["({})", "[{}]", "np.array(({}), 'KIND')"]
        if self.maybe(self.odd * 2):
            forms = ["np.array(({}), 'd')", "np.array(({}), 'f')", "np.array(({}), '>f4')",
                     "np.array((({}),), 'KIND')", "np.array(({}), 'KIND')[::-1]",
                     "np.array(({}), 'i')", "np.array(({}), '?')",
                     "np.array(({}), 'KIND').tobytes()", "memoryview(np.array(({}), 'KIND'))",
                     "np.array(({}), 'KIND').ctypes.data_as(ctypes.c_void_p)", "iter(({}))",
                     "np.array(({}), object)", "range(4)", "'abcdefgh'",
                     f"(ctypes.c_float * {count})({{}})", f"(ctypes.c_double * {count})({{}})",
                     f"(ctypes.c_int * {count})({{}})"]  # fmt: skip
        return self.pick(forms).replace("KIND", kind).format(inside)

    def matrix(self) -> str:
        """Sixteen numbers, near the identity."""
        rows = [[self.pick((0.0, 0.0, 0.25)) + (i == j) for j in range(4)] for i in range(4)]
        text = ", ".join(f"({', '.join(map(str, row))})" for row in rows)
        return self.pick(("({})", "np.array(({}), 'f')", "np.array(({}), 'd')", "[{}]")).format(
            text
        )

    def fill(self, template: str) -> str:
        """A text with its places filled: ``GL.glFogf({FOG_START|FOG_END}, {r 0.5 4.0})``.

        ``{A|B}`` one of these enums, ``{@Group}`` one of a group of the registry's, ``{3r}`` reals,
        ``{3u}`` reals from 0 to 1, ``{r 0.5 4.0}`` one of these, ``{-2..5}`` a whole number,
        ``{v4f}`` a vector of a dtype, ``{v4fu}`` of reals from 0 to 1, ``{flag}`` a boolean,
        ``{matrix}``, and ``{texture}`` (or another class) the name of an object.
        """
        self._sized = self.sizes and bool(_SIZED.search(template))
        return re.sub(r"\{([^{}]+)\}", lambda match: self._filled(match[1]), template)

    def _filled(self, place: str) -> str:
        if place[0] == "@":
            return self.enum(self.pick(registry().groups[place[1:]]))
        if place[0].isupper():
            return self.enum("GL_" + self.pick(place.split("|")))
        if match := re.fullmatch(r"(\d*)([ru])((?: -?[\d.]+)*)", place):
            choices = tuple(map(float, match[3].split())) or (UNITS if match[2] == "u" else ())
            return self.reals(int(match[1] or 1), *choices)
        if match := re.fullmatch(r"(-?\d+)\.\.(-?\d+)", place):
            return self.integer(int(match[1]), int(match[2]))
        if match := re.fullmatch(r"v(\d+)(\w)(u?)", place):
            return self.vector(int(match[1]), match[2], *(UNITS if match[3] else ()))
        if place == "matrix":
            return self.matrix()
        if place == "flag":
            return self.pick(("True", "False", "True", "False", "1", "0", "GL.GL_TRUE"))
        return self.name(place)

    def row(self, *tables: Sequence[str]) -> str:
        """A template of one of the tables, filled."""
        return self.fill(self.pick(self.pick(tables)))

    def name(self, kind: str, strange: float = 0.08) -> str:
        """An object of that class that the program has made, or 0, or a number that it has not."""
        known = self.names.get(kind)
        if known and not self.maybe(strange):
            return self.pick(known)
        return self.pick(("0", "1", "2", "3", "5", "7", "1000", "2**31 + 3"))


Area = Callable[[Writer], None]
AREAS: dict[Area, float] = {}
"""By weight."""


def area(weight: float) -> Callable[[Area], Area]:
    """Decorator: what a program may do, and how often."""

    def register(function: Area) -> Area:
        AREAS[function] = weight
        return function

    return register
