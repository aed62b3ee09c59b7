"""G-code as strands of plastic: G0, G1, G28, G90, G91, G92, M82 and M83, in millimetres."""

import math
import re
from dataclasses import dataclass, field

FILAMENT = math.pi * (1.75 / 2) ** 2  # square millimetres


class BadFile(Exception):
    """The file is no G-code that can be shown; the message is one line."""


@dataclass
class Strand:
    """Plastic laid in one go: points (n, 3), the widths (n - 1,) of its pieces, and its kind."""

    kind: str
    height: float
    points: list[tuple[float, float, float]] = field(default_factory=list)
    widths: list[float] = field(default_factory=list)

    @property
    def closed(self) -> bool:
        return math.dist(self.points[0], self.points[-1]) < 1e-6


def words(line: str, number: int) -> dict[str, float]:
    """The letters of a command and their numbers, without its comments."""
    code = re.sub(r"\(.*?\)", "", line.partition(";")[0]).upper().strip()
    if not code.startswith(("G", "X", "Y", "Z", "E")):
        code = code.split()[0] if code else ""  # M117 takes text, which is nobody's number
    found = {}
    for letter, value in re.findall(r"([A-Z])\s*([^A-Z\s]*)", code):
        try:
            found[letter] = float(value or "0")
        except ValueError:
            raise BadFile(f"line {number}: {letter + value!r} is no number") from None
    return found


def parsed(text: str) -> list[Strand]:
    """The strands of a G-code program, in the order in which they are printed."""
    strands: list[Strand] = []
    place = {"X": 0.0, "Y": 0.0, "Z": 0.0, "E": 0.0}
    absolute = {"X": True, "Y": True, "Z": True, "E": True}
    kind, floor, level, going = "", 0.0, 0.0, False
    for number, line in enumerate(text.splitlines(), 1):
        if line.startswith(";TYPE:"):
            kind, going = line[6:].strip().upper().replace(" ", "-"), False
        word = words(line, number)
        if word.get("M") in (82, 83):
            absolute["E"] = word["M"] == 82
        code = word.get("G")
        if code in (90, 91):
            absolute = dict.fromkeys(absolute, code == 90)
        elif code == 28:
            place |= {"X": 0.0, "Y": 0.0, "Z": 0.0}
        elif code == 92:
            place |= {axis: word[axis] for axis in place if axis in word}
        elif code in (0, 1):
            before = dict(place)
            for axis in place.keys() & word.keys():
                place[axis] = word[axis] + (0.0 if absolute[axis] else place[axis])
            start, end = ((p["X"], p["Y"], p["Z"]) for p in (before, place))
            far, pushed = math.dist(start, end), place["E"] - before["E"]
            if not all(map(math.isfinite, end)):
                raise BadFile(f"line {number}: a place that is no number")
            if pushed <= 0 or far < 1e-6:
                going = False
                continue
            if place["Z"] > level + 1e-6:
                floor, level = level, place["Z"]
            if not going:
                strands.append(Strand(kind, max(level - floor, 0.05), [start]))
            strands[-1].points.append(end)
            strands[-1].widths.append(min(pushed * FILAMENT / far / strands[-1].height, 5.0))
            going = True
    if not strands:
        raise BadFile("no G1 with an E in it: nothing is printed")
    return strands
