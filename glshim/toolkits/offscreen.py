"""Programs without a window: they read their picture back or have it finished; nobody shows it.

glFlush and glFinish end a frame in a context whose only buffer is the one that is drawn to. A
picture that is read back is a frame, too, where no toolkit shows any: it counts as soon as another
one is begun. What is read for picking is none, and of one frame there may be several readbacks.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any, ClassVar

from glshim.bindings.pyopengl.pictures import stand_around
from glshim.bindings.pyopengl.raw import Call
from glshim.driver.ask import integer, size_of
from glshim.driver.context import has_framebuffers
from glshim.spec.constants import (
    GL_COLOR_BUFFER_BIT,
    GL_DOUBLEBUFFER,
    GL_DRAW_BUFFER,
    GL_DRAW_FRAMEBUFFER_BINDING,
    GL_READ_BUFFER,
    GL_READ_FRAMEBUFFER_BINDING,
)
from glshim.spec.pixels import COLOURLESS, IMAGE_READS, PICK_AREA, TextureImage
from glshim.spec.roles import Role, role_of
from glshim.toolkits import frames
from glshim.toolkits.base import Changes, Hook, Lacks, Part, Toolkit
from glshim.toolkits.frames import Drawable, Size

_Args = tuple[Any, ...]
_NOTHING = Drawable(lambda: (0, 0), is_shown=False)
"""Of a frame that is read back without colours."""


class Offscreen(Toolkit):
    """Calls of OpenGL itself."""

    name, package, distribution = "no window", "OpenGL", "PyOpenGL"
    tested = "EGL without a surface and with pbuffers, OSMesa, hidden windows; Mesa 22.3"
    displayless: ClassVar[Mapping[str, str] | None] = {}
    lacks: ClassVar[Lacks] = {
        Part.SIZE: "what is read back, or the viewport, counts as the picture",
        Part.KEYS: "live control receives no keys",
        Part.REDRAW: "programs that draw on demand show a new style only with their next frame",
        Part.CLOCK: "only Python's own clocks are held still",
    }

    def __init__(self, *arguments: Any) -> None:
        super().__init__(*arguments)
        self._fresh = True
        """The picture was cleared since a frame ended, or is the first."""
        self._cleared = False
        self._known: set[Any] = set()
        """What was asked for of this frame: once more, and it is the next one."""
        self._seen = False
        """One of its readbacks was of colours."""

    def hooks(self) -> Iterable[Hook]:
        places = "glFlush, glFinish, glReadPixels, glGetTexImage"
        yield Hook(Part.FRAMES, "OpenGL.error", self.hook_pictures, places)

    def hook_pictures(self, module: Any, changes: Changes) -> None:
        stand_around(self.around)
        changes.add(lambda: stand_around(None))

    # -- in place of a call, outside primitives and lists ------------------------------------------

    def around(self, name: str, args: _Args, call: Call) -> Any:
        """Make it. May raise `SystemExit`, see `frames.end_program`."""
        if not frames.listening():
            return call(*args)
        role = role_of(name)
        if role is Role.CLEAR or role is Role.CLEAR_BUFFER:
            if role is Role.CLEAR_BUFFER or _numbers(args, 0)[0] & GL_COLOR_BUFFER_BIT:
                self._fresh = self._cleared = True
                frames.end_read()
            return call(*args)
        if role is Role.FLUSH and not args and _is_single_buffered():
            if frames.shown_by_a_toolkit() or frames.window_is_double_buffered() is False:
                return frames.present(call)
            frames.finish_drawing()
            call()
            self._read((name,), _framebuffer(GL_DRAW_FRAMEBUFFER_BINDING, None))
            return None
        result = call(*args)
        if not frames.shown_by_a_toolkit():
            self._look(role, name, args)
        return result

    def _look(self, role: Role, name: str, args: _Args) -> None:
        """A picture may have been read, or finished in a framebuffer object."""
        if role is Role.FLUSH:
            if _draws_into_an_object():
                self._read((name,), _framebuffer(GL_DRAW_FRAMEBUFFER_BINDING, None))
        elif role is Role.READ_PIXELS:
            x, y, width, height, format_ = _numbers(args, *range(5))
            if width * height > PICK_AREA:
                size = (width, height) if not (x or y) else None
                read = _framebuffer(GL_READ_FRAMEBUFFER_BINDING, size)
                what = (name, x, y, width, height, format_)
                self._read(what, None if format_ in COLOURLESS else read)
        elif name in IMAGE_READS and self._cleared:  # one that was loaded is no picture
            by_name, format_at = IMAGE_READS[name]
            texture, level, format_ = _numbers(args, 0, 1, format_at)
            image = TextureImage(*((texture, 0) if by_name else (0, texture)), level)
            size = size_of(image)
            if size is not None and size[0] * size[1] > PICK_AREA:
                drawable = Drawable(lambda: size, texture=image, is_shown=False)
                asked = (name, texture, level, format_)
                self._read(asked, None if format_ in COLOURLESS else drawable)

    def _read(self, what: _Args, picture: Drawable | None) -> None:
        """None: it shows no colours."""
        if self._is_new(what):
            frames.end_read()
            self._seen = False
        if not self._seen:
            self._seen = picture is not None
            frames.read_back(picture or _NOTHING)

    def _is_new(self, what: Any) -> bool:
        """Whether it is the first that is asked for of a frame."""
        new = self._fresh or what in self._known
        if new:
            self._fresh = self._cleared = False
            self._known.clear()
        self._known.add(what)
        return new


def _numbers(args: _Args, *positions: int) -> list[int]:
    """Integers among arguments; 0 where there is none."""
    from glshim.driver.arguments import number  # and numpy: late, for who only asks

    return [number(args, each) for each in positions]


def _is_single_buffered() -> bool:
    """Whether what is drawn to is what a window of one buffer shows, or is all there is."""
    double = frames.window_is_double_buffered()
    if double is None:
        return not (integer(GL_DOUBLEBUFFER) or _draws_into_an_object())
    return not double


def _framebuffer(binding: int, size: Size | None) -> Drawable:
    """The framebuffer that is bound there, and the buffer of it that the app reads or draws."""
    framebuffer = integer(binding) if has_framebuffers() else 0
    drawn = binding == GL_DRAW_FRAMEBUFFER_BINDING
    buffer = integer(GL_DRAW_BUFFER if drawn else GL_READ_BUFFER)
    return Drawable(
        lambda: size, framebuffer=lambda: framebuffer, buffer=buffer, is_shown=False
    )


def _draws_into_an_object() -> bool:
    return has_framebuffers() and integer(GL_DRAW_FRAMEBUFFER_BINDING) != 0


TOOLKITS = (Offscreen(),)
