# gantline: `make help` lists what there is. Every target does its own set-up, in this folder, without root.
.DEFAULT_GOAL := help
SHELL := bash
.SHELLFLAGS := -euo pipefail -c
MAKEFLAGS += --no-print-directory

BIN := .venv/bin
# Random cases are the same in every run of the tests; `make test SEED=7` draws others.
SEED := 2016
export PYO3_PYTHON := $(CURDIR)/$(BIN)/python
# Inside the local environment whatever the caller had active.
export VIRTUAL_ENV := $(CURDIR)/.venv
export PATH := $(CURDIR)/$(BIN):$(PATH)
unexport PYTHONPATH PYTHONHOME
# Tests start the program some hundred times, which compiles its modules anew each time where this is set.
unexport PYTHONDONTWRITEBYTECODE
# Compiling so that the next edit compiles faster takes half as much processor time again, and the tests run slower.
export CARGO_INCREMENTAL := 0

.PHONY: help setup demo test lint environment checks bench docs packages pictures lock clean

help: ## list the targets
	@grep -E '^[a-z]+:.*## ' $(MAKEFILE_LIST) | sed -E 's/^([a-z]+):.*## (.*)/  make \1\t\2/' | expand -t 16

setup: ## make .venv: locked packages, gantline, its compiled core and its player
	@tools/setup.sh

environment:
	@tools/setup.sh packages

demo: setup ## simulate the lift of scenarios/equalizer; table, numerical error, pictures and report in build/demo
	@gantline run scenarios/equalizer --refine -o build/demo

# Files of tests in their order: the browser has one long test, which begins first.
test: lint ## all tests and lints
	PROPTEST_RNG_SEED=$(SEED) cargo test --workspace --exclude gantline-py --locked --quiet
	npm --prefix viewer test --silent
	pytest --numprocesses auto --maxprocesses 8 --dist loadfile --no-loadscope-reorder --hypothesis-seed=$(SEED)

# Compiling the core and looking at types keep one processor busy each, for minutes: they go side by side.
lint: environment ## formatting, clippy, ruff, mypy, import-linter, biome, tsc
	@$(MAKE) --jobs=2 setup checks
	lint-imports --no-cache
	npm --prefix viewer run lint --silent
	npm --prefix viewer run check --silent

# Those that need neither the compiled core nor the player.
checks: environment
	cargo fmt --all --check
	ruff check --quiet
	ruff format --check --quiet
	mypy python/gantline tests benchmarks tools docs
	cargo clippy --workspace --all-targets --locked --quiet -- -D warnings

bench: setup ## race with other codes on the benchmark lifts, growth, stages, time of every scenario
	@.venv-tools/bin/python -m pip --python $(BIN)/python install --quiet --disable-pip-version-check --no-user \
		--require-hashes --only-binary :all: -r requirements/bench.txt \
		|| echo "the other codes could not be installed: the race goes without those that are missing"
	python -m benchmarks.race
	python -m benchmarks.growth
	python -m benchmarks.statics
	python -m benchmarks.losses
	python -m benchmarks.lines
	python -m benchmarks.stages
	python benchmarks/speed.py

docs: setup ## the documentation as web pages in build/docs
	sphinx-build -W --keep-going -q -j auto -b html docs build/docs
	@echo "build/docs/index.html"

packages: setup ## sdist and wheel in build/packages, and whether they are whole
	rm -rf build/packages
	maturin sdist --out build/packages
	maturin build --release --locked --out build/packages
	python tools/packages.py build/packages/*

pictures: setup ## draw the pictures of README and documentation anew
	python tools/pictures.py
	python tools/report_pictures.py

lock: setup ## renew the locks of Python and of the player, and THIRD_PARTY_LICENSES
	.venv-tools/bin/uv pip compile --upgrade --quiet --universal --generate-hashes --no-header --python-version 3.11 requirements/uv.in -o requirements/uv.txt
	.venv-tools/bin/uv pip compile --upgrade --quiet --universal --generate-hashes --no-header --python-version 3.11 --extra cad --group dev --group docs pyproject.toml -o requirements/dev.txt
	npm --prefix viewer update --omit-lockfile-registry-resolved
	python tools/licences.py
	.venv-tools/bin/uv pip compile --upgrade --quiet --universal --generate-hashes --no-header --python-version 3.11 --group bench -c requirements/dev.txt -o requirements/bench.txt

clean: ## remove everything that the other targets made
	rm -rf .venv .venv-tools .setup.lock build target viewer/node_modules python/gantline/viewer/static .mypy_cache .pytest_cache .ruff_cache .hypothesis .import_linter_cache
	rm -f python/gantline/_core*.so
	find python tests docs -name __pycache__ -type d -prune -exec rm -rf {} +
