"""Flaws of the paper's method as printed, and the same scenes in style raskar:
`python -m tests.flaws OUT`."""
