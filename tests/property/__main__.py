"""``python -m tests.property [EXAMPLES]`` fuzzes at length: so many programs for each property."""

import os
import sys

import pytest

if __name__ == "__main__":
    os.environ["PROPERTY_EXAMPLES"] = sys.argv[1] if len(sys.argv) > 1 else "3000"
    raise SystemExit(pytest.main(["-q", "-x", os.path.dirname(__file__)]))
