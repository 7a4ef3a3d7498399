# `make demo` and `make test` do everything on a machine with Python 3.11 (or newer) and make.

PYTHON ?= $(shell command -v python3.11 || command -v python3)
VENV := .venv
BIN := $(VENV)/bin
PIPELINES := examples/prototype2/tutorstudent_prototype2/pipelines
WORKERS ?= 2

.PHONY: help demo picture compare test check fix format lint types quick lowest tests slow soak soak-full mutants bench install hooks docs clean \
	walk freeze predict reproduce reproduce-smoke intervals transplant heldout controllers controllers-smoke \
	student-controllers student-pioneer

help: ## say what there is
	@grep -E '^[a-z-]+:.*## ' $(MAKEFILE_LIST) | sed 's/:.*## /\t/'

$(VENV)/bin/python:
	$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11) and "tutorstudent needs Python 3.11 or newer; say make PYTHON=...")'
	$(PYTHON) -m venv $(VENV)

$(VENV)/.demo: pyproject.toml | $(VENV)/bin/python
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e '.[bullet,study]'
	touch $@

$(VENV)/.dev: pyproject.toml examples/controllers/pyproject.toml | $(VENV)/bin/python
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e '.[dev]' -e examples/controllers
	touch $@ $(VENV)/.demo

$(VENV)/.prototype2: pyproject.toml examples/prototype2/pyproject.toml | $(VENV)/bin/python
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -e '.[bullet,study]' -e examples/prototype2
	touch $@ $(VENV)/.demo

install: $(VENV)/.dev ## set up the virtual environment with everything

hooks: $(VENV)/.dev ## format, lint and types before every commit, by pre-commit
	$(BIN)/pre-commit install

demo: $(VENV)/.demo ## prototype 2 alone, with the default student and as 2A, in two environments: table and page
	rm -rf demo-out
	$(BIN)/tutorstudent compare $(PIPELINES)/prototype2.yaml $(PIPELINES)/budgeted.yaml \
		$(PIPELINES)/prototype2a.yaml --vary world.scene=chase-avoid,cave-box --runs 3 --decisions 10000 --search-runs 0 \
		--workers $(WORKERS) --out demo-out

picture: demo ## the README's picture, from the runs of the demo
	$(BIN)/python docs/images/draw.py demo-out

compare: $(VENV)/.demo ## 10 paired seeds with controls in the four environments, full and streamlined
	rm -rf studies/compare
	$(BIN)/tutorstudent compare $(PIPELINES)/prototype2.yaml $(PIPELINES)/prototype2a.yaml $(PIPELINES)/streamlined.yaml \
		--vary world.scene=chase-avoid,cave-box,cave-predator-prey,cave-predator-prey-box \
		--runs 10 --decisions 10000 --workers $(WORKERS) --out studies/compare

PROTOTYPE2 = $(BIN)/tutorstudent-prototype2 $(1) --workers $(WORKERS) --out studies/$@

reproduce: $(VENV)/.prototype2 ## the thesis's tables 2 to 9 beside ours; goes on where it was stopped
	$(call PROTOTYPE2,reproduce)

reproduce-smoke: $(VENV)/.prototype2 ## the same with 2 runs of 500 decisions, to see that all works
	$(call PROTOTYPE2,reproduce --runs 2 --decisions 500)

intervals: $(VENV)/.prototype2 ## in which decisions learning takes place (5.2.5); goes on where it was stopped
	$(call PROTOTYPE2,intervals)

transplant: $(VENV)/.prototype2 ## students carried from Cave-Box into Cave-Predator-Prey-Box (5.2.3); resumable too
	$(call PROTOTYPE2,transplant)

heldout: $(VENV)/.prototype2 ## a scene that no calibration has seen; resumable too
	$(call PROTOTYPE2,heldout)

CALIBRATION = $(BIN)/tutorstudent-prototype2 calibration $@ --workers $(WORKERS)

walk: $(VENV)/.prototype2 ## calibration: settings under which prototype 2 agrees with the thesis; hours, resumable
	$(CALIBRATION)

freeze: $(VENV)/.prototype2 ## calibration: the setting that fits prototype 2 best, into setting.yaml
	$(CALIBRATION)

predict: $(VENV)/.prototype2 ## prototype 2A under every setting that agrees; hours, resumable
	$(CALIBRATION)

CONTROLLERS := examples/controllers/tutorstudent_controllers
CONTROLLED = nice $(BIN)/tutorstudent compare --resume --workers $(WORKERS) $(SIZE) --out studies/$@

controllers: SIZE := --runs 10 --decisions 10000
controllers: $(VENV)/.dev ## published controllers with their controls: docs/controllers.md; resumable too
controllers-smoke: SIZE := --runs 2 --decisions 200 --search-runs 0
controllers-smoke: $(VENV)/.dev ## the same with 2 runs of 200 decisions, to see that all works
controllers controllers-smoke:
	$(CONTROLLED)/pid --harm-budget 0.01 $(CONTROLLERS)/pid/pid.yaml $(CONTROLLERS)/pid/pid-ahead.yaml
	$(CONTROLLED)/tree $(CONTROLLERS)/tree/tree.yaml
	$(CONTROLLED)/planner $(CONTROLLERS)/planner/planner.yaml
	$(CONTROLLED)/walker --goal reward $(CONTROLLERS)/box2d/walker.yaml $(CONTROLLERS)/box2d/walker-constant-2.yaml
	$(CONTROLLED)/lander --goal reward $(CONTROLLERS)/box2d/lander.yaml
	$(BIN)/python -m tutorstudent_controllers studies/$@

REGIMES = $(BIN)/python -m tutorstudent_controllers.regimes

student-controllers: $(VENV)/.dev ## the default student in eleven regimes of five controllers: docs/student.md; resumable
	nice $(REGIMES) controllers --workers $(WORKERS) --out studies/$@

student-pioneer: $(VENV)/.dev $(VENV)/.prototype2 ## the same on the Pioneer: four scenes, three regimes; resumable too
	nice $(REGIMES) pioneer --workers $(WORKERS) --out studies/$@

test: check ## all checks: format, lint, types, tests with warnings as errors
check: format lint types docs tests

fix: $(VENV)/.dev ## format the code, and mend what ruff can mend
	$(BIN)/ruff format .
	$(BIN)/ruff check --fix .

format: $(VENV)/.dev ## is everything formatted?
	$(BIN)/ruff format --check .

lint: $(VENV)/.dev ## ruff's rules
	$(BIN)/ruff check .

types: $(VENV)/.dev ## mypy --strict
	$(BIN)/mypy

QUICK := not (slow or process or study or simulator or types or soak)

quick: $(VENV)/.dev ## in less than a minute: the tests without processes, studies, long simulations, soaks and mypy
	$(BIN)/python -m pytest -n $(WORKERS) -m '$(QUICK)'

LOWEST := $(VENV)/lowest

lowest: | $(VENV)/bin/python ## the quick tests with the lowest versions that pyproject.toml admits, in a venv of their own
	$(PYTHON) -m venv --clear $(LOWEST)
	$(LOWEST)/bin/python -m pip install --quiet --disable-pip-version-check uv
	$(LOWEST)/bin/uv pip install --quiet --python $(LOWEST)/bin/python --resolution lowest-direct \
		-e '.[dev]' -e examples/controllers
	$(LOWEST)/bin/python -m pytest -n $(WORKERS) -m '$(QUICK)'

tests: $(VENV)/.dev ## all tests but the slow ones
	$(BIN)/python -m pytest -n $(WORKERS)

slow: $(VENV)/.dev ## the tests that take minutes to hours each, which `make test` leaves out
	$(BIN)/python -m pytest -m slow

docs: $(VENV)/.dev ## the site, with warnings as errors, into docs/_build
	$(BIN)/python -m sphinx -W --keep-going -q -b html docs docs/_build

soak: $(VENV)/.dev ## a million random decisions, hostile parts and command types: zero breaches of the behaviour contract
	$(BIN)/python -m tests.soak --decisions 1000000 --seed 1

soak-full: $(VENV)/.dev ## the same with ten million; most of an hour
	$(BIN)/python -m tests.soak --decisions 10000000 --seed 1

mutants: $(VENV)/.dev ## faults put into the deciding code one by one: which do the tests not notice? hours
	nice $(BIN)/python -m tests.mutants

bench: $(VENV)/.dev ## CPU time per decision and ratios; writes docs/performance.md
	$(BIN)/python -m tests.bench

clean: ## remove what the targets made
	rm -rf $(VENV) demo-out studies runs docs/_build docs/reference
