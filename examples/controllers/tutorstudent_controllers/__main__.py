"""Print the tables of all studies below a folder: python -m tutorstudent_controllers studies/controllers."""

from __future__ import annotations

import sys
from pathlib import Path

import tutorstudent as ts
from tutorstudent_controllers.measures import MEASURES
from tutorstudent_controllers.tables import table


def main(folder: Path) -> None:
    """Print a heading and a table for each example that has a study there; exit with a sentence where none has."""
    found = [folder / name for name in MEASURES if (folder / name).is_dir()]
    if not found:
        sys.exit(f"{folder}: there is no study of {', '.join(MEASURES)}; run 'make controllers' first.")
    for study in found:
        try:
            sys.stdout.write(f"## {study.name}\n\n{table(study)}\n\n")
        except ts.TutorStudentError as error:
            sys.exit(str(error))


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "studies/controllers"))
