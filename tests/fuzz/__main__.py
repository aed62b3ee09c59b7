"""``python -m tests.fuzz``: see --help."""

from tests.fuzz.command import main

if __name__ == "__main__":
    raise SystemExit(main())
