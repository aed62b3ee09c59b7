"""Both of PyQt5's GL widgets, one of them with a painter's text over the scene."""

import sys

import toolkit_scene
from OpenGL.GL import glDisable
from PyQt5.QtGui import QPainter
from PyQt5.QtOpenGL import QGLWidget
from PyQt5.QtWidgets import QApplication, QHBoxLayout, QOpenGLWidget, QWidget


class Paints:
    def paintGL(self):
        toolkit_scene.angle = 20  # as often as Qt likes
        toolkit_scene.draw(self.width(), self.height())


class Old(Paints, QGLWidget):
    pass


class New(Paints, QOpenGLWidget):
    def paintGL(self):
        painter = QPainter(self)
        painter.beginNativePainting()
        super().paintGL()
        glDisable(0x0B71)
        painter.endNativePainting()
        painter.drawText(20, 30, "a painter's text")
        painter.end()


app = QApplication(sys.argv)
window = QWidget()
window.setLayout(QHBoxLayout())
for widget in (Old(), New()):
    widget.setMinimumSize(300, 200)
    window.layout().addWidget(widget)
window.move(0, 0)
window.show()
sys.exit(app.exec_())
