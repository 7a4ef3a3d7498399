"""What people write wrongly into a pipeline, and what has to be told: where, under which key, and some of the words."""

from __future__ import annotations

from typing import NamedTuple

BASE = """\
seed: 3
decisions: 50
on_incident: continue
world:
  use: rail
  length_m: 5
tutor: pusher
student:
  use: backprop
  hidden: 3
  encoder:
    use: ranges
    ranges: [[0, 5]]
    steps: 4
  codec: kind-level-ampbit
selector: same-kind
amplifier: {use: learning-phase, decisions: 10, change: additive}
evaluator: {use: interval, evaluator: conditions}
conditions:
  - crashed
  - use: any-of
    of: [crashed]
limits:
  cap: 0.8
observers:
  - attractors
"""


class Mistake(NamedTuple):
    """One text in place of another, and what has to be said about it."""

    old: str
    new: str
    place: str
    """``line:column``, or nothing where it is about what is not there."""
    key: str
    words: tuple[str, ...]


SYNTAX = [
    Mistake("  length_m: 5", "\tlength_m: 5", "6:1", "", ("tab", "spaces")),
    Mistake("    ranges: [[0, 5]]", "    ranges: [[0, 5]", "13:13", "", ("'['", "not closed", "line 14")),
    Mistake(
        "amplifier: {use: learning-phase,", "amplifier: {use: learning-phase", "17:12", "", ("'{'", "comma is missing")
    ),
    Mistake("tutor: pusher", "tutor: 'pusher", "7:8", "", ("quote that opens here", "never closed")),
    Mistake("tutor: pusher", 'tutor: "C:\\pusher"', "7:12", "", ("unknown escape character", "single quotes")),
    Mistake("tutor: pusher", "tutor:pusher", "7:1", "", ("':'", "space", "missing")),
    Mistake("tutor: pusher", "tutor: @pusher", "7:8", "", ("'@'", "quote the value")),
    Mistake("tutor: pusher", "tutor: *pusher", "7:8", "", ("alias", "'*'")),
    Mistake("tutor: pusher", "tutor: pusher: fast", "7:14", "", ("':' is not expected here", "indentation")),
    Mistake("  hidden: 3", "hidden: 3", "11:10", "", ("':' is not expected here",)),
    Mistake("tutor: pusher", "tutor: pusher\n---", "8:1", "", ("document", "Remove the '---'")),
    Mistake("tutor: pusher", "tutor: pusher\x00", "7:14", "", ("#x0000", "not allowed")),
    Mistake("seed: 3", "seed: 3\nseed: 4", "2:1", "seed", ("in line 1 too", "keep one")),
    Mistake("  hidden: 3", "  hidden: 3\n  hidden: 4", "11:3", "student.hidden", ("in line 10 too",)),
    Mistake("seed: 3", "seed: !!python/object/apply:os.system [ls]", "1:7", "seed", ("!!python/object/apply", "tags")),
    Mistake("tutor: pusher", "tutor: !pusher {}", "7:8", "tutor", ("the tag '!pusher' is not allowed",)),
    Mistake("tutor: pusher", "7: pusher", "7:1", "", ("the key 7 is not a word", "quote it")),
    Mistake("tutor: pusher", "? [a, b]\n: pusher", "7:3", "", ("is not a word",)),
    Mistake("limits:", "<<: 3\nlimits:", "23:5", "", ("'<<' merges mappings", "alias")),
    Mistake("seed: 3", f"seed: {'[' * 60}{']' * 60}", "1:56", "", ("nested too deeply", "make it flatter")),
    Mistake("seed: 3", "seed: &a [*a]", "1:7", "seed.0.0", ("contains itself",)),
    Mistake("seed: 3", f"seed: {'9' * 5000}", "1:7", "seed", ("is no int", "5,000 digits", "1000 are allowed")),
    Mistake("seed: 3", "seed: 017", "1:7", "seed", ("leading zero", "write 17", "0o17")),
]
VALUES = [
    Mistake("seed: 3", "seed: -1", "1:1", "seed", ("greater than or equal to 0", "found -1")),
    Mistake("seed: 3", "seed: 3.5", "1:1", "seed", ("valid integer", "fractional part", "found 3.5")),
    Mistake("seed: 3", "seed: .nan", "1:1", "seed", ("finite number", "found nan")),
    Mistake("seed: 3", "seed: yes", "1:1", "seed", ("valid integer", "found 'yes'")),
    Mistake("seed: 3", "seed: true", "1:1", "seed", ("should be a number", "found true")),
    Mistake("seed: 3", "seed:", "1:1", "seed", ("valid integer", "found nothing")),
    Mistake("seed: 3", "seed: [3]", "1:1", "seed", ("valid integer", "found [3]")),
    Mistake("seed: 3", "seed: 2026-01-01", "1:1", "seed", ("valid integer", "found '2026-01-01'")),
    Mistake("decisions: 50", "decisions: 0", "2:1", "decisions", ("greater than or equal to 1",)),
    Mistake("decisions: 50", "decisions: 10k", "2:1", "decisions", ("valid integer", "found '10k'")),
    Mistake("decisions: 50", "decisions: 1e10", "2:1", "decisions", ("less than or equal to 1000000000",)),
    Mistake("continue", "contniue", "3:1", "on_incident", ("'continue' or 'raise'", "did you mean 'continue'?")),
    Mistake("continue", "", "3:1", "on_incident", ("'continue' or 'raise'", "found nothing")),
    Mistake("length_m: 5", "length_m: .inf", "6:3", "world.length_m", ("finite number", "found inf")),
    Mistake("length_m: 5", "length_m: off", "6:3", "world.length_m", ("valid number", "found 'off'")),
    Mistake("length_m: 5", "length_m: -5", "6:3", "world.length_m", ("world 'rail'", "greater than 0", "found -5")),
    Mistake("hidden: 3", "hidden: 0", "10:3", "student.hidden", ("greater than or equal to 1", "found 0")),
    Mistake("hidden: 3", "hidden: {n: 3}", "10:3", "student.hidden", ("valid integer", "found {'n': 3}")),
    Mistake("hidden: 3", "hidden: 3\n  momentum: 1.5", "11:3", "student.momentum", ("less than 1", "found 1.5")),
    Mistake("steps: 4", "steps: 0", "14:5", "student.encoder.steps", ("encoder 'ranges'", "found 0")),
    Mistake("[[0, 5]]", "[[0, x]]", "13:18", "student.encoder.ranges.0.1", ("valid number", "found 'x'")),
    Mistake("[[0, 5]]", "[[0]]", "13:14", "student.encoder.ranges.0.1", ("too few values", "found [0]")),
    Mistake("[[0, 5]]", "[[0, 5, 6]]", "13:14", "student.encoder.ranges.0", ("at most 2", "found [0, 5, 6]")),
    Mistake("[[0, 5]]", "[0, 5, 6]", "13:14", "student.encoder.ranges.0", ("found 0",)),
    Mistake("[[0, 5]]", "{x: [0, y]}", "13:21", "student.encoder.ranges.x.1", ("valid number", "found 'y'")),
    Mistake("[[0, 5]]", "{x: [0, true]}", "13:5", "student.encoder.ranges", ("should be a number",)),
    Mistake("[[0, 5]]", "{x.: [0, 5]}", "13:14", "student.encoder.ranges.x.", ("should match pattern",)),
    Mistake("[[0, 5]]", "5", "13:5", "student.encoder.ranges", ("valid list", "found 5")),
    Mistake("[[0, 5]]", "[[0, true]]", "13:5", "student.encoder.ranges", ("should be a number",)),
    Mistake("[[0, 5]]", "[[5, 0]]", "11:3", "student.encoder", ("low below high",)),
    Mistake("decisions: 10,", "decisions: -1,", "17:34", "amplifier.decisions", ("greater than or equal to 0",)),
    Mistake("interval,", "interval, begin: 5, end: 2,", "18:1", "evaluator", ("must be more than begin",)),
    Mistake("cap: 0.8", "cap: 0", "24:3", "limits.cap", ("greater than 0", "found 0")),
    Mistake("cap: 0.8", "cap: 1/2", "24:3", "limits.cap", ("valid number", "found '1/2'")),
    Mistake("cap: 0.8", "cap: 0.8\n  slew: 0", "25:3", "limits.slew", ("greater than or equal to 1",)),
    Mistake("cap: 0.8", "factor: 0.5", "24:3", "limits.factor", ("greater than or equal to 1",)),
    Mistake("  cap: 0.8\n", "", "23:1", "limits", ("found nothing", "as in limits: {cap: 0.8}")),
    Mistake("limits:\n  cap: 0.8", "limits: 0.8", "23:1", "limits", ("found 0.8", "write a mapping")),
]
KEYS = [
    Mistake(
        "tutor: pusher", "tutr: pusher", "7:1", "tutr", ("unknown key", "did you mean 'tutor'?", "Allowed: amplifier,")
    ),
    Mistake("Seed: 3".lower(), "Seed: 3", "1:1", "Seed", ("unknown key", "did you mean 'seed'?")),
    Mistake("seed: 3", "world.scene: x", "1:1", "world.scene", ("unknown key", "nested", "world: {scene: ...}")),
    Mistake(
        "length_m", "lenght_m", "6:3", "world.lenght_m", ("unknown option", "did you mean 'length_m'?", "patience")
    ),
    Mistake("hidden", "hiden", "10:3", "student.hiden", ("did you mean 'hidden'?", "Options: codec,")),
    Mistake("steps", "step", "14:5", "student.encoder.step", ("encoder 'ranges'", "did you mean 'steps'?")),
    Mistake("change:", "chnge:", "17:49", "amplifier.chnge", ("did you mean 'change'?",)),
    Mistake("of: [", "off: [", "22:5", "conditions.1.off", ("did you mean 'of'?", "Options: of.")),
    Mistake("cap:", "caps:", "24:3", "limits.caps", ("did you mean 'cap'?", "Options: cap, factor, slew.")),
    Mistake(
        "tutor: pusher", "tutor: {use: pusher, speed: 3}", "7:22", "tutor.speed", ("unknown option", "Options: none.")
    ),
    Mistake("tutor: pusher\n", "", "", "", ("there is no 'tutor'", "name one")),
    Mistake("world:\n  use: rail\n  length_m: 5\n", "", "", "", ("there is no 'world'", "add one")),
    Mistake("  use: backprop\n", "", "8:1", "student", ("there is no 'use' in it", "as in {use:")),
    Mistake("    of: [crashed]", "    {}", "22:5", "", ("a ':' with a space after it is missing",)),
    Mistake(
        "  encoder:\n    use: ranges\n    ranges: [[0, 5]]\n    steps: 4\n", "", "8:1", "student.encoder", ("required",)
    ),
]
PARTS = [
    Mistake(
        "use: rail", "use: ral", "5:3", "world.use", ("no world named 'ral'", "did you mean 'rail'?", "Installed:")
    ),
    Mistake("pusher", "puhser", "7:1", "tutor", ("no tutor named 'puhser'", "did you mean 'pusher'?")),
    Mistake("use: backprop", "use: bakprop", "9:3", "student.use", ("no student named", "did you mean 'backprop'?")),
    Mistake("use: ranges", "use: range", "12:5", "student.encoder.use", ("no encoder named", "did you mean 'ranges'?")),
    Mistake(
        "codec: kind-level-ampbit",
        "codec: kind-level",
        "15:3",
        "student.codec",
        ("no codec named", "kind-level-ampbit'?"),
    ),
    Mistake("same-kind", "samekind", "16:1", "selector", ("no selector named", "did you mean 'same-kind'?")),
    Mistake("learning-phase", "learning_phase", "17:13", "amplifier.use", ("no amplifier named", "'learning-phase'?")),
    Mistake("additive", "addtive", "17:49", "amplifier.change", ("no change named", "did you mean 'additive'?")),
    Mistake(
        "use: interval", "use: intervall", "18:13", "evaluator.use", ("no evaluator named", "did you mean 'interval'?")
    ),
    Mistake("evaluator: conditions}", "evaluator: x}", "18:28", "evaluator.evaluator", ("no evaluator named 'x'",)),
    Mistake("- crashed", "- crash", "20:5", "conditions.0", ("no condition named", "did you mean 'crashed'?")),
    Mistake("use: any-of", "use: anyof", "21:5", "conditions.1.use", ("no condition named", "did you mean 'any-of'?")),
    Mistake("[crashed]", "[crashd]", "22:10", "conditions.1.of.0", ("no condition named", "did you mean 'crashed'?")),
    Mistake("[crashed]", "[{use: any-of, of: [{use: not}]}]", "22:29", "conditions.1.of.0.of.0.of", ("required",)),
    Mistake("- attractors", "- attractor", "26:5", "observers.0", ("no observer named", "did you mean 'attractors'?")),
    Mistake("tutor: pusher", "tutor: backprop", "7:1", "tutor", ("no tutor named", "There is a student of that name")),
    Mistake("tutor: pusher", "tutor: conditions", "7:1", "tutor", ("There is an evaluator of that name",)),
    Mistake("tutor: pusher", "tutor: 3", "7:1", "tutor", ("found 3", "named by a word", "{use: name}")),
    Mistake("tutor: pusher", "tutor:", "7:1", "tutor", ("found nothing", "named by a word")),
    Mistake("tutor: pusher", "tutor: [pusher]", "7:1", "tutor", ("found ['pusher']", "named by a word")),
    Mistake("tutor: pusher", "tutor: {name: pusher}", "7:1", "tutor", ("no 'use' in it", "name a tutor")),
    Mistake("tutor: pusher", "tutor: {use: 3}", "7:9", "tutor.use", ("found 3", "name of a tutor", "Installed:")),
    Mistake("tutor: pusher", "tutor: {pusher: {}}", "7:1", "tutor", ("no 'use' in it", "{use: pusher}")),
    Mistake("codec: kind-level-ampbit", "codec:", "15:3", "student.codec", ("found nothing", "a codec is named by")),
    Mistake(
        "codec: kind-level-ampbit", "codec: [kind-level-ampbit]", "15:3", "student.codec", ("a codec is named by",)
    ),
    Mistake("of: [crashed]", "of: crashed", "22:5", "conditions.1.of", ("found 'crashed'", "write a list")),
    Mistake(
        "of: [crashed]", "of: [[crashed]]", "22:10", "conditions.1.of.0", ("found ['crashed']", "a condition is named")
    ),
    Mistake("of: [crashed]", "of: [~]", "22:10", "conditions.1.of.0", ("found nothing", "a condition is named")),
    Mistake("of: [crashed]", "of: []", "22:5", "conditions.1.of", ("at least 1 item",)),
    Mistake(
        "  - crashed\n  - use: any-of\n    of: [crashed]",
        "  crashed",
        "19:1",
        "conditions",
        ("found 'crashed'", "write a list, as in [name]"),
    ),
    Mistake("  - attractors", "  attractors", "25:1", "observers", ("found 'attractors'", "write a list")),
    Mistake("  - attractors\n", "", "25:1", "observers", ("found nothing", "write a list")),
]
WIRING = [
    Mistake(
        "same-kind", "modifier", "16:1", "selector", ("needs LevelProposal", "makes KindProposal", "'level-ampbit'")
    ),
    Mistake("selector: same-kind\n", "selector: {use: modifier}\n", "16:1", "selector", ("needs LevelProposal",)),
    Mistake("kind-level-ampbit\nselector: same-kind", "level-ampbit", "8:1", "student", ("needs KindProposal",)),
    Mistake("- use: any-of\n    of: [crashed]", "- crashed", "21:5", "conditions.1", ("'crashed' stands there twice",)),
    Mistake("tutor: pusher", "tutor: prototype2", "4:1", "world", ("executes Push but", "returns DriveAction")),
    Mistake("seed: 3", "on_tutor_failure: stop", "1:1", "on_tutor_failure", ("found 'stop'", "'raise' or an action")),
    Mistake("seed: 3", "on_tutor_failure: rise", "1:1", "on_tutor_failure", ("did you mean 'raise'?", "{kind: rest}")),
    Mistake(
        "seed: 3", "on_tutor_failure: {}", "1:1", "on_tutor_failure.kind", ("not a Push", "required", "{kind: rest}")
    ),
    Mistake(
        "seed: 3", "on_tutor_failure: {kind: stp}", "1:20", "on_tutor_failure.kind", ("'push' or 'rest'", "found 'stp'")
    ),
    Mistake(
        "seed: 3",
        "on_tutor_failure: {kind: push, force: 9}",
        "1:32",
        "on_tutor_failure.force",
        ("less than or equal to 1",),
    ),
    Mistake("seed: 3", "on_tutor_failure: {kind: push, frce: 1}", "1:32", "on_tutor_failure.frce", ("mean 'force'?",)),
    Mistake("seed: 3", "learned: absent.npz", "1:1", "learned", ("absent.npz",)),
    Mistake("seed: 3", "extends: absent.yaml", "1:1", "extends", ("there is no file absent.yaml",)),
]
