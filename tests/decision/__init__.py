"""How exactly ridges and valleys are told from other folds: `python -m tests.decision`."""
