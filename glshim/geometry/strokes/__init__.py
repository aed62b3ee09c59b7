"""Lines from edges, and strokes from lines, as a hand would draw them in one go."""
