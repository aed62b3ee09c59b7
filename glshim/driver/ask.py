"""Questions to the driver about its state: one way to ask, past every hook, without GL errors."""

from __future__ import annotations

import ctypes

from glshim.driver.functions import gl
from glshim.spec.constants import (
    GL_CURRENT_COLOR,
    GL_TEXTURE_2D,
    GL_TEXTURE_HEIGHT,
    GL_TEXTURE_RECTANGLE,
    GL_TEXTURE_TARGET,
    GL_TEXTURE_WIDTH,
    GL_VERTEX_ATTRIB_ARRAY_POINTER,
)
from glshim.spec.pixels import TextureImage


def integer(name: int) -> int:
    """One integer of the state; 0 for a name that the driver does not know."""
    value = ctypes.c_int(0)
    gl.glGetIntegerv(name, ctypes.byref(value))
    return value.value


def integers(name: int, count: int) -> tuple[int, ...]:
    """Some integers of one name."""
    values = (ctypes.c_int * count)()
    gl.glGetIntegerv(name, values)
    return tuple(values)


def real(name: int) -> float:
    """One float of the state."""
    value = ctypes.c_float(0.0)
    gl.glGetFloatv(name, ctypes.byref(value))
    return value.value


def reals(name: int, count: int) -> tuple[float, ...]:
    """Some floats of one name."""
    values = (ctypes.c_float * count)()
    gl.glGetFloatv(name, values)
    return tuple(values)


def settle_attributes() -> None:
    """Have the driver take in what it was told of vertex attributes. Mesa may put what it still
    holds over what glPopAttrib brings back; it takes it in where one is asked for. Outside
    primitives, in a compatibility context."""
    reals(GL_CURRENT_COLOR, 4)


def is_enabled(switch: int) -> bool:
    """Whether a switch is on. Not by glIsEnabled: where a list that is executed as it is compiled
    has an attribute before a glEnd, Mesa takes the primitive for open and finds an error there."""
    value = ctypes.c_ubyte(0)
    gl.glGetBooleanv(switch, ctypes.byref(value))
    return bool(value.value)


def text(name: int) -> str:
    """A string of the driver's, empty without a context."""
    found = gl.glGetString(name)
    return ctypes.string_at(found).decode("ascii", "replace") if found else ""


def pointer_of(name: int) -> int:
    """An address, or the offset in a buffer, of the client's state; 0 for none."""
    address = ctypes.c_void_p()
    gl.glGetPointerv(name, ctypes.byref(address))
    return address.value or 0


def of_buffer(target: int, name: int) -> int:
    """One integer of the buffer object that is bound to a target."""
    value = ctypes.c_int(0)
    gl.glGetBufferParameteriv(target, name, ctypes.byref(value))
    return value.value


def of_material(face: int, name: int) -> tuple[float, ...]:
    """Four floats of the material of a face."""
    values = (ctypes.c_float * 4)()
    gl.glGetMaterialfv(face, name, values)
    return tuple(values)


def of_light(light: int, name: int) -> tuple[float, float, float, float]:
    """Four floats of a light; what has fewer is followed by zeros."""
    values = (ctypes.c_float * 4)()
    gl.glGetLightfv(light, name, values)
    return values[0], values[1], values[2], values[3]


def of_program(program: int, name: int) -> int:
    """One integer of a program object."""
    value = ctypes.c_int(0)
    gl.glGetProgramiv(program, name, ctypes.byref(value))
    return value.value


def of_attribute(position: int, name: int) -> int:
    """One integer of a generic vertex attribute."""
    value = ctypes.c_int(0)
    gl.glGetVertexAttribiv(position, name, ctypes.byref(value))
    return value.value


def pointer_of_attribute(position: int) -> int:
    """The address, or the offset in a buffer, of a generic vertex attribute; 0 for none."""
    address = ctypes.c_void_p()
    gl.glGetVertexAttribPointerv(position, GL_VERTEX_ATTRIB_ARRAY_POINTER, ctypes.byref(address))
    return address.value or 0


def of_binding(position: int, name: int) -> int:
    """One integer of a state that has several, by their positions."""
    value = ctypes.c_int(0)
    gl.glGetIntegeri_v(name, position, ctypes.byref(value))
    return value.value


def size_of(image: TextureImage) -> tuple[int, int] | None:
    """Width and height of a texture's level in pixels; None where it has not two dimensions."""
    value = ctypes.c_int(0)
    if image.texture:
        gl.glGetTextureParameteriv(image.texture, GL_TEXTURE_TARGET, ctypes.byref(value))
    target = value.value if image.texture else image.target
    if target not in (GL_TEXTURE_2D, GL_TEXTURE_RECTANGLE):
        return None
    found = []
    for name in (GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT):
        if image.texture:
            gl.glGetTextureLevelParameteriv(image.texture, image.level, name, ctypes.byref(value))
        else:
            gl.glGetTexLevelParameteriv(target, image.level, name, ctypes.byref(value))
        found.append(value.value)
    return found[0], found[1]
