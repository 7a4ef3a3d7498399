"""Comparing pipelines with honest evidence.

| step | module |
|---|---|
| what runs in which environments, with which controls | `requests`, `resolving`, `controls`, `plan`, `planning` |
| every run, in parallel, each into a folder of its own | `jobs` |
| what is on disk | `results`, `sketches` |
| numbers, and how they are written | `statistics`, `columns`, `tables` |
| pictures | `curves`, `palette`, `svg`, `panels`, `strips`, `maps`, `pictures` |
| the page | `media`, `page`, `report` |
| all of it | `command` |

Everything after `jobs` reads the folder only, so a report can be made again without running anything.
"""
