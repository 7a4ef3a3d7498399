"""Numbers of one row of runs, and of two held against each other."""
