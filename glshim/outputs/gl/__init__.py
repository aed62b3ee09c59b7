"""The OpenGL picture: lines and passes over the app's own frame.

`device` holds GL objects and state, `frame` what is done with the app's own frame, `lines` and
`passes` draw what stylers give, and `backend` puts them together for a context. From OpenGL 3.3 on
moderngl, in the app's own context, makes, writes and frees the programs and buffers
(`device.devices`, `device.buffers`); all else goes by the driver's bare functions
(`glshim.driver.functions`): textures, framebuffers and vertex arrays, uniforms, bindings, state,
draws, and in OpenGL 2.1, which moderngl does not serve, programs, too.
"""
