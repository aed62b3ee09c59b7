"""OpenGL 1.0 to 4.6 as Khronos writes it down: each command with the groups of its parameters.

`registry.txt` was made from gl.xml (https://github.com/KhronosGroup/OpenGL-Registry, Copyright
2013-2020 The Khronos Group Inc., Apache-2.0): ``python -m tests.fuzz.registry PATH/gl.xml``.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

FILE = Path(__file__).with_name("registry.txt")


@dataclass(frozen=True, slots=True)
class Parameter:
    """One parameter of a command."""

    name: str
    type: str
    """The C type without const and star: GLenum, GLfloat, void."""
    pointer: str
    """``in`` for what is read, ``out`` for what is written, empty for a value."""
    kind: str
    """A group of enums (``TextureTarget``) or a class of objects (``texture``), or empty."""
    length: str
    """Of a pointer, as gl.xml says it: ``4``, ``n``, ``COMPSIZE(pname)``, or empty."""


@dataclass(frozen=True, slots=True)
class Command:
    """One command."""

    name: str
    version: str
    result: str
    parameters: tuple[Parameter, ...]

    @property
    def module(self) -> str:
        """PyOpenGL's, below ``OpenGL.raw.GL.VERSION``."""
        return f"GL_{self.version.replace('.', '_')}"


@dataclass
class Registry:
    """All there is."""

    commands: dict[str, Command] = field(default_factory=dict)
    groups: dict[str, tuple[str, ...]] = field(default_factory=dict)
    """Names of enums by group, those of these versions alone."""


@cache
def registry() -> Registry:
    """What `registry.txt` holds."""
    found, version = Registry(), ""
    for line in FILE.read_text().splitlines():
        first, *rest = line.split()
        if first == "#":
            continue
        if first == "version":
            version = rest[0]
        elif first == "group":
            found.groups[rest[0]] = tuple(rest[1:])
        else:
            parameters = tuple(Parameter(*_words(word)) for word in rest[1:])
            found.commands[first] = Command(first, version, rest[0], parameters)
    return found


def _words(text: str) -> Iterator[str]:
    for word in text.split("/"):
        yield word.replace("_", " ") if word == "display_list" else word


def _typed(node: Any) -> tuple[str, str, str]:
    """Name, C type, direction."""
    text = "".join(node.itertext())
    name = node.find("name").text
    kind = node.find("ptype")
    base = kind.text if kind is not None else "void"
    star = "*" in text
    pointer = ("in" if "const" in text else "out") if star else ""
    return name, base, pointer


def lines(path: Path) -> Iterator[str]:
    """The lines of `registry.txt`, from gl.xml."""
    root = ElementTree.parse(path).getroot()
    yield "# From gl.xml: Copyright 2013-2020 The Khronos Group Inc., Apache-2.0"
    nodes = {node.findtext("proto/name"): node for node in root.iterfind("commands/command")}
    enums, used = set(), set()
    for feature in root.iter("feature"):
        if feature.get("api") not in ("gl",):
            continue
        yield f"version {feature.get('number')}"
        for require in feature.iter("require"):
            if require.get("api") == "gles2":
                continue
            enums |= {node.get("name") for node in require.iter("enum")}
            for node in require.iter("command"):
                yield " ".join(_command(nodes[node.get("name")], used))
    members: dict[str, list[str]] = {}
    for node in root.iter("enum"):
        for group in (node.get("group") or "").split(","):
            if node.get("name") in enums and group in used:
                members.setdefault(group, []).append(str(node.get("name")))
    for group in sorted(members):
        yield " ".join(("group", group, *dict.fromkeys(members[group])))


def _command(node: Any, used: set[str]) -> Iterator[str]:
    proto = node.find("proto")
    name, base, pointer = _typed(proto)
    yield name
    yield base + ("*" if pointer else "")
    for parameter in node.iter("param"):
        name, base, pointer = _typed(parameter)
        group = parameter.get("group")
        if group:
            used.add(group)
        kind = group or (parameter.get("class") or "").replace(" ", "_")
        length = re.sub(r"\s", "", parameter.get("len") or "").replace("/", "|")
        yield "/".join((name, base, pointer, kind, length))


if __name__ == "__main__":
    FILE.write_text("\n".join(lines(Path(sys.argv[1]))) + "\n")
