"""One of Qt's kinds of OpenGL windows, in any binding: ``qt_kinds.py BINDING widget|window|old
[samples]``. It paints once and rests."""

import atexit
import importlib
import sys

import toolkit_scene

BINDING, KIND, *more = sys.argv[1:]
core, gui, widgets = (
    importlib.import_module(f"{BINDING}.{part}") for part in ("QtCore", "QtGui", "QtWidgets")
)


def named(name, *parts):
    for part in parts:
        try:
            return getattr(importlib.import_module(f"{BINDING}.{part}"), name)
        except (ImportError, AttributeError):
            continue
    raise ImportError(name)


base = {
    "widget": lambda: named("QOpenGLWidget", "QtOpenGLWidgets", "QtWidgets"),
    "window": lambda: named("QOpenGLWindow", "QtOpenGL", "QtGui"),
    "old": lambda: named("QGLWidget", "QtOpenGL"),
}[KIND]()
form = gui.QSurfaceFormat()
form.setDepthBufferSize(24)
if "samples" in more:
    form.setSamples(4)
gui.QSurfaceFormat.setDefaultFormat(form)
core.QCoreApplication.setAttribute(core.Qt.ApplicationAttribute.AA_ShareOpenGLContexts)


class View(base):
    painted = 0

    def paintGL(self):
        View.painted += 1
        ratio = self.devicePixelRatio()
        toolkit_scene.draw(round(self.width() * ratio), round(self.height() * ratio))


app = widgets.QApplication(sys.argv)
atexit.register(print, "exit functions")
view = View()
view.resize(300, 200)
view.show()
try:
    status = (getattr(app, "exec", None) or app.exec_)()
finally:
    print("painted", View.painted > 0)
sys.exit(status)
