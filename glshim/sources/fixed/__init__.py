"""The fixed-function pipeline: immediate mode, arrays, display lists, feedback."""
