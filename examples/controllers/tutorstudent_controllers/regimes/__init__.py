"""One student, one parameter set, many regimes: what being told of violations is worth (docs/student.md)."""
