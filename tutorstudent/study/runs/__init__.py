"""Every run of a plan, in parallel, each into a folder of its own, and what is on disk afterwards."""
