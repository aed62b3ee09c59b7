"""What the interpreter and the operating system do below us: files, memory, signals."""
