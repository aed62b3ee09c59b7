"""The app's own frame: read, covered while the app draws, and drawn over."""
