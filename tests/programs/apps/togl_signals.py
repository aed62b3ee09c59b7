"""Signals come while Togl shows pictures; what their handler raises leaves the call that shows."""

import signal
import time
import tkinter

import toolkit_scene

ROUNDS = 40


class Rung(Exception):
    pass


def ring(number, frame):
    raise Rung


signal.signal(signal.SIGALRM, ring)
root = tkinter.Tk()
root.geometry("+0+0")
root.tk.call("package", "require", "Togl")
view = tkinter.Widget(root, "togl", {}, {"width": 300, "height": 200, "double": 1, "depth": 1})
view.pack()
root.update()
heard = 0
for turn in range(ROUNDS):
    view.tk.call(str(view), "makecurrent")
    toolkit_scene.draw(300, 200)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.0002 + turn * 0.0003)
        view.tk.call(str(view), "swapbuffers")
        time.sleep(0.05)
    except Rung:
        heard += 1
print("heard", heard, "of", ROUNDS, flush=True)
root.after(20, root.quit)
root.mainloop()
print("the main loop has returned", flush=True)
