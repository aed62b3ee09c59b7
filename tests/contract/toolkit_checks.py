"""The contract of toolkits: what holds for each, whatever it is hooked by. A check is given a rig
that has hooked nothing yet."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from glshim.toolkits import Part, frames, keyboard
from glshim.toolkits.base import Toolkit
from glshim.toolkits.frames import Stage

from .toolkits import SIZE, Rig


@contextmanager
def listening(rig: Rig) -> Iterator[None]:
    """Frame ends are noted in the rig's log."""
    def before() -> None:
        rig.log.append(f"{frames.drawable_size()} in {frames.drawable_framebuffer()}")

    listener = frames.listen(Stage.DRAW, before=before, after=lambda: rig.log.append("after"))
    try:
        yield
    finally:
        listener.stop()


class Ours:
    """Owns F5."""

    def __init__(self) -> None:
        self.pressed: list[str] = []

    def owns(self, chord: str) -> bool:
        return chord == "F5"

    claims = owns

    def press(self, chord: str) -> None:
        self.pressed.append(chord)


@contextmanager
def owning() -> Iterator[list[str]]:
    """What was pressed of ours."""
    ours = Ours()
    keyboard.listen(ours)
    try:
        yield ours.pressed
    finally:
        keyboard.listen(None)


def lacking(toolkit: Toolkit) -> set[Part]:
    """The parts that a toolkit's file says nothing of."""
    kind = type(toolkit)
    hooked = {hook.part for hook in toolkit.hooks()}
    own = {Part.SIZE: kind.size is not Toolkit.size, Part.REDRAW: kind.redraw is not Toolkit.redraw}
    own[Part.DISPLAYLESS] = True  # said by `displayless`
    return {part for part in Part if not own.get(part, part in hooked)}


def one_frame(rig: Rig) -> list[str]:
    """What happens, in order, when a frame is shown."""
    size = SIZE if Part.SIZE not in rig.toolkit.lacks else None
    before = f"{size} in {rig.framebuffer}"
    if rig.shows_by_itself:
        return ["shown", before, "after"]
    return [before, "shown", "after"]


def frames_end_once_each(rig: Rig) -> None:
    rig.toolkit.watch(Part.FRAMES)
    rig.toolkit.watch(Part.FRAMES)
    rig.take()
    rig.open()
    assert rig.present() in (7, None)  # nobody listens: the toolkit's own call alone
    assert rig.log == ["shown"]
    for _ in range(2):
        rig.log.clear()
        with listening(rig):
            assert rig.present() in (7, None)
        assert rig.log == one_frame(rig)


def names_that_were_taken_before_are_followed(rig: Rig) -> None:
    if rig.takes_early:
        rig.take()
        rig.toolkit.watch(Part.FRAMES)
        rig.open()
        with listening(rig):
            rig.present()
        assert rig.log == one_frame(rig)
    else:  # start-up hooks it as it is imported: it knows the file by the package's name
        assert type(rig.toolkit).__module__.endswith(f".{rig.toolkit.package}")


def it_is_left_as_it_was_found(rig: Rig) -> None:
    found = snapshot(rig.modules)
    for part in (Part.FRAMES, Part.KEYS, Part.CLOCK):
        rig.toolkit.watch(part)
    assert changed(found, snapshot(rig.modules))
    for part in Part:
        rig.toolkit.release(part)
    assert not changed(found, snapshot(rig.modules))
    rig.take()
    rig.open()
    with listening(rig):
        rig.present()
    assert rig.log == ["shown"]


def names_taken_while_it_was_hooked_outlive_that(rig: Rig) -> None:
    rig.toolkit.watch(Part.FRAMES)
    rig.take()
    rig.open()
    rig.toolkit.release(Part.FRAMES)
    rig.present()
    assert rig.log == ["shown"]
    rig.log.clear()
    rig.toolkit.watch(Part.FRAMES)
    with listening(rig):
        rig.present()
    assert rig.log == one_frame(rig)


def keys_are_ours_or_the_programs(rig: Rig) -> None:
    if Part.KEYS in rig.toolkit.lacks or not rig.has_a_user:
        return
    rig.toolkit.watch(Part.FRAMES)
    rig.toolkit.watch(Part.KEYS)
    rig.take()
    rig.open()
    with listening(rig), owning() as pressed:
        rig.present()
        rig.toolkit.window_is_there()
        for _ in range(2):
            for name in ("F5", "X"):
                rig.key(name, True)
                rig.key(name, False)
        assert pressed == ["F5", "F5"]
        assert rig.got == [("X", True), ("X", False)] * 2
    rig.got.clear()
    rig.key("F5", True)
    rig.key("F5", False)
    assert rig.got == [("F5", True), ("F5", False)]


def another_frame_is_asked_for(rig: Rig) -> None:
    if Part.REDRAW in rig.toolkit.lacks:
        return
    rig.toolkit.watch(Part.FRAMES)
    rig.toolkit.watch(Part.KEYS)
    rig.take()
    rig.open()
    with listening(rig):
        rig.present()
        rig.toolkit.window_is_there()
    before = rig.redraws()
    rig.toolkit.redraw()
    assert rig.redraws() == before + 1


def the_clock_stands_still(rig: Rig) -> None:
    if Part.CLOCK in rig.toolkit.lacks:
        return
    moment = rig.toolkit.moment = type(rig.toolkit.moment)()
    rig.toolkit.watch(Part.CLOCK)
    rig.take()
    assert rig.seconds() == rig.seconds() == 0
    moment.frame_ends()
    moment.pass_by(1.0)
    assert abs(rig.seconds() - moment.now) < 1e-6
    moment.held = True
    moment.frame_ends()
    assert abs(rig.seconds() - moment.now) < 1e-6


def what_is_lacking_is_declared(rig: Rig) -> None:
    assert set(rig.toolkit.lacks) == lacking(rig.toolkit)
    assert all(rig.toolkit.lacks.values())
    if any(hook.part is Part.DISPLAYLESS for hook in rig.toolkit.hooks()):
        assert rig.toolkit.displayless is not None


CHECKS: tuple[Callable[[Rig], None], ...] = (
    frames_end_once_each,
    names_that_were_taken_before_are_followed,
    it_is_left_as_it_was_found,
    names_taken_while_it_was_hooked_outlive_that,
    keys_are_ours_or_the_programs,
    another_frame_is_asked_for,
    the_clock_stands_still,
    what_is_lacking_is_declared,
)

Snapshot = dict[tuple[str, ...], Any]


def snapshot(modules: dict[str, Any]) -> Snapshot:
    """What the names of modules stand for, with the attributes of classes and of objects."""
    found: Snapshot = {}
    for module, value in modules.items():
        for name, each in list(vars(value).items()):
            found[module, name] = each
            if callable(each):
                found[module, name, "class"] = type(each)
                found[module, name, "class", "call"] = vars(type(each)).get("__call__")
            if not name.startswith("__") and type(each).__module__ != "builtins":
                for inner, part in list(getattr(each, "__dict__", {}).items()):
                    found[module, name, inner] = part
            elif isinstance(each, type):
                found |= {(module, name, inner): part for inner, part in vars(each).items()}
    return found


def changed(before: Snapshot, after: Snapshot) -> bool:
    """Whether one of the things that were there is another now."""
    return any(after.get(key) is not value for key, value in before.items()) or any(
        key not in before for key in after if key[-1] in ("paintGL", "__init_subclass__")
    )
