"""Draws when it is exposed, and says which keys it gets."""

import sys
import tkinter

import toolkit_scene

root = tkinter.Tk()
root.geometry("320x240+0+0")


def draw(width=320, height=240):
    toolkit_scene.angle = 20
    toolkit_scene.draw(width, height)


if "togl" in sys.argv:
    root.tk.call("package", "require", "Togl")

    class View(tkinter.Widget):
        def __init__(self, master):
            options = {"width": 320, "height": 240, "double": 1, "depth": 1}
            tkinter.Widget.__init__(self, master, "togl", {}, options)
            self.bind("<Expose>", self.redraw)

        def redraw(self, event):
            self.tk.call(self._w, "makecurrent")
            draw()
            self.tk.call(self._w, "swapbuffers")
else:
    from pyopengltk import OpenGLFrame

    class View(OpenGLFrame):
        def initgl(self):
            pass

        def redraw(self):
            draw(self.width, self.height)


def pressed(event):
    key = event.keysym
    print("key", key if len(key) > 1 and key != "Escape" else event.char, flush=True)
    if key == "Escape":
        root.destroy()


def released(event):
    if event.keysym.startswith("F") and event.keysym != "F8":
        print("released", event.keysym, flush=True)


view = View(root)
view.pack(fill="both", expand=True)
root.bind("<KeyPress>", pressed)
root.bind("<KeyRelease>", released)
for number in range(1, 13):  # goes before what is bound to any key
    root.bind(f"<F{number}>", pressed)
view.focus_force()
root.mainloop()
