"""Decisions in a row: the loop with a world, and what watches and records it."""
