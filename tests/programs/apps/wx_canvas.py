"""A GL canvas of wx's, beside a button."""

import wx
from wx import glcanvas


class Canvas(glcanvas.GLCanvas):
    def __init__(self, parent):
        attributes = [glcanvas.WX_GL_RGBA, glcanvas.WX_GL_DOUBLEBUFFER,
                      glcanvas.WX_GL_DEPTH_SIZE, 24, 0]
        super().__init__(parent, attribList=attributes, size=(300, 200))
        self.context = glcanvas.GLContext(self)
        self.Bind(wx.EVT_PAINT, self.paint)

    def paint(self, event):
        wx.PaintDC(self)
        self.SetCurrent(self.context)
        import toolkit_scene

        toolkit_scene.angle = 20
        toolkit_scene.draw(300, 200)
        self.SwapBuffers()


app = wx.App()
frame = wx.Frame(None, title="wx", pos=(0, 0))
sizer = wx.BoxSizer(wx.VERTICAL)
for part in (wx.Button(frame, label="Button"), Canvas(frame)):
    sizer.Add(part)
frame.SetSizerAndFit(sizer)
frame.Show()
app.MainLoop()
print("the main loop has returned")
