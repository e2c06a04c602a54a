# Thin: each target is what a person would type.
PYTHON ?= python3
BIN = .venv/bin

.PHONY: setup run test bench fuzz soak screenshots fit

setup: .venv/ready

.venv/ready: pyproject.toml constraints.txt .ci/system-packages
	.ci/system-packages
	$(PYTHON) -m venv .venv
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -c constraints.txt -e '.[desktop,preview,test]'
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
	$(BIN)/python -m pytest -q -m long
	$(BIN)/python -m tools.soak

screenshots: setup
	$(BIN)/python -m tools.screenshots

# Fits the factory presets anew; CORPUS is a folder in the corpus format, MORE another one for the extended rules.
CORPUS ?= ../shared/corpus
MORE ?=
fit: setup
	$(BIN)/python -m tools.fit.thesis $(CORPUS) -o presets
	$(BIN)/python -m tools.fit.rules $(CORPUS) $(if $(MORE),--more $(MORE)) -o presets
	$(BIN)/python -m tools.fit.templates $(CORPUS) -o presets
