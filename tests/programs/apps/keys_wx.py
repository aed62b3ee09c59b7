"""Draws when wx likes, and says which keys it gets."""

import wx
from wx import glcanvas


class Canvas(glcanvas.GLCanvas):
    def __init__(self, parent):
        attributes = [glcanvas.WX_GL_RGBA, glcanvas.WX_GL_DOUBLEBUFFER,
                      glcanvas.WX_GL_DEPTH_SIZE, 24, 0]
        super().__init__(parent, attribList=attributes, size=(320, 240))
        self.context = glcanvas.GLContext(self)
        self.Bind(wx.EVT_PAINT, self.paint)
        self.Bind(wx.EVT_KEY_DOWN, self.pressed)
        self.Bind(wx.EVT_KEY_UP, self.released)

    def paint(self, event):
        wx.PaintDC(self)
        self.SetCurrent(self.context)
        import toolkit_scene

        toolkit_scene.angle = 20
        toolkit_scene.draw(320, 240)
        self.SwapBuffers()

    def pressed(self, event):
        code = event.GetKeyCode() - wx.WXK_F1 + 1
        name = f"F{code}" if 0 < code < 13 else chr(event.GetKeyCode()).lower()
        if event.GetKeyCode() != wx.WXK_SHIFT:
            print("key", name, flush=True)
        if event.GetKeyCode() == wx.WXK_ESCAPE:
            self.GetParent().Close()

    def released(self, event):
        code = event.GetKeyCode() - wx.WXK_F1 + 1
        if 0 < code < 13 and code != 8:
            print(f"released F{code}", flush=True)


app = wx.App()
frame = wx.Frame(None, title="keys", pos=(0, 0))
canvas = Canvas(frame)
frame.SetClientSize((320, 240))
frame.Show()
canvas.SetFocus()
app.MainLoop()
