"""Draws all the time, and says which keys it gets."""

import sys
import time

import glfw
from glfw import set_key_callback, swap_buffers


def on_key(window, key, scancode, action, mods):
    if action == glfw.PRESS:
        print("key", f"F{key - 289}" if 289 < key < 302 else chr(key % 128).lower(), flush=True)
        if key == glfw.KEY_ESCAPE:
            glfw.set_window_should_close(window, True)


glfw.init()
window = glfw.create_window(320, 240, "keys", None, None)
if "deaf" in sys.argv:
    end = time.monotonic() + 30
else:
    set_key_callback(window, on_key)
glfw.make_context_current(window)

import toolkit_scene  # noqa: E402

while not glfw.window_should_close(window):
    toolkit_scene.angle = 20
    toolkit_scene.draw(320, 240)
    swap_buffers(window)
    glfw.poll_events()
    if "deaf" in sys.argv and time.monotonic() > end:
        break
    time.sleep(0.01)
glfw.terminate()
