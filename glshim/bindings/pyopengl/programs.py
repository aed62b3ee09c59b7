"""The program's own names of programs and shaders, where its driver counts upwards and has given
ours some in between: the driver hears its names, the program what it would be told without us
(`glshim.driver.objects.Programs`).
"""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from typing import Any

import numpy as np

from glshim.bindings.pyopengl.raw import Call, Maker
from glshim.bindings.pyopengl.recorder import RECORDER
from glshim.driver import objects
from glshim.driver.arguments import name as name_among
from glshim.driver.arguments import place_of
from glshim.driver.functions import LETTERS
from glshim.spec import naming
from glshim.system import memory
from glshim.system.interrupts import Held

Translate = Callable[[int], int]


def made(call: Callable[[], Any], then: Callable[[], None]) -> Any:
    """Make a call, and do something once the driver has made it: also where PyOpenGL finds an error
    afterwards, which may be an older one."""
    from OpenGL.error import GLError  # not before the program has set its flags

    try:
        result = call()
    except GLError:
        then()
        raise
    then()
    return result


def maker_of(name: str) -> Maker | None:
    """What makes the hook of a call, if names of programs or shaders are in it."""
    if naming.makes(name):
        return _making
    if naming.returns(name):
        return _returning
    if name in naming.ANSWERS:
        letter, position = naming.ANSWERS[name]
        return _answering(LETTERS[letter], position)
    row = naming.row_of_names(name)
    if row is not None:
        return _listing(*row, naming.places_of(name))
    if naming.labels(name):
        return _labelling
    places = naming.places_of(name)
    return _taking(places) if places else None


def space() -> objects.Space | None:
    """The names of the current context, if any of ours are among them. Inside a primitive none: GL
    gives none there. Mesa does, and lets programs be used, while a list is compiled."""
    record = RECORDER.record
    if record.inside() and not record.list_open:
        return None
    return objects.space(ask=may_ask())


def may_ask() -> bool:
    """Whether the driver is outside primitives: to ask inside is an error that the program would
    find."""
    record = RECORDER.record
    return record.only_compiled or not record.inside()


def _programs() -> objects.Programs | None:
    found = space()
    return None if found is None else found.programs


def _making(real: Call) -> Call:
    def hook(*args: Any, **named: Any) -> Any:
        programs = _programs()
        if programs is None:
            return real(*args, **named)
        with Held():
            return _told(
                lambda made: programs.entered(made, ask=may_ask()) if made else made,
                real, args, named)

    return hook


def _returning(real: Call) -> Call:
    def hook(*args: Any, **named: Any) -> Any:
        programs = _programs()
        if programs is None:
            return real(*args, **named)
        return _told(programs.own, real, args, named)

    return hook


def _told(own: Translate, real: Call, args: tuple[Any, ...], named: dict[str, Any]) -> Any:
    """The program's own name of what a call returns, also where PyOpenGL finds an error and puts
    that into it: the call was made then."""
    from OpenGL.error import GLError  # not before the program has set its flags

    try:
        return own(real(*args, **named))
    except GLError as error:
        if isinstance(error.result, int):
            error.result = own(error.result)
        raise


def _taking(places: tuple[int, ...]) -> Maker:
    last = max(places) + 1

    def maker(real: Call) -> Call:
        def hook(*args: Any, **named: Any) -> Any:
            if len(args) >= last and any(objects.is_news(name_among(args, at)) for at in places):
                return _call(real, _translated(args, places), args, named)
            return real(*args, **named)

        return hook

    return maker


def _call(
    real: Call, drivers: tuple[Any, ...], args: tuple[Any, ...], named: dict[str, Any]
) -> Any:
    """A call with the driver's names, whose errors tell of the program's own."""
    from OpenGL.error import GLError  # not before the program has set its flags

    try:
        return real(*drivers, **named)
    except GLError as error:
        error.cArguments = args
        raise


def _translated(args: tuple[Any, ...], places: tuple[int, ...]) -> tuple[Any, ...]:
    """Arguments as the driver has them."""
    programs = _programs()
    if programs is None:
        return args
    found = list(args)
    for at in places:
        own = name_among(args, at)
        drivers = programs.drivers(own)
        if drivers != own:
            found[at] = drivers
    return tuple(found)


def _labelling(real: Call) -> Call:
    def hook(*args: Any, **named: Any) -> Any:
        if len(args) > 1 and name_among(args, 0) in naming.LABELLED:
            return _call(real, _translated(args, (1,)), args, named)
        return real(*args, **named)

    return hook


def _answering(element: Any, position: int) -> Maker:
    """The memory for the answer comes after the question."""

    def maker(real: Call) -> Call:
        def hook(*args: Any, **named: Any) -> Any:
            def told() -> None:
                programs, address = _programs(), place_of(args[position])
                if programs is not None and address:
                    answer = element.from_address(address)
                    answer.value = programs.own(int(answer.value))

            if len(args) > position and name_among(args, position - 1) in naming.ASKED:
                return made(lambda: real(*args, **named), told)
            return real(*args, **named)

        return hook

    return maker


def _is_of_another_type(names: Any) -> bool:
    """Whether it is an array that PyOpenGL refuses."""
    return type(names) is np.ndarray and names.dtype != np.uint32


def _listing(count: int, array: int, places: tuple[int, ...]) -> Maker:
    """Shaders in an array: what is given to the driver, or what it gives."""

    def maker(real: Call) -> Call:
        def given(programs: objects.Programs, args: tuple[Any, ...]) -> tuple[Any, ...]:
            some, names = name_among(args, count), args[array]
            if not 0 < some < 1 << 16 or not place_of(names) or _is_of_another_type(names):
                return args
            found = memory.read(place_of(names), 4 * some)  # which may be refused yet
            own = () if found is None else found.view(np.uint32).tolist()
            if not any(map(objects.is_news, own)):
                return args
            drivers = (ctypes.c_uint * some)(*map(programs.drivers, own))
            return (*args[:array], drivers, *args[array + 1 :])

        def told(programs: objects.Programs, args: tuple[Any, ...]) -> None:
            there, address = place_of(args[count]), place_of(args[array])
            if not there or not address:
                return
            some = ctypes.c_int.from_address(there).value
            names = (ctypes.c_uint * max(some, 0)).from_address(address)
            for k, name in enumerate(names):
                names[k] = programs.own(name)

        def hook(*args: Any, **named: Any) -> Any:
            programs = _programs()
            if programs is None or len(args) <= max(count, array):
                return real(*args, **named)
            if not places:
                return _call(real, given(programs, args), args, named)
            with Held():
                drivers = _translated(args, places)
                return made(
                    lambda: _call(real, drivers, args, named), lambda: told(programs, args))

        return hook

    return maker
