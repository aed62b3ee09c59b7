"""`python -m demo_apps.viewer`."""

import sys

from . import main

if __name__ == "__main__":  # not in the process that loads
    sys.exit(main())
