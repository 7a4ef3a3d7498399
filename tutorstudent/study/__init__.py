"""Comparing pipelines on paired seeds."""
