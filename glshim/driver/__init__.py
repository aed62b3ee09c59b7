"""The driver below all hooks: its bare functions, what it is asked, what of ours lives in it."""
