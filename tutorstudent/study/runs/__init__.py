"""Runs a plan in parallel, each run into its own folder, and reads what is there afterwards."""
