"""Which calls make an object of a name that a program chose: asked of the driver, call by call."""

from __future__ import annotations

import random

import numpy as np
import pytest
from OpenGL import GL

from glshim.spec.naming import Naming, row_of
from tests.differential.world import window
from tests.fuzz.bare import driver
from tests.fuzz.registry import Command, registry

TRIES = 20
"""Calls of each command, with arguments by chance."""
DEADLY = ("glInvalidateTexSubImage",)
"""Mesa 22.3 dies of these where the name is nobody's."""
IS = {kind: f"glIs{kind.title()}" for kind in ("texture", "buffer", "framebuffer", "renderbuffer")}
COMMANDS = [
    (command, parameter.kind)
    for command in registry().commands.values()
    for parameter in command.parameters
    if parameter.kind in IS and not parameter.pointer
    and not command.name.startswith(("glIs", *DEADLY))
]  # fmt: skip


def called(command: Command, kind: str, name: int, chance: random.Random, room: int) -> None:
    """Call it with the name; nothing is to be read or written but some bytes of `room`."""
    arguments: list[int] = []
    for each in command.parameters:
        if each.pointer:
            arguments.append(room)
        elif each.kind == kind:
            arguments.append(name)
        elif each.type == "GLenum":
            group = registry().groups.get(each.kind) or ("GL_TEXTURE_2D",)
            arguments.append(int(getattr(GL, chance.choice(group), 0)))
        else:
            arguments.append(chance.choice((0, 1)))
    getattr(driver, command.name)(*arguments)


def test_every_call_that_makes_an_object_is_known() -> None:
    chance = random.Random(1)
    room = np.zeros(1 << 20, np.uint8)
    name, makers = 5000, set()
    with window(32, 32):
        for command, kind in COMMANDS:
            try:
                getattr(driver, command.name)
            except AttributeError:
                continue
            for _ in range(TRIES):
                name += 1
                called(command, kind, name, chance, room.ctypes.data)
                if getattr(driver, IS[kind])(name):
                    makers.add(command.name)
            driver.glGetError()
    if not {"glBindTexture", "glBindBuffer", "glBindFramebuffer"} <= makers:
        pytest.skip("this driver makes no object of a name that it has not given")
    for each in sorted(makers):
        row = row_of(each)
        assert row is not None, each
        assert row.naming is Naming.MEETS, each
