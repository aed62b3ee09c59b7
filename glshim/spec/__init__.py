"""What each GL entry point means to us, as data."""
