"""An independent judge of what leaves a wrapped controller for its owner."""
