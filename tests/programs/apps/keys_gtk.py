"""Draws when GTK likes, and says which keys it gets: ``keys_gtk.py 3|4``."""

import os
import sys

os.environ |= {"GDK_GL": "legacy", "GDK_DEBUG": "gl-legacy"}  # contexts with the fixed function

import gi

for name in ("Gdk", "Gtk"):
    gi.require_version(name, f"{sys.argv[1]}.0")
import toolkit_scene  # noqa: E402
from gi.repository import Gdk, Gtk  # noqa: E402


class Area(Gtk.GLArea):
    def do_render(self, context):
        toolkit_scene.angle = 20
        toolkit_scene.draw(self.get_allocated_width(), self.get_allocated_height())
        print("painted", flush=True)
        return True


def on_key(app, value):
    print("key", Gdk.keyval_name(value), flush=True)
    if value == Gdk.KEY_Escape:
        app.quit()


def activate(app):
    window = Gtk.ApplicationWindow(application=app)
    window.set_default_size(320, 240)
    area = Area()
    area.set_has_depth_buffer(True)
    if hasattr(window, "add"):
        window.connect("key-press-event", lambda _, event: on_key(app, event.keyval))
        window.add(area)
        window.show_all()
    else:
        keys = Gtk.EventControllerKey()
        keys.connect("key-pressed", lambda _, value, code, state: on_key(app, value))
        window.add_controller(keys)
        window.set_child(area)
    window.present()


app = Gtk.Application()
app.connect("activate", activate)
sys.exit(app.run(None))
