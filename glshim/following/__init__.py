"""Follows the app from call to layer: the hooks of capture drive assembly, scene by scene."""
