"""Draws to frame, in the app's own context."""
