"""The OpenGL picture: lines and passes over the app's own frame.

`device` holds GL objects and state, `frame` what is done with the app's own frame, `lines` and
`passes` draw what stylers give, and `backend` puts them together for a context. All of them speak
to the driver by its bare functions (`glshim.spec.driver`): no other GL library has a say in the
app's context.
"""
