"""Contours and suggestive contours of smooth surfaces."""
