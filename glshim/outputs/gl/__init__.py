"""The OpenGL picture: lines and passes over the app's own frame."""
