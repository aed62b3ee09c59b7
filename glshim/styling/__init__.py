"""The Styler protocol and the registry."""
