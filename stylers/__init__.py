"""glshim's own styles: one folder each, found by entry points like anybody else's."""
