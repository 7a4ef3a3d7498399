"""What a script imports from `tutorstudent.study`."""

from __future__ import annotations

import subprocess
import sys

import pytest

from tutorstudent import study


def test_every_public_name_is_there() -> None:
    assert [] == [name for name in study.__all__ if not hasattr(study, name)]
    assert sorted(study.__all__) == study.__all__


def test_a_name_that_is_not_there_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="module 'tutorstudent.study' has no attribute 'write_reprot'"):
        study.write_reprot  # noqa: B018 - the access is what is tested


@pytest.mark.process
def test_importing_the_study_imports_no_extra() -> None:
    extras = "('matplotlib', 'joblib', 'scipy', 'pybullet', 'sklearn', 'distributed')"
    program = (
        "import sys; import tutorstudent.study, tutorstudent.command.compare; "
        f"print([m for m in {extras} if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert "[]" == done.stdout.strip()
