"""A hand at the virtual screen's keyboard and mouse, through the X test extension."""

import ctypes
import ctypes.util
import time

ESCAPE, MINUS, PLUS = 0xFF1B, 0x2D, 0x2B  # X keysyms
WHEEL_UP, WHEEL_DOWN = 4, 5  # X buttons


class Hand:
    """Raises OSError where the extension's library is not installed."""

    def __init__(self, display: str) -> None:
        self.x, self.test = ctypes.CDLL("libX11.so.6"), ctypes.CDLL("libXtst.so.6")
        self.x.XOpenDisplay.restype = ctypes.c_void_p
        self.x.XDefaultRootWindow.restype = ctypes.c_ulong
        self.display = ctypes.c_void_p(self.x.XOpenDisplay(display.encode()))

    def windows(self) -> int:
        """How many windows lie on the screen."""
        root = ctypes.c_ulong(self.x.XDefaultRootWindow(self.display))
        parent, children = ctypes.c_ulong(), ctypes.c_void_p()
        count = ctypes.c_uint()
        self.x.XQueryTree(self.display, root, ctypes.byref(root), ctypes.byref(parent),
                          ctypes.byref(children), ctypes.byref(count))
        if children:
            self.x.XFree(children)
        return count.value

    def let_go(self) -> None:
        """Keys go to the window under the pointer: without a window manager nobody takes them back
        from a window that is gone."""
        self.x.XSetInputFocus(self.display, ctypes.c_ulong(1), 1, ctypes.c_ulong(0))
        self.settle()

    def move(self, x: int, y: int) -> None:
        self.test.XTestFakeMotionEvent(self.display, -1, x, y, 0)
        self.settle()

    def press(self, keysym: int) -> None:
        code = self.x.XKeysymToKeycode(self.display, ctypes.c_ulong(keysym))
        for down in (1, 0):
            self.test.XTestFakeKeyEvent(self.display, code, down, 0)
        self.settle()

    def hold(self, keysym: int, down: bool) -> None:
        """Put a modifier down, or let it go."""
        code = self.x.XKeysymToKeycode(self.display, ctypes.c_ulong(keysym))
        self.test.XTestFakeKeyEvent(self.display, code, down, 0)
        self.settle()

    def click(self, button: int) -> None:
        for down in (1, 0):
            self.test.XTestFakeButtonEvent(self.display, button, down, 0)
        self.settle()

    def drag(self, start: tuple[int, int], end: tuple[int, int]) -> None:
        self.move(*start)
        self.test.XTestFakeButtonEvent(self.display, 1, 1, 0)
        self.settle()
        self.move(*end)
        self.test.XTestFakeButtonEvent(self.display, 1, 0, 0)
        self.settle()

    def settle(self) -> None:
        self.x.XSync(self.display, 0)
        time.sleep(0.05)
