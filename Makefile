# `make env`  : .venv with the locked packages, and sitewright itself in editable form
# `make demo` : the wooden frame, planned, approved by policy, built in simulation; no terminal needed
# `make test` : all tests; what this machine lacks is skipped by name, with how to enable it
# `make lint` : style, types and the import contracts
# `make page` : the page's types from the server's, and its bundle (needs node and npm); CI compares both with the committed ones
# `make lock` : new lock files after a change of pyproject.toml (needs uv)

PYTHON ?= python3
BIN := .venv/bin
# Test processes side by side; JOBS=0 runs them in one.
JOBS ?= 2
TESTS ?=
DEMO_DIR ?= sitewright-demo

.PHONY: env dev-env all-env demo test lint page lock clean

env: .venv/.base
dev-env: .venv/.dev
all-env: .venv/.all

.venv/.base: requirements.lock pyproject.toml
	@echo "Sitewright: making .venv with the locked packages (about a minute) ..."
	$(PYTHON) -c 'import sys; sys.exit(None if sys.version_info >= (3, 11) else "Python 3.11 or newer is needed")'
	test -x $(BIN)/python || $(PYTHON) -m venv .venv
	$(BIN)/python -m pip install --quiet --require-hashes -r requirements.lock
	$(BIN)/python -m pip install --quiet --no-deps -e .
	@touch $@

.venv/.dev: requirements-dev.lock .venv/.base
	$(BIN)/python -m pip install --quiet --require-hashes -r requirements-dev.lock
	@touch $@

.venv/.all: requirements-all.lock .venv/.dev
	$(BIN)/python -m pip install --quiet --require-hashes -r requirements-all.lock
	@touch $@

demo: env
	$(BIN)/sitewright demo --approve auto --into $(DEMO_DIR)

test: dev-env
	$(BIN)/python -m pytest -n $(JOBS) --dist loadfile $(TESTS)

lint: dev-env
	$(BIN)/ruff check src tests benchmarks tools examples
	$(BIN)/ruff format --check src tests benchmarks tools examples
	$(BIN)/mypy src tests
	$(BIN)/lint-imports --no-cache

PAGE := src/sitewright/interaction_twin/page
page: env
	$(BIN)/python tools/write_wire.py
	cd $(PAGE) && npm ci --ignore-scripts --no-audit --no-fund && npm run --silent check && npm run --silent build

UV_COMPILE = uv pip compile pyproject.toml --generate-hashes --no-emit-index-url --no-emit-find-links \
  --universal --python-version 3.11 --no-header --quiet
lock:
	$(UV_COMPILE) -o requirements.lock
	$(UV_COMPILE) --group dev -c requirements.lock -o requirements-dev.lock
	$(UV_COMPILE) --group dev --all-extras -c requirements-dev.lock -o requirements-all.lock

clean:
	rm -rf .venv .mypy_cache .ruff_cache .pytest_cache .hypothesis
