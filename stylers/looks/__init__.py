"""Looks: style files that come with glshim, and are asked for by their bare names.

Those of McGuire & Hughes 2004, figures 1 and 7, and others over the other styles. They come in by
the entry point ``glshim.looks``, as anybody else's do.
"""
