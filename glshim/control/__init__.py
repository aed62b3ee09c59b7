"""Control while a program runs: keys, the row of styles, files that are saved."""
