"""``python -m tutorstudent``."""

from tutorstudent.command.program import main

if __name__ == "__main__":
    main()
