"""Reference parts; each module registers its own through the one hook."""
