"""Keys of toolkits that need not be installed: stand-ins in the shape of their modules."""

from __future__ import annotations

import ctypes
import enum
import functools
import sys
from collections.abc import Callable, Iterator
from types import SimpleNamespace
from typing import Any

import pytest

from glshim import toolkits
from glshim.toolkits import Part, Toolkit, keyboard, qt

from .toolkits.sdl2 import Event as SdlEvent
from .toolkits.sdl2 import Sdl2Rig

Hook = Callable[[str, Any], Toolkit]


class Listening:
    """Owns shift+F5 and K; claims K alone."""

    def __init__(self) -> None:
        self.pressed: list[str] = []

    def owns(self, chord: str) -> bool:
        return chord in ("shift+F5", "K")

    def claims(self, chord: str) -> bool:
        return chord == "K"

    def press(self, chord: str) -> None:
        self.pressed.append(chord)
        toolkits.redraw()


@pytest.fixture
def ours(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[str]]:
    """What was pressed of ours."""
    listening = Listening()
    keyboard.listen(listening)
    yield listening.pressed
    keyboard.listen(None)


@pytest.fixture
def hook(monkeypatch: pytest.MonkeyPatch) -> Hook:
    """Hooks the keys of the toolkit of that name in a module that stands for its own."""

    def put(name: str, module: Any) -> Toolkit:
        toolkit = fresh(name)
        monkeypatch.setattr(toolkits, "used", lambda: (toolkit,))
        (row,) = (row for row in toolkit.hooks() if row.part is Part.KEYS)
        module.__spec__ = None
        monkeypatch.setitem(sys.modules, row.module, module)
        toolkit.watch(Part.KEYS)
        return toolkit

    return put


def fresh(name: str) -> Toolkit:
    """One that has hooked nothing yet."""
    (kind,) = (type(toolkit) for toolkit in toolkits.used() if toolkit.name == name)
    return kind(name) if kind is qt.Qt else kind()  # type: ignore[arg-type]


# -- GLUT -----------------------------------------------------------------------------------------


class Glut:
    """The library, and what is registered with it for its window."""

    def __init__(self) -> None:
        self.registered: dict[str, Any] = {}
        self.window, self.modifiers = 1, 0
        self.asked: list[int] = []

    def glutGetModifiers(self) -> int:
        return self.modifiers

    def glutGetWindow(self) -> int:
        return self.window

    def glutPostWindowRedisplay(self, window: int) -> None:
        self.asked.append(window)


@pytest.fixture
def glut(
    hook: Hook, ours: list[str], monkeypatch: pytest.MonkeyPatch
) -> tuple[Glut, Any]:
    import OpenGL.platform

    library = Glut()
    monkeypatch.setattr(OpenGL.platform, "PLATFORM", SimpleNamespace(GLUT=library))
    module = SimpleNamespace(INITIALIZED=True)
    for kind in ("Special", "SpecialUp", "Keyboard", "KeyboardUp"):
        register = SimpleNamespace(
            wrappedOperation=functools.partial(library.registered.__setitem__, kind),
            callbackType=Callback,
        )
        setattr(module, f"glut{kind}Func", register)
    hook("GLUT", module)
    return library, module


class Callback:
    """As ctypes': a callable that attributes may be put on."""

    def __init__(self, function: Callable[..., None]) -> None:
        self.function = function

    def __call__(self, *arguments: Any) -> None:
        self.function(*arguments)


def test_glut_gives_the_app_all_keys_but_ours(glut: tuple[Glut, Any], ours: list[str]) -> None:
    library, module = glut
    got: list[Any] = []
    for kind in ("Special", "SpecialUp", "Keyboard", "KeyboardUp"):
        callback = Callback(lambda key, x, y, kind=kind: got.append((kind, key, x, y)))
        getattr(module, f"glut{kind}Func").wrappedOperation(callback)
    send = {kind: library.registered[kind] for kind in library.registered}
    library.modifiers = 1
    send["Special"](5, 2, 3)
    send["SpecialUp"](5, 2, 3)
    library.modifiers = 0
    send["Special"](5, 2, 3)
    send["SpecialUp"](5, 2, 3)
    for key in (b"k", b"x", b"\xff", b"\x1b"):
        send["Keyboard"](key, 0, 0)
        send["KeyboardUp"](key, 0, 0)
    assert ours == ["shift+F5", "K"]
    rest = [(kind, key, 0, 0) for key in (b"x", b"\xff", b"\x1b")
            for kind in ("Keyboard", "KeyboardUp")]  # fmt: skip
    assert got == [("Special", 5, 2, 3), ("SpecialUp", 5, 2, 3), *rest]


def test_glut_windows_without_callbacks_get_ours_once(
    glut: tuple[Glut, Any], ours: list[str]
) -> None:
    library, module = glut
    module.INITIALIZED = False
    toolkits.window_is_there()
    assert library.registered == {}
    module.INITIALIZED = True
    toolkits.window_is_there()
    special = library.registered["Special"]
    toolkits.window_is_there()
    assert library.registered["Special"] is special
    library.registered["Keyboard"](b"k", 0, 0)
    assert ours == ["K"]
    assert library.asked == [1]
    module.glutSpecialFunc.wrappedOperation(None)  # the app wants none any more
    library.modifiers = 1
    library.registered["Special"](5, 0, 0)
    assert ours == ["K", "shift+F5"]


# -- glfw -----------------------------------------------------------------------------------------


def test_glfw_windows_have_a_callback_from_the_start(hook: Hook, ours: list[str]) -> None:
    hooked: dict[int, Any] = {}
    window = ctypes.c_void_p(77)

    def set_key_callback(window: Any, callback: Any) -> None:
        hooked[window.value] = callback

    woken: list[bool] = []
    library = SimpleNamespace(
        glfwCreateWindow=lambda *size: window, glfwSetKeyCallback=set_key_callback,
        glfwPostEmptyEvent=lambda: woken.append(True),
    )  # fmt: skip
    hook("glfw", SimpleNamespace(_glfw=library, _GLFWkeyfun=lambda function: function))
    assert library.glfwCreateWindow(3, 4) is window
    hooked[77](window, 75, 0, 1, 0)
    assert ours == ["K"]
    assert woken == [True]
    got: list[tuple[Any, ...]] = []
    library.glfwSetKeyCallback(window, lambda *key: got.append(key[1:]))
    f5 = 294
    for action, mods in ((1, 1), (2, 1), (0, 1), (1, 0), (2, 0), (0, 0)):
        hooked[77](window, f5, 9, action, mods)
    assert ours == ["K", "shift+F5"]
    assert got == [(f5, 9, 1, 0), (f5, 9, 2, 0), (f5, 9, 0, 0)]
    library.glfwSetKeyCallback(window, None)
    hooked[77](window, f5, 9, 1, 0)
    assert len(got) == 3


# -- pygame ---------------------------------------------------------------------------------------


def test_pygame_gives_the_app_all_events_but_ours(hook: Hook, ours: list[str]) -> None:
    import pygame

    def key(kind: int, code: int, mod: int = 0) -> Any:
        return SimpleNamespace(type=kind, key=code, mod=mod)

    down, up = pygame.KEYDOWN, pygame.KEYUP
    app = [key(down, pygame.K_F5), key(up, pygame.K_F5), SimpleNamespace(type=pygame.QUIT)]
    mine = [key(down, pygame.K_F5, pygame.KMOD_LSHIFT), key(up, pygame.K_F5), key(down, ord("k"))]
    queue: list[Any] = []
    module = SimpleNamespace(
        get=lambda *_, **__: [queue.pop(0) for _ in range(len(queue))],
        poll=lambda: queue.pop(0), wait=lambda timeout=0: queue.pop(0),
        post=queue.append, Event=lambda kind: SimpleNamespace(type=kind),
    )  # fmt: skip
    hook("pygame", module)
    queue += [*mine[:2], *app]
    assert module.get() == app
    assert [event.type for event in queue] == [pygame.VIDEOEXPOSE]
    queue[:] = [mine[2], app[2]]
    assert module.poll() is app[2]
    assert module.wait(timeout=5).type == pygame.VIDEOEXPOSE  # the program draws, as asked
    assert ours == ["shift+F5", "K"]
    keyboard.listen(None)
    queue += mine
    assert module.get() == mine


# -- SDL2 ----------------------------------------------------------------------------------------


def test_sdl_gives_the_app_all_events_but_ours(hook: Hook, ours: list[str]) -> None:
    rig = Sdl2Rig()
    toolkit = hook("SDL2", rig.modules["sdl2.events"])
    rig.take()
    shift = 0x2

    def get(name: str, *arguments: Any) -> list[tuple[str, bool]]:
        """What one call gives the program, by each way to point to an event."""
        rig.got.clear()
        rig.push("F5", True, held=shift)
        rig.push("F5", True, held=shift, again=True)
        rig.push("F5", False)
        rig.push("X", True)
        event = SdlEvent()
        assert getattr(rig.events, name)(ctypes.byref(event), *arguments) == 1
        rig.note(event)
        assert not rig.queue
        return rig.got

    pressed = [("X", True)]
    assert get("SDL_PollEvent") == pressed
    assert get("SDL_WaitEvent") == pressed
    assert get("SDL_WaitEventTimeout", 7) == pressed
    assert ours == ["shift+F5"] * 3
    rig.push("K", True)
    assert rig.events.SDL_PollEvent(ctypes.pointer(SdlEvent())) == 0
    assert ours[3:] == ["K"]
    events, get_event = (SdlEvent * 10)(), 2
    for name, down in (("X", True), ("K", False), ("F5", True)):
        rig.push(name, down)
    rig.got.clear()
    assert rig.events.SDL_PeepEvents(events, 10, get_event, 0, 0xFFFF) == 2
    for event in events[:2]:
        rig.note(event)
    assert rig.got == [("X", True), ("F5", True)]
    toolkit.release(Part.KEYS)
    rig.push("K", True)
    assert rig.events.SDL_PollEvent(ctypes.byref(SdlEvent())) == 1


# -- Qt -------------------------------------------------------------------------------------------


class Kind(enum.Enum):
    """As PyQt6's: enumerators are no integers."""

    SHORTCUT, PRESS, RELEASE, PAINT = 51, 6, 7, 12


class Flags(enum.Flag):
    """Likewise."""

    NONE, SHIFT = 0, 0x02000000


class Key(enum.IntEnum):
    """As PySide's."""

    F5, K = 0x01000034, 0x4B


class Event:
    """Of a key."""

    def __init__(self, kind: Any, key: Any = Key.F5, held: Any = 0, again: bool = False) -> None:
        self.type, self.key, self.modifiers = (lambda: kind), (lambda: key), (lambda: held)
        self.isAutoRepeat = lambda: again
        self.accepted = False

    def accept(self) -> None:
        self.accepted = True


class Application:
    """It has filters."""

    def __init__(self) -> None:
        self.filters: list[Any] = []

    def installEventFilter(self, event_filter: Any) -> None:
        self.filters.append(event_filter)


@pytest.mark.parametrize("binding", ["PyQt5", "PySide2", "PyQt6", "PySide6"])
def test_qt_applications_are_filtered_once_they_are_there(
    binding: str, hook: Hook, ours: list[str]
) -> None:
    apps: list[Application | None] = [None]
    core = SimpleNamespace(
        QObject=object, QCoreApplication=SimpleNamespace(instance=lambda: apps[-1])
    )
    hook(binding, core)
    toolkits.window_is_there()
    for _ in range(2):  # an application may follow another
        apps.append(Application())
        for _ in range(2):
            toolkits.window_is_there()
    assert [len(app.filters) for app in apps if app] == [1, 1]
    assert apps[-1] is not None
    takes = apps[-1].filters[0].eventFilter
    assert not takes(None, Event(Kind.PAINT))
    assert not takes(None, SimpleNamespace(type=lambda: Kind.PRESS))  # no key: nothing is raised
    for kind in (Kind.PRESS, 6):
        assert takes(None, Event(kind, Key.F5, Flags.SHIFT))
        assert takes(None, Event(Kind.RELEASE, Key.F5, again=True))
        assert takes(None, Event(kind, Key.F5, Flags.SHIFT, again=True))
        assert takes(None, Event(Kind.RELEASE, Key.F5))
        assert not takes(None, Event(Kind.RELEASE, Key.F5))
        assert not takes(None, Event(kind, Key.F5, Flags.NONE))
    assert ours == ["shift+F5"] * 2


def test_a_shortcut_of_the_apps_yields_to_a_key_that_the_user_named_alone(ours: list[str]) -> None:
    named, default = Event(51, Key.K), Event(51, Key.F5, 0x02000000)
    assert qt.is_ours(51, named)
    assert named.accepted
    assert not qt.is_ours(51, default)
    assert not default.accepted
    assert ours == []


def test_qt_widgets_that_painted_are_asked_to_paint_again() -> None:
    class Widget:
        asked = 0

        def update(self) -> None:
            self.asked += 1

    class Gone(Widget):
        def update(self) -> None:
            raise RuntimeError("its C++ half was deleted")

    widgets, toolkit = [Widget(), Gone()], qt.Qt("PyQt6")
    for widget in widgets:
        toolkit.drawable(widget)
    toolkit.redraw()
    assert widgets[0].asked == 1
