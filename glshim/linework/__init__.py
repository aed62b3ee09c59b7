"""Which lines there are in a layer, joined into chains. Outputs use it; it knows none of them."""
