"""Chapter 4 of the thesis, reproduced: prototype 2 against prototype 2A in four environments, and what 5.2 leaves open.

| module | what |
|---|---|
| `pipelines` | the controllers as YAML, and the one setting of world and tutor that all share |
| `thesis` | the thesis's numbers as data, and where its sentences do not follow from them |
| `calibration` | fits the free choices on prototype 2's rows alone |
| `reproduce` | tables 2 to 9, beside ours |
| `intervals` | in which decisions learning takes place (5.2.5) |
| `transplant` | students that were trained in another environment (5.2.3) |
| `heldout` | a scene that no calibration has seen |
"""
