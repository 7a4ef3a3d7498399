"""CPU time per decision, measured side by side in one run: ``make bench``."""
