"""What becomes of a finished layer: an output takes what a styler gave."""
