"""What several styles have in common."""
