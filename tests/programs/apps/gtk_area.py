"""A GLArea of GTK: ``gtk_area.py 3|4``. It paints once and rests, and says which keys it gets."""

import os
import sys

os.environ.setdefault("GDK_GL", "legacy")  # GTK 3: a context with the fixed function
os.environ.setdefault("GDK_DEBUG", "gl-legacy")  # GTK 4

import gi

gi.require_version("Gtk", f"{sys.argv[1]}.0")
import toolkit_scene  # noqa: E402
from gi.repository import Gtk  # noqa: E402


def render(area, context):
    scale = area.get_scale_factor()
    toolkit_scene.draw(area.get_allocated_width() * scale, area.get_allocated_height() * scale)
    return True


def say_key(value):
    print("key", value, flush=True)


def activate(app):
    window = Gtk.ApplicationWindow(application=app)
    window.set_default_size(300, 200)
    area = Gtk.GLArea()
    area.set_has_depth_buffer(True)
    area.connect("render", render)
    if hasattr(window, "add"):
        window.connect("key-press-event", lambda _, event: say_key(event.keyval))
        window.add(area)
        window.show_all()
    else:
        keys = Gtk.EventControllerKey()
        keys.connect("key-pressed", lambda _, value, code, state: say_key(value))
        window.add_controller(keys)
        window.set_child(area)
    window.present()


app = Gtk.Application()
app.connect("activate", activate)
try:
    app.run(None)
finally:
    print("left", flush=True)
