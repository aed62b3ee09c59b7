"""Every hooked name with every kind of argument: plain PyOpenGL against styles, under its flags."""

from __future__ import annotations

import json
import os
import random
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

WORKER = Path(__file__).with_name("worker.py")
ROOT = Path(__file__).parents[2]
FLAGS: dict[str, dict[str, Any]] = {
    "as it is": {},
    "no error checks": {"ERROR_CHECKING": False},
    "no copies": {"ERROR_ON_COPY": True},
    "no copies, no pointers": {"ERROR_ON_COPY": True, "STORE_POINTERS": False},
    "no sizes": {"ARRAY_SIZE_CHECKING": False},
    "contexts": {"CONTEXT_CHECKING": True},
    "error log": {"ERROR_LOGGING": True},
    "full log": {"FULL_LOGGING": True},
    "numpy scalars": {"ALLOW_NUMPY_SCALARS": True},
    "unpacked": {"SIZE_1_ARRAY_UNPACK": False},
    "images": {"UNSIGNED_BYTE_IMAGES_AS_STRING": False},
    "not accelerated": {"USE_ACCELERATE": False},
    "forward": {"FORWARD_COMPATIBLE_ONLY": True},
    "annotations": {"MODULE_ANNOTATIONS": True, "TYPE_ANNOTATIONS": True},
    "formats": {"WARN_ON_FORMAT_UNAVAILABLE": True},
}
"""Sets of PyOpenGL's flags."""
MIXED = "mixed "
"""Begins the name of a set by chance; a number follows."""


def flags_of(name: str) -> dict[str, Any]:
    """By the name of a set, the flags that differ from PyOpenGL's own choice."""
    if not name.startswith(MIXED):
        return FLAGS[name]
    every = {flag: value for flags in FLAGS.values() for flag, value in flags.items()}
    chance = random.Random(name)
    return {flag: value for flag, value in every.items() if chance.random() < 0.4}


STYLES = ("none", "raskar")


@dataclass
class Told:
    """What a process said."""

    total: int = 0
    """Cases there are."""
    cases: dict[int, str] = field(default_factory=dict)
    """By number, their names."""
    came: dict[int, str] = field(default_factory=dict)
    """By number, what came of them; nothing for those that ended the process."""
    crashed: list[int] = field(default_factory=list)
    said: str = ""
    """On standard error."""


def differences(plain: Told, styled: Told) -> dict[str, tuple[str | None, str | None]]:
    """By the name of a case what came of it, where that is another thing; and words of faults."""
    found: dict[str, tuple[str | None, str | None]] = {
        plain.cases[at]: (came, styled.came.get(at))
        for at, came in plain.came.items()
        if came != styled.came.get(at)
    }
    for word in ("Traceback", "by a fault of glshim", "switched off"):
        at = styled.said.find(word)
        if at >= 0 and word not in plain.said:
            found[word] = (None, json.dumps([styled.said[max(0, at - 500) : at + 4000]]))
    return found


def told(
    flags: str, style: str, *, count: int = 0, seed: int = 0, everything: bool = False,
    skipped: tuple[int, ...] = (), handler: bool = False, functions: int = 0,
    libraries: bool = False, others: str = "first", only: str = "",
) -> Told:  # fmt: skip
    """The cases under a set of flags, all or so many by chance, in as many processes as it takes:
    what kills plain PyOpenGL is left out. functions: of so many by chance, 0 for all. libraries: of
    GLU and GLUT. others: when other modules meddle with ctypes, "first" or "last"; see there.
    only: a regular expression that names are searched for."""
    found = Told()
    environment = {n: v for n, v in os.environ.items() if not n.startswith("GLSHIM_")}
    environment |= {"PYTHONPATH": str(ROOT), "PYTHONWARNINGS": "ignore"}
    if style:
        environment["GLSHIM_STYLE"] = style
    first = 0
    while True:
        given = json.dumps({"flags": flags_of(flags), "count": count, "seed": seed, "first": first,
                            "everything": everything, "handler": handler, "functions": functions,
                            "skipped": skipped, "libraries": libraries,
                            "others": others, "only": only})  # fmt: skip
        done = subprocess.run([sys.executable, str(WORKER), given], capture_output=True, text=True,
                              check=False, env=environment, errors="replace")  # fmt: skip
        found.said += done.stderr
        last = -1
        for line in done.stdout.splitlines():
            mark, _, rest = line.partition(" ")
            number, _, text = rest.partition(" ")
            if mark == "of":
                found.total = int(rest)
            elif mark == ">":
                last = int(number)
                found.cases[last] = text
            elif mark == "<":
                found.came[int(number)] = text
        if done.stdout.endswith("alive\n"):
            return found
        end = done.stdout.rpartition("\n")[0].rpartition("\n")[2]
        if end.startswith("again "):
            first = int(end.removeprefix("again "))
            continue
        given_up = done.stderr.rstrip().rpartition("\n")[2].startswith("freeglut (")
        if last < first or (done.returncode > 0 and not given_up):
            raise RuntimeError(done.stderr[-3000:])
        found.crashed.append(last)
        first = last + 1
