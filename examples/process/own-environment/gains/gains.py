"""The gains that the controller was tuned with; version 2 is tuned for another plant."""

DAMPING = 0.4
