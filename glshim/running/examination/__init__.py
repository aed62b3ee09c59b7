"""What is seen of a program: `inside` counts in its process, `findings` are what it tells."""
