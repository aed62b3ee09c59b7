"""The contract of toolkits, on each of them: on stand-ins in the shape of their modules, and on the
modules themselves where they are installed. What is particular to one follows."""

from __future__ import annotations

import functools
import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from glshim import toolkits
from glshim.commands import doctor
from glshim.toolkits import Part, Toolkit, frames
from glshim.toolkits.base import Changes
from glshim.toolkits.qt import Qt
from glshim.toolkits.wx import Wx

from .toolkit_checks import CHECKS
from .toolkits import RIGS, Rig

ROOT = Path(__file__).parents[2]


@pytest.fixture
def current(monkeypatch: pytest.MonkeyPatch) -> None:
    """A context is current, nobody listens, and no frame is being shown."""
    monkeypatch.setattr(frames, "_context_is_current", lambda: True)
    monkeypatch.setattr(frames, "_listeners", ())
    monkeypatch.setattr(frames._here, "drawable", frames.UNKNOWN)
    monkeypatch.setattr(frames, "_showing", set())


@pytest.mark.usefixtures("current")
@pytest.mark.parametrize("check", CHECKS, ids=lambda check: check.__name__)
@pytest.mark.parametrize("name", RIGS)
def test_contract(name: str, check: Callable[[Rig], None], monkeypatch: pytest.MonkeyPatch) -> None:
    rig = RIGS[name]()
    for module, stand_in in rig.modules.items():
        stand_in.__spec__ = None
        monkeypatch.setitem(sys.modules, module, stand_in)
    check(rig)


@pytest.mark.programs
@pytest.mark.parametrize("name", ["glfw", "GLUT", "GLUT, single-buffered", "pygame"])
def test_contract_on_the_toolkit_itself(name: str) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "tests.contract.toolkits_themselves", name],
        env={**os.environ, "PYGAME_HIDE_SUPPORT_PROMPT": "1"},
        cwd=ROOT, capture_output=True, text=True, timeout=120, check=False,
    )  # fmt: skip
    assert (done.returncode, done.stdout.split()) == (0, ["ok"] * len(CHECKS)), done.stderr


def test_every_toolkit_keeps_the_contract() -> None:
    """A new file is under it as soon as it is there."""
    kept = {rig().toolkit.name for rig in RIGS.values()}
    assert {toolkit.name for toolkit in toolkits.known()} == kept
    assert {toolkit.name for toolkit in toolkits.known()} - {"stub"} == {
        toolkit.name for toolkit in toolkits.used()
    }


def test_reading_the_files_imports_no_toolkit() -> None:
    code = (
        "import sys; from glshim import toolkits; names = {t.package for t in toolkits.known()}; "
        "print(*(names & set(sys.modules)), 'numpy' in sys.modules)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=True
    )
    assert done.stdout == "False\n"


def test_a_toolkit_is_one_file() -> None:
    """Nothing outside the toolkits' folder names one."""
    names = {
        Path(module.__file__ or "").stem
        for module in (import_module(type(each).__module__) for each in toolkits.known())
    }
    asking = [f"glshim.toolkits.{name}" for name in sorted(names)]
    found = [
        path for path in (ROOT / "glshim").rglob("*.py")
        if any(f"{name} import" in path.read_text(encoding="utf-8") for name in asking)
    ]  # fmt: skip
    assert found == []


def test_a_new_file_is_found_and_hooked(tmp_path: Path) -> None:
    """The stub under another name, in a copy of glshim, with a package of that name."""
    shutil.copytree(ROOT / "glshim", tmp_path / "glshim", ignore=shutil.ignore_patterns("*.pyc"))
    folder = tmp_path / "glshim" / "toolkits"
    stub = (folder / "stub.py").read_text(encoding="utf-8").replace("example = True", "")
    (folder / "newkit.py").write_text(stub.replace('"stub', '"newkit'), encoding="utf-8")
    package = "def show(window): return 7\ndef next_event(): return None\ndef seconds(): return 9"
    (tmp_path / "newkit.py").write_text(package, encoding="utf-8")
    code = (
        "from glshim.running import startup; startup.arm(); from newkit import show, seconds; "
        "from glshim import toolkits; Part = toolkits.Part; "
        "(kit,) = [kit for kit in toolkits.used() if kit.name == 'newkit']; "
        "print(kit.is_hooked(Part.FRAMES), kit.is_hooked(Part.KEYS), seconds())"
    )
    environ = {**os.environ, "PYTHONPATH": str(tmp_path), "GLSHIM_KEYS": "on", "GLSHIM_STILL": "1"}
    done = subprocess.run(
        [sys.executable, "-S", "-c", code], cwd=tmp_path, env=environ,
        capture_output=True, text=True, timeout=60, check=False,
    )  # fmt: skip
    assert (done.stdout, done.stderr) == ("True True 0.0\n", "")


@pytest.mark.parametrize("toolkit", toolkits.used(), ids=lambda toolkit: toolkit.name)
def test_doctor_and_its_page_say_what_it_does_and_lacks(
    toolkit: Toolkit, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(toolkits, "used", lambda: (toolkit,))
    monkeypatch.setattr(doctor, "find_spec", lambda name: name == toolkit.package)
    doctor._toolkits()
    said = capsys.readouterr().out
    for words in (toolkit.name, *toolkit.places(Part.FRAMES), *toolkit.lacks.values()):
        assert words in said
    page = (ROOT / "docs" / "guide" / "works_with.md").read_text(encoding="utf-8").replace("`", "")
    for place in toolkit.places(Part.FRAMES):
        assert place.partition(" (")[0] in page


@pytest.mark.usefixtures("current")
def test_a_hook_that_fails_leaves_the_toolkit_plain(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    rig = RIGS["glfw"]()
    module = rig.modules["glfw"]
    del module._glfw.glfwSetKeyCallback
    found = dict(vars(module._glfw))
    module.__spec__ = None
    monkeypatch.setitem(sys.modules, "glfw", module)
    rig.toolkit.watch(Part.KEYS)
    assert vars(module._glfw) == found
    assert not rig.toolkit.is_hooked(Part.KEYS)
    assert "glfw: glfw.set_key_callback cannot be hooked (keys)" in capsys.readouterr().err


# -- in particular ---------------------------------------------------------------------------------


@pytest.fixture
def log(current: None) -> list[str]:
    """What happened, with a context current and a listener that says where it was called."""
    happened: list[str] = []
    frames.listen(
        frames.Stage.DRAW,
        before=lambda: happened.append(
            f"{frames.drawable_size()} in {frames.drawable_framebuffer()}"),
    )
    return happened


class Widget:
    """As Qt's: C++ calls the app's paintGL through `show`."""

    def devicePixelRatio(self) -> float:
        return 2.0

    def width(self) -> int:
        return 30

    def height(self) -> int:
        return 20

    def defaultFramebufferObject(self) -> int:
        return 7

    def paintGL(self) -> None:
        raise AssertionError("the app's own is called")

    def show(self) -> Any:
        return self.paintGL()


def module_with(base: type) -> Any:
    return SimpleNamespace(QOpenGLWidget=base)


def fresh_base() -> Any:
    return type("QOpenGLWidget", (Widget,), {})


@pytest.mark.parametrize("late", [False, True])
def test_a_qt_frame_ends_after_painting(log: list[str], late: bool) -> None:
    base = fresh_base()
    hook = functools.partial(Qt("PyQt6").hook_painting, ("QOpenGLWidget", "NotThere"))
    if not late:
        hook(module_with(base), Changes())

    class App(base):  # type: ignore[misc]
        def paintGL(self) -> str:
            log.append("painted")
            return "result"

    if late:
        hook(module_with(base), Changes())
    assert App().show() == "result"
    assert App.paintGL.__name__ == "paintGL"
    assert log == ["painted", "(60, 40) in 7"]


def test_painting_through_super_is_one_frame(log: list[str]) -> None:
    base = fresh_base()
    Qt("PyQt6").hook_painting(("QOpenGLWidget",), module_with(base), Changes())

    class Scene(base):  # type: ignore[misc]
        def paintGL(self) -> None:
            log.append("scene")

    class App(Scene):
        def paintGL(self) -> None:
            super().paintGL()
            log.append("more")

    App().show()
    assert log == ["scene", "more", "(60, 40) in 7"]


def test_painting_that_a_mixin_does(log: list[str]) -> None:
    base = fresh_base()
    Qt("PyQt6").hook_painting(("QOpenGLWidget",), module_with(base), Changes())

    class Paints:
        def paintGL(self) -> None:
            log.append("painted")

    class App(Paints, base):  # type: ignore[misc]
        pass

    App().show()
    assert log == ["painted", "(60, 40) in 7"]
    Paints().paintGL()  # the mixin itself stays what it was
    assert log[2:] == ["painted"]


def test_what_painting_raises_is_the_apps(log: list[str]) -> None:
    base = fresh_base()
    Qt("PyQt6").hook_painting(("QOpenGLWidget",), module_with(base), Changes())

    class App(base):  # type: ignore[misc]
        fails = True

        def paintGL(self) -> None:
            if self.fails:
                raise ValueError("the app's own")

    app = App()
    with pytest.raises(ValueError, match="the app's own"):
        app.show()
    assert log == []
    app.fails = False
    app.show()
    assert log == ["(60, 40) in 7"]


def test_a_qt_program_that_swaps_by_itself(log: list[str]) -> None:
    swapped = type("QGLWidget", (Widget,), {"swapBuffers": lambda self: log.append("swapped")})
    module = SimpleNamespace(QGLWidget=swapped)
    qt = Qt("PyQt5")
    qt.hook_swaps("QGLWidget", module, Changes())
    qt.hook_painting(("QGLWidget",), module, Changes())

    class App(swapped):  # type: ignore[misc, valid-type]
        def paintGL(self) -> None:
            self.swapBuffers()

    App().show()
    assert log == ["(60, 40) in 7", "swapped"]


def test_a_method_is_not_asked_for_its_docstring(log: list[str]) -> None:
    class Method:  # as PySide's: its docstring cannot be made yet
        __name__ = __qualname__ = "swapBuffers"

        @property
        def __doc__(self) -> str:  # type: ignore[override]
            log.append("asked")
            return ""

        def __call__(self, context: Any, surface: Any) -> None:
            log.append("swapped")

    context = type("QOpenGLContext", (), {"swapBuffers": Method()})
    Qt("PySide6").hook_swaps(
        "QOpenGLContext", SimpleNamespace(QOpenGLContext=context), Changes())
    context().swapBuffers(Widget())
    assert log == ["(60, 40) in 7", "swapped"]


@pytest.mark.parametrize("depth", [0, 1])
def test_a_qt_program_leaves_by_its_main_loop(monkeypatch: pytest.MonkeyPatch, depth: int) -> None:
    log: list[Any] = []
    app = SimpleNamespace(topLevelWindows=lambda: ["window"])
    core = SimpleNamespace(
        Qt=SimpleNamespace(QueuedConnection=2),
        QMetaObject=SimpleNamespace(invokeMethod=lambda *call: log.append(call)),
        QCoreApplication=SimpleNamespace(instance=lambda: app),
        QThread=SimpleNamespace(currentThread=lambda: SimpleNamespace(loopLevel=lambda: depth)))
    monkeypatch.setitem(sys.modules, "PySide6.QtCore", core)
    assert Qt("PySide6").drawable(Widget()).leave() is bool(depth)
    assert log == [("window", "hide", 2), (app, "quit", 2)][: 2 * depth]


@pytest.mark.parametrize("runs", [False, True])
def test_a_wx_program_leaves_by_its_main_loop(monkeypatch: pytest.MonkeyPatch, runs: bool) -> None:
    log: list[str] = []
    app = SimpleNamespace(
        IsMainLoopRunning=lambda: runs, ExitMainLoop=lambda: log.append("main loop left"))
    monkeypatch.setitem(sys.modules, "wx", SimpleNamespace(GetApp=lambda: app))
    assert Wx().drawable(Widget()).leave() is runs
    assert log == ["main loop left"] * runs


@pytest.mark.parametrize("runs", [False, True])
def test_a_togl_program_leaves_by_its_main_loop(togl: Any, runs: bool) -> None:
    module = togl.modules["tkinter"]
    left: list[bool] = []

    def mainloop(widget: Any) -> bool:
        return bool(togl.toolkit.drawable(widget).leave())

    module.Misc.mainloop = module.mainloop = mainloop if runs else lambda widget: None
    module.BaseWidget.quit = lambda widget: left.append(True)
    assert mainloop(togl.window) is runs
    assert left == [True] * runs


def test_wx(log: list[str]) -> None:
    def swap(canvas: Any) -> bool:
        log.append("swapped")
        return True

    canvas = type("GLCanvas", (), {
        "SwapBuffers": swap, "GetClientSize": lambda self: (30, 20),
        "GetContentScaleFactor": lambda self: 2.0})
    Wx().hook_swaps(SimpleNamespace(GLCanvas=canvas), Changes())
    assert canvas().SwapBuffers() is True
    assert log == ["(60, 40) in 0", "swapped"]


# -- Tk --------------------------------------------------------------------------------------------


@pytest.fixture
def togl(log: list[str], monkeypatch: pytest.MonkeyPatch) -> Any:
    """A rig whose frame ends are noted."""
    rig = RIGS["Tk, Togl"]()
    for module, stand_in in rig.modules.items():
        stand_in.__spec__ = None
        monkeypatch.setitem(sys.modules, module, stand_in)
    rig.toolkit.watch(Part.FRAMES)
    rig.take()
    rig.open()
    rig.log = log
    return rig


def test_togl_takes_the_beginning_of_a_word_for_the_word(togl: Any, log: list[str]) -> None:
    for command in ("swap", "swapbuffers", "makecurrent", "cget", ""):
        togl.tk.traced(command, lambda command=command: log.append(command))
    frame = "(60, 40) in 0"
    assert log == [frame, "swap", frame, "swapbuffers", "makecurrent", "cget", ""]


def test_a_togl_that_fails_to_swap_has_shown_no_frame(togl: Any) -> None:
    def fail() -> None:
        raise RuntimeError("Togl's own")

    before = frames.presented()
    with pytest.raises(RuntimeError, match="Togl's own"):
        togl.tk.traced("swapbuffers", fail)
    assert frames.presented() == before
    togl.present()
    assert frames.presented() == before + 1


def test_a_togl_is_shown_in_its_own_context(
    togl: Any, log: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Two are drawn, then both are shown."""
    current = [0]
    platform = SimpleNamespace(GetCurrentContext=lambda: current[0])
    monkeypatch.setitem(sys.modules, "OpenGL.platform", SimpleNamespace(PLATFORM=platform))
    first, second = togl.window, togl.another()
    for number, widget in enumerate((first, second), 1):
        togl.tk.current[str(widget)] = lambda number=number: current.__setitem__(0, number)
        togl.tk.call(str(widget), "makecurrent")
    frames.listen(frames.Stage.DRAW, before=lambda: log.append(f"context {current[0]}"))
    for widget in (first, second):
        togl.tk.call(str(widget), "swapbuffers")
        assert current == [2]
    assert [line for line in log if "context" in line] == ["context 1", "context 2"]


def test_what_shows_a_frame_by_another_toolkit_shows_one(log: list[str]) -> None:
    frames.present(lambda: frames.present(lambda: log.append("shown")))
    assert log == ["None in 0", "shown"]
