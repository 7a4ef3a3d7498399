"""The maps of one environment: where the robots drove, and where they collided."""

from __future__ import annotations

from html import escape

from tutorstudent.core.world import Sketch
from tutorstudent.study.galleries import Gallery
from tutorstudent.study.harms import harm_map
from tutorstudent.study.maps import level_scale, way_map
from tutorstudent.study.palette import Palette
from tutorstudent.study.plan import Environment
from tutorstudent.study.traces import Traces


def way_gallery(environment: Environment, traces: Traces, sketch: Sketch, seed: int, palette: Palette) -> Gallery:
    """Return the way of the first run of the tutor alone and of every variant that is no control."""
    names = [variant.name for variant in environment.variants if not variant.control]
    if environment.reference:
        names = [environment.reference, *(name for name in names if name != environment.reference)]
    drawn = [way_map(name, sketch, traces.firsts[name], palette) for name in names if name in traces.firsts]
    bars = "".join(f'<i style="background:{colour}"></i>' for colour in level_scale())
    note = (
        f"The run with seed {seed}, the first, not a chosen one; bodies stand where they begin. "
        f'<span class="key">Amplification level 0 <span class="scale">{bars}</span> 8</span>'
    )
    return Gallery("Where it drove", note, "film maps", [picture for picture in drawn if picture is not None])


def harm_gallery(traces: Traces, sketch: Sketch, palette: Palette) -> Gallery:
    """Return where every variant and control was harmed."""
    drawn = [
        harm_map(name, sketch, found, traces.firsts.get(name), palette) for name, found in traces.by_variant.items()
    ]
    collided = traces.measures.harm == "collided"
    note = (
        f"Every {escape(traces.measures.harm)} decision of all runs is a dot where the robot stood then"
        f"{', a ring where a contact began' if collided else ''}; the more there are, the fainter each. "
        "In the background the way of the first run; bodies stand where they begin."
    )
    title = "Where it collided" if collided else "Where conditions were violated"
    return Gallery(title, note, "film", [picture for picture in drawn if picture is not None])
