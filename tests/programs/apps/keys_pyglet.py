"""Draws when it is asked to, and says which keys it gets."""

import pyglet
import toolkit_scene
from pyglet.window import key

config = pyglet.gl.Config(double_buffer=True, depth_size=24, major_version=2, minor_version=1)


class Window(pyglet.window.Window):
    def on_draw(self):
        toolkit_scene.angle = 20
        toolkit_scene.draw(320, 240)
        self.invalid = False

    def on_key_press(self, symbol, modifiers):
        name = key.symbol_string(symbol)
        print("key", name if len(name) > 1 and name != "ESCAPE" else name.lower(), flush=True)
        if symbol == key.ESCAPE:
            self.close()

    def on_key_release(self, symbol, modifiers):
        name = key.symbol_string(symbol)
        if name.startswith("F") and name != "F8":
            print("released", name, flush=True)


window = Window(320, 240, config=config)
window.set_location(0, 0)
pyglet.app.run()
