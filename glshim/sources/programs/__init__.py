"""Draws under shader programs of the app's own."""
