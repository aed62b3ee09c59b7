"""wxPython's GLCanvas."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

from glshim.toolkits.wx import Wx

from .rig import SIZE, Rig

CHAR_HOOK, KEY_DOWN, KEY_UP, PAINT = 1, 2, 3, 4
F1 = 340


class KeyEvent:
    """Of one of wx's kinds."""

    def __init__(self, kind: int, name: str, held: int = 0) -> None:
        self.kind, self.name, self.held = kind, name, held

    def GetEventType(self) -> int:
        return self.kind

    def GetKeyCode(self) -> int:
        return F1 + int(self.name[1:]) - 1 if len(self.name) > 1 else ord(self.name)

    def GetModifiers(self) -> int:
        return self.held

    def IsAutoRepeat(self) -> bool:
        """As wx 3.2 on GTK says of a second press, whatever came between."""
        return True


class WxRig(Rig):
    takes_early = True

    def __init__(self) -> None:
        super().__init__(Wx())
        self.asked = 0
        self.filters: list[Any] = []
        rig = self

        class GLCanvas:
            def SwapBuffers(self) -> int:
                return rig.shown()

            def GetClientSize(self) -> tuple[int, int]:
                return SIZE[0] // 2, SIZE[1] // 2

            def GetContentScaleFactor(self) -> float:
                return 2.0

            def Refresh(self, erase: bool) -> None:
                rig.asked += 1

        self.modules = {
            "wx.glcanvas": SimpleNamespace(GLCanvas=GLCanvas),
            "wx": SimpleNamespace(
                wxEVT_CHAR_HOOK=CHAR_HOOK, wxEVT_KEY_DOWN=KEY_DOWN, wxEVT_KEY_UP=KEY_UP,
                EventFilter=object, EvtHandler=SimpleNamespace(
                    AddFilter=self.filters.append, RemoveFilter=self.filters.remove)),
        }  # fmt: skip

    def take(self) -> None:
        self.kind = self.modules["wx.glcanvas"].GLCanvas

    def open(self) -> None:
        self.window = self.kind()

    def present(self) -> Any:
        return self.window.SwapBuffers()

    def passes(self, event: KeyEvent) -> bool:
        """Whether the filters leave an event to the program."""
        return all(each.FilterEvent(event) == -1 for each in self.filters)

    def key(self, name: str, down: bool) -> None:
        kinds = (CHAR_HOOK, KEY_DOWN) if down else (KEY_UP,)
        if all(self.passes(KeyEvent(kind, name)) for kind in kinds):
            self.got.append((name, down))

    def redraws(self) -> int:
        return self.asked


RIGS: dict[str, Callable[[], Rig]] = {"wx": WxRig}
