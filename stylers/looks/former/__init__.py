"""Looks under the names that they had before: still read, and listed nowhere."""
