"""The page shows every run, opens without a network, and keeps its colours."""

from __future__ import annotations

import re
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tutorstudent.core.files.registry import Registry
from tutorstudent.core.roles.world import Sketch
from tutorstudent.core.running.observers import TALLIED
from tutorstudent.study.page import sections
from tutorstudent.study.page.document import make_page
from tutorstudent.study.page.head import make_head
from tutorstudent.study.page.report import write_report
from tutorstudent.study.pictures.maps import _make_way, draw_way_map, list_level_colours
from tutorstudent.study.pictures.palette import Palette
from tutorstudent.study.pictures.strips import draw_strip
from tutorstudent.study.plans.constant_level import Level, Searched
from tutorstudent.study.plans.plan import Plan, Variant
from tutorstudent.study.plans.planning import make_plan
from tutorstudent.study.plans.requests import Request, read_pipelines, read_variation
from tutorstudent.study.runs.jobs import run_jobs
from tutorstudent.study.runs.results import Study
from tutorstudent.study.runs.sketches import load_sketch, save_sketch
from tutorstudent.study.runs.timing import Spent, save_timing
from tutorstudent.study.studies import begin
from tutorstudent.study.tables.media import make_html
from tutorstudent.study.tables.search_table import TITLE, colour_levels, make_search_table
from tutorstudent.study.tables.tables import CONTROLS

pytestmark = pytest.mark.study

VOID = {"meta", "br", "hr", "img", "link", "input"}


class Outline(HTMLParser):
    """Collects elements, and complains about what is not closed."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.open: list[str] = []
        self.elements: list[tuple[str, dict[str, str | None]]] = []
        self.feed(text)
        assert [] == self.open

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, dict(attrs)))

    def handle_endtag(self, tag: str) -> None:
        assert tag == self.open.pop()

    def all(self, tag: str) -> list[dict[str, str | None]]:
        return [attributes for name, attributes in self.elements if name == tag]


@pytest.fixture(scope="module")
def made(corridor_distribution: Path, tmp_path_factory: pytest.TempPathFactory) -> Any:
    from tests.study.conftest import ALONE, FULL  # the fixtures of a function cannot serve a module

    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(str(corridor_distribution))
        registry = Registry.discover()
        folder = tmp_path_factory.mktemp("study")
        (folder / "full.yaml").write_text(FULL.replace("short", "short, fails_with_seed: 2"))
        (folder / "alone.yaml").write_text(ALONE.replace("corridor", "{use: corridor, fails_with_seed: 2}"))
        given = read_pipelines([folder / "full.yaml", folder / "alone.yaml"], registry)
        variations = read_variation("--vary", "world.scene=short,long")
        plan = make_plan(Request(given, 3, decisions=30, variations=variations, search_runs=0), registry)
        out = folder / "out"
        begin(plan, out)
        list(run_jobs(plan.jobs(), out, 1))
    study = write_report(out)
    return study, (out / "report.html").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def study(made: tuple[Study, str]) -> Study:
    return made[0]


@pytest.fixture(scope="module")
def text(made: tuple[Study, str]) -> str:
    return made[1]


@pytest.fixture(scope="module")
def first(study: Study) -> Study:
    """The same in its first environment only."""
    return study._replace(plan=study.plan._replace(environments=study.plan.environments[:1]))


@pytest.fixture(scope="module")
def outline(text: str) -> Outline:
    return Outline(text)


def test_the_page_can_be_fetched_whole(outline: Outline, text: str) -> None:
    for _, attributes in outline.elements:
        for name, value in attributes.items():
            if name in ("src", "href", "xlink:href", "action", "data", "poster", "srcset"):
                assert value is not None
                assert value.startswith(("#", "data:"))
    assert [] == outline.all("script") + outline.all("link") + outline.all("iframe")
    assert not re.search(r"@import|url\((?!#)", text)


def test_every_link_within_the_page_leads_somewhere(outline: Outline) -> None:
    targets = {attributes["id"] for _, attributes in outline.elements if "id" in attributes}
    links = {value for _, found in outline.elements for name in ("href", "xlink:href") if (value := found.get(name))}
    assert {link for link in links if link.startswith("#")} <= {f"#{target}" for target in targets}


def section_of(text: str, environment: str) -> str:
    return text.partition(f'<section id="{environment}">')[2].partition("</section>")[0]


def test_every_run_is_a_row_and_a_dot(study: Study, text: str) -> None:
    for environment in study.plan.environments:
        section = section_of(text, environment.name)
        rows = section.partition("Every run as numbers")[2].count("<tr") - 1
        assert len([run for run in study.runs if run.environment == environment.name]) == rows
        for title in ("turns", "collided decisions"):
            drawing = re.search(rf'<svg[^>]*aria-label="{title}, every run.*?</svg>', section, re.DOTALL)
            assert drawing is not None
            dots = re.findall(r"<use [^>]*style=\"fill: var\(--v\d\)", drawing[0])
            assert rows == len(dots)


def test_every_variant_has_a_panel_for_each_measure(study: Study, outline: Outline) -> None:
    labels = [label for attributes in outline.all("svg") if (label := attributes.get("aria-label"))]
    totals = ("turns", "collided decisions")
    for title in (*totals, "turns per 1,000 decisions", "collided decisions per 1,000", "mean level"):
        for variant in study.plan.variants():
            found = [label for label in labels if label.startswith(f"{title} over decisions, {variant.name}. ")]
            assert len(study.plan.environments) == len(found)


def test_runs_that_failed_are_told(study: Study, text: str) -> None:
    assert 2 * 6 == len(study.failures)
    assert "12 runs failed and are in no table" in text
    assert "short, blind, seed 2: decision 0: world &#x27;corridor&#x27;: reset() raised RuntimeError: the wall" in text


def test_what_the_runs_took_is_said_where_every_one_was_timed(first: Study, tmp_path: Path) -> None:
    palette = Palette(first.plan.variants())
    assert "CPU seconds" not in make_head(first._replace(folder=tmp_path), "x", palette)
    runs = [run._replace(folder=tmp_path / str(i)) for i, run in enumerate(first.runs[:2])]
    for run in runs:
        run.folder.mkdir()
    (tmp_path / "sittings.json").write_text('[{"wall_s": 600.4}, {"wall_s": 1000.0}]')
    save_timing(runs[0].folder, Spent(900.0, 700.0))
    partly = first._replace(folder=tmp_path, runs=tuple(runs))
    assert "CPU seconds" not in make_head(partly, "x", palette)
    save_timing(runs[1].folder, Spent(900.0, 800.6))
    told = "They took 1,501 CPU seconds, 1,600 seconds of wall time in 2 sittings on the machine that ran them."
    assert told in make_head(partly, "x", palette)


def test_the_search_is_a_table_where_there_was_one() -> None:
    levels = (
        Level("cave", 0, 2, 30.0, 0.0004),
        Level("cave", 3, 2, 41.5, 0.0009, chosen=True),
        Level("cave", 8, 0, None, None),
    )
    searched = Searched("attractors", 0.001, (1_000_000, 1_000_001), levels)
    table = make_search_table(searched, "cave")
    assert [
        ("level 0, the tutor alone", "2", "30.0", "0.04%", ""),
        ("level 3", "2", "41.5", "0.09%", "chosen"),
        ("level 8", "0", "-", "-", ""),
    ] == [(row.name, *row.cells) for row in table.rows]
    assert "(seeds 1000000, 1000001)" in table.note
    assert "at most 0.10% of decisions" in table.note
    assert () == make_search_table(searched, "elsewhere").rows
    Outline(make_html(table, colour_levels()))


def test_the_search_stands_in_the_section_of_its_environment(first: Study) -> None:
    name = first.plan.environments[0].name
    assert TITLE not in make_page(first._replace(runs=()))
    searched = Searched("turns", 0.001, (9,), (Level(name, 0, 1, 3.0, 0.0), Level(name, 5, 1, 4.0, 0.0, chosen=True)))
    shown = section_of(make_page(first._replace(runs=(), search=searched)), name)
    assert TITLE in shown
    assert ">level 5</th>" in shown


def test_a_section_is_a_function_in_a_list(first: Study, monkeypatch: pytest.MonkeyPatch) -> None:
    def seeds(chapter: sections.Chapter) -> str | None:
        return f"<p>of {len(chapter.study.plan.seeds)} seeds in {chapter.environment.name}</p>"

    monkeypatch.setattr(sections, "IN_AN_ENVIRONMENT", (seeds, lambda chapter: None))
    monkeypatch.setattr(sections, "OF_THE_STUDY", (sections.environments, lambda study: "<p>the end</p>"))
    shown = make_page(first)
    assert "<p>of 3 seeds in short</p>" in section_of(shown, "short")
    assert "<p>the end</p>\n</body>" in shown
    assert "None" not in shown


def test_every_drawing_has_a_text(outline: Outline) -> None:
    drawings = outline.all("svg")
    # All have turns, collisions, contacts, way and time, and what every run measures; only two name kinds.
    every_run = [measure for measure in TALLIED if measure.name != "match_rate"]
    gains, strips, totals, rates, matches, ways, harms = 1, 2, 2 * 6, (5 + len(every_run)) * 6, 2, 2, 6
    assert 2 * (gains + strips + totals + rates + matches + ways + harms) == len(drawings)
    assert all(attributes.get("role") == "img" and attributes.get("aria-label") for attributes in drawings)


def test_the_page_says_what_a_control_is_and_that_speed_finds_more(text: str) -> None:
    assert CONTROLS in text
    assert "Amplifying alone may achieve more, whether or not anything was learned" in text


def test_a_variant_has_one_colour_everywhere(study: Study, text: str) -> None:
    palette = Palette(study.plan.variants())
    for variant in study.plan.variants():
        colour = palette.find_css(variant.name)
        assert {colour} == set(re.findall(rf'background:([^"]*)"></i>{variant.name}<', text))
        panels = re.findall(rf"<svg[^>]*over decisions, {variant.name}\. .*?</svg>", text, re.DOTALL)
        assert panels
        for panel in panels:
            assert {colour} == set(re.findall(r"var\(--v\d+\)", panel))


def test_no_stand_in_for_a_colour_is_left(text: str) -> None:
    assert not re.search(r"#(?:fe|01)[0-9a-f]{4}\b", text)


def test_light_and_dark_ground_have_a_colour_for_each_variant(study: Study, text: str) -> None:
    count = len(study.plan.variants())
    for i in range(count):
        assert 2 == len(re.findall(rf"--v{i}:#[0-9a-f]{{6}};", text))
    assert f"--v{count}:" not in text


def test_no_two_of_ten_variants_share_a_colour() -> None:
    variants = [Variant(str(i), "", i > 4, {}, {}) for i in range(10)]
    palette = Palette(variants)
    for ground in (0, 1):
        colours = re.findall(r"#[0-9a-f]{6}", palette.make_declarations(ground))
        assert 10 == len(set(colours))


def test_a_report_can_be_made_again_to_the_last_byte(study: Study, text: str) -> None:
    assert text == make_page(study)


def test_the_markdown_has_the_tables_of_every_environment(study: Study) -> None:
    text = (study.folder / "table.md").read_text(encoding="utf-8")
    for environment in study.plan.environments:
        section = text.partition(f"## {environment.name}\n")[2]
        for title in ("What was found", "What it cost", "What the parts did"):
            assert f"**{title}**" in section
    assert CONTROLS in text


def test_without_controls_the_page_says_what_it_does_not_show(first: Study) -> None:
    environment = first.plan.environments[0]
    given = tuple(variant for variant in environment.variants if not variant.control)
    bare = Plan((environment._replace(variants=given),), first.plan.seeds, first.plan.decisions)
    shown = make_page(first._replace(plan=bare))
    assert "made without controls" in shown
    assert CONTROLS not in shown


def test_hostile_names_stay_text(first: Study) -> None:
    nasty = '<script>alert("x")</script>'
    environment = first.plan.environments[0]
    variants = tuple(variant._replace(about=nasty) for variant in environment.variants)
    plan = first.plan._replace(environments=(environment._replace(variants=variants),))
    failures = (first.failures[0]._replace(problem=nasty),)
    shown = make_page(first._replace(plan=plan, failures=failures, runs=()))
    assert "<script" not in shown
    assert "&lt;script&gt;" in shown


def test_a_study_of_which_nothing_ran_still_has_a_page(first: Study) -> None:
    Outline(make_page(first._replace(runs=())))


SKETCH = Sketch([([(0.0, 0.0), (2.0, 0.0), (2.0, 1.0)], "grey")], [((1.0, 0.5), 0.2, "red")], [(0.1, 0.2, 3.0, "x")])


def test_a_sketch_can_be_read_again(tmp_path: Path) -> None:
    save_sketch(tmp_path / "deep" / "s.json", SKETCH)
    found = load_sketch(tmp_path / "deep" / "s.json")
    assert [(list(points), colour) for points, colour in SKETCH.polygons] == list(found.polygons)
    assert (list(SKETCH.discs), list(SKETCH.poses)) == (found.discs, found.poses)
    assert Sketch() == load_sketch(tmp_path / "none.json")


def test_a_way_breaks_where_a_trial_ends_and_only_there() -> None:
    events = np.column_stack([np.arange(5.0), np.zeros(5)])
    arrays = {"resulting_level": np.array([1, 2, 3, 4, 5]), "trial_ended": np.array([0, 0, 1, 0, 0])}
    way = _make_way(events, arrays)
    assert [(0.0, 1.0), (1.0, 2.0), (3.0, 4.0)] == [(path[0][0], path[1][0]) for path in way.get_segments()]
    assert [2, 3, 5] == np.asarray(way.get_array()).tolist()


def test_a_world_without_places_has_no_map() -> None:
    arrays = {"event_names": np.array(["collided"]), "events": np.zeros((3, 1))}
    assert draw_way_map("x", SKETCH, arrays, Palette([Variant("x", "", False, {}, {})])) is None


def test_levels_have_nine_colours() -> None:
    assert 9 == len(set(list_level_colours()))


@pytest.mark.parametrize("numbers", [[], [0.0], [1.0] * 10, [0.0, 0.0, 5000.0], [float(i) for i in range(9)]])
def test_a_strip_shows_any_numbers(numbers: list[float]) -> None:
    drawn = draw_strip("hits", {"x": numbers}, Palette([Variant("x", "", False, {}, {})]))
    assert len(numbers) == len(re.findall(r"<use [^>]*var\(--v0\)", drawn))
    assert (max(numbers, default=0.0) == 5000.0) == ("logarithmic beyond 10" in drawn)
