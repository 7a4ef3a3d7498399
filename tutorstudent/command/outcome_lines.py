"""What an owner asks first about a run: how far was it amplified, how often, and what held it back."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from tutorstudent.core.running.arrays import Arrays


def describe_amplification(arrays: Arrays) -> Iterator[str]:
    """Yield sentences about the decisions of a run, as `Recorder` kept them."""
    decisions = len(arrays["resulting_level"])
    ratios = arrays["executed_ratio"][np.isfinite(arrays["executed_ratio"])]
    if len(ratios):
        median, high, most = np.quantile(ratios, [0.5, 0.95, 1.0])
        yield (
            f"executed / said by the tutor: median {median:.3g}, 95 % {high:.3g}, most {most:.3g} "
            f"({len(ratios):,} decisions with a command that is not neutral)"
        )
    amplified = int(np.count_nonzero(arrays["resulting_level"]))
    share = f" ({amplified / decisions:.1%})" if decisions else ""
    yield f"amplified: {amplified:,} of {decisions:,} decisions{share}; {_describe_limits(arrays)}"


def _describe_limits(arrays: Arrays) -> str:
    counts = np.bincount(arrays["limited_by"], minlength=len(arrays["limited_by_names"]))
    found = [(int(count), str(name)) for name, count in zip(arrays["limited_by_names"], counts, strict=True) if name]
    held = [f"{name} {count:,}" for count, name in sorted(found, reverse=True) if count]
    return f"held back by: {', '.join(held)}" if held else "held back by nothing"
