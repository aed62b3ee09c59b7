"""The version of the current context, and what older ones may lack. Asked without GL errors."""

from __future__ import annotations

import ctypes
import re
from functools import cache
from threading import local

from glshim.driver.ask import integer, is_enabled, text
from glshim.driver.functions import current_context, gl
from glshim.spec.constants import (
    GL_CONTEXT_CORE_PROFILE_BIT,
    GL_CONTEXT_PROFILE_MASK,
    GL_DRAW_FRAMEBUFFER,
    GL_EXTENSIONS,
    GL_FRAMEBUFFER_COMPLETE,
    GL_LIST_INDEX,
    GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS,
    GL_NUM_EXTENSIONS,
    GL_PRIMITIVE_RESTART,
    GL_PRIMITIVE_RESTART_FIXED_INDEX,
    GL_PROGRAM_PIPELINE_BINDING,
    GL_VERSION,
    GL_VERTEX_PROGRAM_ARB,
    GL_VERTEX_SHADER_EXT,
)

Version = tuple[int, int]

MODERN: Version = (3, 3)
"""From here on the GPU expands line records to strokes."""
OLDEST: Version = (2, 1)
"""From here on the CPU does: fragments still need GLSL 1.20."""
UNAVAILABLE = "intersections need OpenGL {}.{}".format(*MODERN)
"""What older contexts go without, in words."""
NO_FIXED_FUNCTION = "a core profile has no fixed-function pipeline to follow"
_FRAMEBUFFERS, _VERTEX_ARRAYS = "GL_ARB_framebuffer_object", "GL_ARB_vertex_array_object"
_RESTARTS = ((GL_PRIMITIVE_RESTART, (3, 1)), (GL_PRIMITIVE_RESTART_FIXED_INDEX, (4, 3)))
_UNITS_NEEDED = 16
_NEVER: Version = (99, 0)
_OTHER_PROGRAMS = {
    GL_VERTEX_PROGRAM_ARB: (_NEVER, ("GL_ARB_vertex_program", "GL_NV_vertex_program")),
    GL_VERTEX_SHADER_EXT: (_NEVER, ("GL_EXT_vertex_shader",)),
    GL_PROGRAM_PIPELINE_BINDING: ((4, 1), ("GL_ARB_separate_shader_objects",)),
}
PROGRAM_SWITCHES = (GL_VERTEX_PROGRAM_ARB, GL_VERTEX_SHADER_EXT)
"""Older kinds of programs, of assembly's: each is on or off."""


class _Kept(local):
    """What the driver said of itself in a context of this thread whose list is open."""

    context = 0
    text = ""


_kept = _Kept()


def list_opened() -> None:
    """A display list is being compiled from here on: what the driver says of itself is not asked
    again until `list_closed`. Mesa may find an error in that there (see `ask.is_enabled`)."""
    _kept.text, _kept.context = text(GL_VERSION), current_context()
    _extensions(_kept.text)


def list_is_open() -> bool:
    """Whether this thread compiles a list, as far as was told."""
    return bool(_kept.text) and _kept.context == current_context()


def list_closed() -> None:
    """It is whole."""
    _kept.text = ""


def version_text() -> str:
    """What the driver says, empty without a context."""
    if _kept.text and _kept.context == current_context():
        return _kept.text
    return text(GL_VERSION)


def version() -> Version | None:
    """Of desktop OpenGL; None for anything else."""
    return _number(version_text())


def number_of_any_api() -> Version:
    """Of OpenGL or OpenGL ES, which says its name first; 1.1 where the driver tells none."""
    found = re.search(r"(\d+)\.(\d+)", version_text())
    return (int(found[1]), int(found[2])) if found else (1, 1)


@cache
def _number(told: str) -> Version | None:
    found = re.match(r"(\d+)\.(\d+)", told)
    return (int(found[1]), int(found[2])) if found else None


def restarts_primitives() -> bool:
    """Whether some index ends a primitive in the draws of now. Asks what this version knows."""
    number = version() or OLDEST
    return any(number >= since and is_enabled(switch) for switch, since in _RESTARTS)


def is_complete(framebuffer: int) -> bool:
    """Whether the framebuffer that is bound for drawing can be drawn into; a window's can."""
    return not framebuffer or bool(
        gl.glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE
    )


def compiles_a_list() -> bool:
    """Whether the driver is compiling a display list. Ask outside a primitive."""
    return bool(current_context() and has_fixed_function() and integer(GL_LIST_INDEX))


def has_vertex_arrays() -> bool:
    """Whether there are vertex array objects: since 3.0, and where 2.1 has been extended."""
    return _has((3, 0), _VERTEX_ARRAYS)


def other_programs() -> tuple[int, ...]:
    """Names of the integers that are not zero where the app may have its vertices go through a
    program that is not glUseProgram's: those that this driver knows."""
    return tuple(
        name
        for name, (since, extensions) in _OTHER_PROGRAMS.items()
        if any(_has(since, extension) for extension in extensions)
    )


def has_pipelines() -> bool:
    """Whether there are program pipelines."""
    since, extensions = _OTHER_PROGRAMS[GL_PROGRAM_PIPELINE_BINDING]
    return _has(since, *extensions)


def has_framebuffers() -> bool:
    """Whether there are framebuffer objects: since 3.0, and where older versions were extended."""
    return _has((3, 0), _FRAMEBUFFERS)


def has_fixed_function() -> bool:
    """Whether a context of desktop OpenGL is current that has the fixed-function pipeline."""
    number = version()
    return number is not None and _has_fixed_function(number)


def shortcoming() -> str:
    """Why no lines can be drawn in the current context, whoever expands them; empty if they can."""
    number = version()
    if number is None:
        return f"version {version_text()!r} is not desktop OpenGL"
    if number < OLDEST:
        return "OpenGL {}.{} is older than {}.{}".format(*number, *OLDEST)
    if not has_framebuffers():
        return "OpenGL {}.{} without {}".format(*number, _FRAMEBUFFERS)
    if not _has_fixed_function(number):
        return NO_FIXED_FUNCTION
    units = integer(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS)
    if units < _UNITS_NEEDED:
        return f"{units} texture units, and lines need {_UNITS_NEEDED}"
    return ""


def _has_fixed_function(number: Version) -> bool:
    """3.1 says so in an extension, later versions have profiles."""
    if number < (3, 1):
        return True
    if number > (3, 1):
        return not integer(GL_CONTEXT_PROFILE_MASK) & GL_CONTEXT_CORE_PROFILE_BIT
    return "GL_ARB_compatibility" in _extensions(version_text())


def has_turned_framebuffers() -> bool:
    """Whether the rows of a framebuffer object can lie as a window's do in Mesa."""
    return "GL_MESA_framebuffer_flip_y" in _extensions(version_text())


def has_debug_output() -> bool:
    """Whether there is debug output, with a switch."""
    return _has((4, 3), "GL_KHR_debug")


def has_pauses() -> bool:
    """Whether transform feedback can be paused."""
    return _has((4, 0), "GL_ARB_transform_feedback2")


def _has(since: Version, extension: str) -> bool:
    told = version_text()
    number = _number(told)
    if number is None:
        return False
    return number >= since or extension in _extensions(told)


@cache
def _extensions(told: str) -> frozenset[str]:
    """Of contexts of a version, which drivers give in full text."""
    if (_number(told) or OLDEST) < (3, 0):
        return frozenset(text(GL_EXTENSIONS).split())
    names = (gl.glGetStringi(GL_EXTENSIONS, i) for i in range(integer(GL_NUM_EXTENSIONS)))
    return frozenset(ctypes.string_at(name).decode("ascii", "replace") for name in names)
