"""What every styler keeps to, as checks: for ``glshim check-style`` and for glshim's own tests."""
