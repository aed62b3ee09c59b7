"""The values that travel between the rooms: polygons, cameras, lights, lines."""
