"""What lines are drawn with: media that any styler may borrow, ink and what a hand holds."""
