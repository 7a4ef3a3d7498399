"""The words of the loop: actions, proposals, records, errors, and commands in the owner's own types."""
