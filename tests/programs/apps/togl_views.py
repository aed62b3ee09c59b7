"""Two Togl widgets of the program's own, both drawn before both are shown."""

import tkinter

import toolkit_scene


class Togl(tkinter.Widget):
    def __init__(self, master, **options):
        tkinter.Widget.__init__(self, master, "togl", {}, options)

    def call(self, what):
        self.tk.call(self._w, what)


def draw():
    for turn, view in enumerate(views):
        view.call("makecurrent")
        toolkit_scene.angle = 40 * turn
        toolkit_scene.draw(300, 200)
    for view in views:
        view.call("swapbuffers")
    root.after(20, draw)


root = tkinter.Tk()
root.geometry("+0+0")
root.tk.call("package", "require", "Togl")
views = [Togl(root, width=300, height=200, double=1, depth=1, ident=name) for name in "ab"]
for view in views:
    view.pack(side="left")
root.update()
draw()
root.mainloop()
print("the main loop has returned", flush=True)
