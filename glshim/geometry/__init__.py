"""The papers' formulas in pure numpy, without GL."""
