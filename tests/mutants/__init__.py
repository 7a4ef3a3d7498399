"""Mutants: small faults that are put into the engine one by one; tests that notice none of them prove nothing."""
