"""Comparing pipelines with honest evidence.

| step | module |
|---|---|
| what runs in which environments, with which controls | `requests`, `resolving`, `controls`, `planning` |
| the plan, and its file | `plan`, `planfile`, `differences` |
| what is to be achieved | `goals` |
| the constant level that is best | `seeking`, `levels`, `searching` |
| every run, in parallel, each into a folder of its own | `jobs`, `finishing`, `backends`, `timing`, `progress` |
| what is on disk | `results`, `sketches` |
| what parts declared, and numbers of it | `declared`, `quantities` |
| numbers of one row, and of two | `statistics`; `pairs`, `intervals`, `significance` |
| what is held against what | `comparisons`, `verdicts` |
| what has to be said first | `remarks` |
| tables | `cells`, `columns`, `table`, `tables`, `difference_tables` |
| what pictures are made from | `curves`, `bins`, `traces`, `gains`, `palette`, `scales` |
| pictures | `svg`, `charts`, `panels`, `strips`, `scatter`, `labels`, `maps`, `harms`; `screen`, `shots`, `film` |
| pictures with their words | `galleries`, `learning`, `atlas`, `cinema`, `pictures` |
| the page and the other files | `sections`, `head`, `document`; `media`, `search_table`, `latex`, `report` |
| all of it | `studies`, `options`, `command` |

Everything after `jobs` reads the folder only, so a report can be made again without running anything.

In a script: `make_plan` and `run_study`; or `claim_folder` and `finish_jobs` with jobs of its own and their pipelines.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tutorstudent.study.plans.constant_level import Searched
from tutorstudent.study.plans.plan import Environment, Job, Plan, Search, Variant
from tutorstudent.study.plans.planfile import load_plan, save_plan
from tutorstudent.study.plans.planning import make_plan
from tutorstudent.study.plans.requests import Request, Setting, read_pipelines, read_setting, read_variation
from tutorstudent.study.runs.backends import Backend
from tutorstudent.study.runs.finishing import claim_folder, finish_jobs
from tutorstudent.study.runs.jobs import Finished, run_jobs
from tutorstudent.study.runs.results import Failure, Run, Study, pending, read_runs, read_study
from tutorstudent.study.studies import run_plan, run_study

if TYPE_CHECKING:
    from tutorstudent.study.page.report import write_report

__all__ = [
    "Backend",
    "Environment",
    "Failure",
    "Finished",
    "Job",
    "Plan",
    "Request",
    "Run",
    "Search",
    "Searched",
    "Setting",
    "Study",
    "Variant",
    "claim_folder",
    "finish_jobs",
    "load_plan",
    "make_plan",
    "pending",
    "read_pipelines",
    "read_runs",
    "read_setting",
    "read_study",
    "read_variation",
    "run_jobs",
    "run_plan",
    "run_study",
    "save_plan",
    "write_report",
]


def __getattr__(name: str) -> Any:
    if name == "write_report":  # matplotlib is an extra, and slow to import
        from tutorstudent.study.page.report import write_report

        return write_report
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
