"""PyOpenGL's own Tk widget, beside a button."""

from tkinter import Button, Frame

import toolkit_scene
from OpenGL.Tk import Opengl


def redraw(widget):
    toolkit_scene.angle = 20
    toolkit_scene.draw(widget.winfo_width(), widget.winfo_height())


def again():
    widget.tkRedraw()
    widget.after(20, again)


frame = Frame()
frame.master.geometry("+0+0")
Button(frame, text="Button").pack()
widget = Opengl(frame, width=300, height=200, double=1, depth=1)
widget.redraw = redraw
widget.pack()
frame.pack()
again()
frame.mainloop()
