"""``python -m tutorstudent``."""

from tutorstudent.cli import main

if __name__ == "__main__":
    main()
