"""PyOpenGL in a window of pyglet's."""

import pyglet
import toolkit_scene

config = pyglet.gl.Config(double_buffer=True, depth_size=24, major_version=2, minor_version=1)
window = pyglet.window.Window(300, 200, config=config)
window.set_location(0, 0)

for _ in range(60):
    window.switch_to()
    window.dispatch_events()
    toolkit_scene.draw(300, 200)
    window.flip()
window.close()
