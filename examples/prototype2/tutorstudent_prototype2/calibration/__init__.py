"""Fitting the free choices of world and tutor on prototype 2's rows of tables 2, 4, 6 and 8, and on nothing else.

The thesis does not give them, so there are many settings under which our prototype 2 counts what the thesis's counted.

| step | module |
|---|---|
| which choices are free, within which bounds | `choices` |
| where boxes can stand | `places` |
| prototype 2 in one environment under a setting | `trials` |
| which settings are admissible, and which agree with the thesis; written down before the walks | `agreement` |
| walks among the settings that agree | `walks` |
| the setting that all reports use | `freezing` |
| prototype 2A under every setting that agrees: the posterior predictive | `predictive` |

Prototype 2A is a prediction: nothing here but `predictive` runs it, and `predictive` changes nothing.
"""
