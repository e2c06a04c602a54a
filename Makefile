# Thin: each target is what a person would type.
PYTHON ?= python3
BIN = .venv/bin

.PHONY: setup run test bench fuzz soak screenshots fit docs hooks

setup: .venv/ready

.venv/ready: pyproject.toml constraints.txt .ci/system-packages
	.ci/system-packages
	$(PYTHON) -m venv .venv
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -c constraints.txt -e '.[desktop,preview,speech,test]'
	touch $@

run: setup
	@$(BIN)/phonemeanalyser || { [ $$? -eq 3 ] && mkdir -p build \
	  && $(BIN)/phonemeanalyser screenshot phonemeanalyser/demo/demo.flac --at 4 -o build/demo.png \
	  && echo "The demo as a picture: build/demo.png"; }

test: setup
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports
	$(BIN)/python -m pytest -q -n auto --maxprocesses 8 --dist worksteal

bench: setup
	@$(BIN)/python -c 'import librosa' 2>/dev/null || $(BIN)/python -m pip install --quiet -e '.[bench]'
	$(BIN)/python -m tools.bench

fuzz: setup
	$(BIN)/python -m tools.fuzz

soak: setup
	@$(BIN)/python -c 'import moto, s3fs' 2>/dev/null || $(BIN)/python -m pip install --quiet -e '.[soak]'
	$(BIN)/python -m pytest -q -m long
	$(BIN)/python -m tools.soak

screenshots: setup
	$(BIN)/python -m tools.screenshots

# Fits presets like the factory's to CORPUS, a folder in the corpus format, into FITTED; MORE is another corpus for the
# extended rules. The factory presets were fitted to more speakers than may be handed on: see tests/data/corpus/README.md.
CORPUS ?= tests/data/corpus
FITTED ?= build/presets
MORE ?=
fit: setup
	$(BIN)/python -m tools.fit.thesis $(CORPUS) -o $(FITTED)
	$(BIN)/python -m tools.fit.rules $(CORPUS) $(if $(MORE),--more $(MORE)) -o $(FITTED)
	$(BIN)/python -m tools.fit.templates $(CORPUS) -o $(FITTED)

# Builds the documentation into build/docs; a link that leads nowhere fails.
docs: setup
	@$(BIN)/python -c 'import material, mkdocstrings' 2>/dev/null || $(BIN)/python -m pip install --quiet -e '.[docs]'
	NO_MKDOCS_2_WARNING=1 $(BIN)/python -m mkdocs build --strict

# Has git check each commit, and its message.
hooks: setup
	@$(BIN)/python -c 'import pre_commit' 2>/dev/null || $(BIN)/python -m pip install --quiet -e '.[hooks]'
	$(BIN)/pre-commit install
