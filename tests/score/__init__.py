"""A picture score: drawn ink against true visible lines. ``python -m tests.score``.

meshes -> features (lines from connectivity) + crossings -> sight (what of them is seen)
-> ink (precision, recall, dots of a picture) -> views (real frames) -> report.
"""
