"""Window toolkits: how a frame ends, keys, redraw, clock, the drawable and its size."""
