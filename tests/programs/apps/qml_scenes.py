"""QML with OpenGL: a scene drawn under the items of a window, and (item) one in an item of its own.
``qml_scenes.py BINDING under|item``; it draws again and again."""

import importlib
import os
import sys

os.environ.setdefault("QSG_RHI_BACKEND", "opengl")

import toolkit_scene
from OpenGL.GL import GL_DEPTH_TEST, GL_LIGHTING, glDisable, glUseProgram

BINDING, KIND = sys.argv[1:3]
core, gui, qml, quick = (
    importlib.import_module(f"{BINDING}.{part}") for part in ("QtCore", "QtGui", "QtQml", "QtQuick")
)
old = BINDING.endswith(("5", "2"))
ITEMS = "import QtQuick 2.0\n"
LABEL = """
  Rectangle { x: 10; y: 10; width: 90; height: 24; color: "#80ffffff"
              Text { anchors.centerIn: parent; text: "an item of QML" } }
"""


def scene(width, height):
    glUseProgram(0)  # which Qt leaves in use
    toolkit_scene.angle = 20
    toolkit_scene.draw(width, height)
    glDisable(GL_LIGHTING)
    glDisable(GL_DEPTH_TEST)


class Window(quick.QQuickView):
    """Whose items lie over the scene."""

    def paint(self):
        if not old:
            self.beginExternalCommands()
        scene(round(self.width() * self.devicePixelRatio()),
              round(self.height() * self.devicePixelRatio()))  # fmt: skip
        if old:
            self.resetOpenGLState()
        else:
            self.endExternalCommands()
        self.update()


class Renderer(quick.QQuickFramebufferObject.Renderer):
    def createFramebufferObject(self, size):
        gl = importlib.import_module(f"{BINDING}.{'QtGui' if old else 'QtOpenGL'}")
        form = gl.QOpenGLFramebufferObjectFormat()
        form.setAttachment(gl.QOpenGLFramebufferObject.Attachment.CombinedDepthStencil)
        self.target = gl.QOpenGLFramebufferObject(size, form)
        return self.target

    def render(self):
        size = self.framebufferObject().size()
        scene(size.width(), size.height())
        self.update()


class Item(quick.QQuickFramebufferObject):
    def createRenderer(self):
        self.renderer = Renderer()
        return self.renderer


form = gui.QSurfaceFormat()
form.setDepthBufferSize(24)
gui.QSurfaceFormat.setDefaultFormat(form)
if not old:
    quick.QQuickWindow.setGraphicsApi(quick.QSGRendererInterface.GraphicsApi.OpenGL)
app = gui.QGuiApplication(sys.argv)
view = Window()
direct = core.Qt.ConnectionType.DirectConnection
if KIND == "under":
    if old:
        view.setClearBeforeRendering(False)
        view.beforeRendering.connect(view.paint, direct)
    else:
        view.beforeRenderPassRecording.connect(view.paint, direct)
    text = f"{ITEMS} Item {{ width: 300; height: 200; {LABEL} }}"
else:
    qml.qmlRegisterType(Item, "Ours", 1, 0, "Scene")
    text = f"{ITEMS} import Ours 1.0\n Item {{ width: 300; height: 200; Scene {{ anchors.fill: parent }} {LABEL} }}"  # noqa: E501
component = qml.QQmlComponent(view.engine())
component.setData(text.encode(), core.QUrl())
root = component.create()
assert root is not None, [error.toString() for error in component.errors()]
view.setContent(core.QUrl(), component, root)
view.resize(300, 200)
view.setPosition(0, 0)
view.show()
status = (getattr(app, "exec", None) or app.exec_)()
print("left", flush=True)
del view
sys.exit(status)
