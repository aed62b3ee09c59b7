"""Draws when Qt likes, and says which keys it gets."""

import sys

import toolkit_scene
from PyQt5.QtCore import Qt
from PyQt5.QtGui import QKeySequence
from PyQt5.QtWidgets import QApplication, QOpenGLWidget, QShortcut


class View(QOpenGLWidget):
    def paintGL(self):
        toolkit_scene.angle = 20
        toolkit_scene.draw(self.width(), self.height())

    def keyPressEvent(self, event):
        key = event.key() - 0x0100002F
        print("key", f"F{key}" if 0 < key < 13 else event.text(), flush=True)
        if event.key() == Qt.Key_Escape:
            self.close()


app = QApplication(sys.argv)
view = View()
view.setGeometry(0, 0, 320, 240)
if "shortcut" in sys.argv:
    QShortcut(QKeySequence(0x01000038), view, lambda: print("key shortcut", flush=True))
view.show()
view.activateWindow()  # no window manager does
sys.exit(app.exec_())
