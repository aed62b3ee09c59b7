"""What the driver says of its version, and what is read from a frame in contexts of OpenGL ES."""

from __future__ import annotations

from contextlib import ExitStack
from typing import Any

import pytest

from glshim.driver import context
from glshim.outputs.gl.frame import grab
from glshim.spec.constants import GL_DRAW_FRAMEBUFFER, GL_READ_FRAMEBUFFER, GL_RED_SCALE


@pytest.mark.parametrize(
    ("told", "desktop", "any_api"),
    [
        ("4.5 (Compatibility Profile) Mesa 22.3.6", (4, 5), (4, 5)),
        ("2.1 Mesa 22.3.6", (2, 1), (2, 1)),
        ("OpenGL ES 3.2 Mesa 22.3.6", None, (3, 2)),
        ("OpenGL ES-CM 1.1 Mesa 22.3.6", None, (1, 1)),
        ("", None, (1, 1)),
    ],
)
def test_versions(
    monkeypatch: pytest.MonkeyPatch, told: str, desktop: Any, any_api: tuple[int, int]
) -> None:
    monkeypatch.setattr(context, "version_text", lambda: told)
    assert context.version() == desktop
    assert context.number_of_any_api() == any_api


def test_a_frame_of_opengl_es_is_read_as_one_of_opengl(monkeypatch: pytest.MonkeyPatch) -> None:
    """From the framebuffer that is presented, with plain pixel transfer."""
    called: list[tuple[Any, ...]] = []

    class Recorder:
        def __getattr__(self, name: str) -> Any:
            return lambda *arguments: called.append((name, *arguments))

    monkeypatch.setattr(context, "version_text", lambda: "OpenGL ES 3.2 Mesa 22.3.6")
    monkeypatch.setattr(grab, "gl", Recorder())
    monkeypatch.setattr(grab, "integer", lambda name: 0)
    monkeypatch.setattr(grab, "real", lambda name: 0.5)
    with ExitStack() as undo:
        grab._pack_plainly(undo)
        grab._read_framebuffer(7, 0, (4, 3), None, undo)
    for target in (GL_READ_FRAMEBUFFER, GL_DRAW_FRAMEBUFFER):
        assert ("glBindFramebuffer", target, 7) in called
    assert ("glPixelTransferf", GL_RED_SCALE, 1.0) in called
