import sys

from tests.coherence.report import main

sys.exit(main(sys.argv[1:]))
