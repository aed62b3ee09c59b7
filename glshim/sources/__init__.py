"""Where polygons and cameras come from: the app's calls become layers, scene by scene."""
