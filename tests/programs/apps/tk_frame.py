"""A GL frame in a Tk window, beside a button."""

import tkinter

import toolkit_scene
from pyopengltk import OpenGLFrame


class Frame(OpenGLFrame):
    animate = 1

    def initgl(self):
        toolkit_scene.angle = 0  # some redraws come before the window does

    def redraw(self):
        toolkit_scene.draw(self.width, self.height)


root = tkinter.Tk()
root.geometry("+0+0")
tkinter.Button(root, text="Button").pack()
Frame(root, width=300, height=200).pack()
root.mainloop()
