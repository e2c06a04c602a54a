# Thin: each target is what a person would type.
PYTHON ?= python3
BIN = .venv/bin

.PHONY: setup run test test-web bench bench-peers fuzz soak screenshots fit docs bundle translations test-csharp blender test-blender release hooks

setup: .venv/ready

.venv/ready: pyproject.toml engine/phonemeengine/__init__.py constraints.txt .ci/system-packages .ci/install
	.ci/system-packages
	PYTHON=$(PYTHON) .ci/install -c constraints.txt -e '.[desktop,preview,server,speech,test]'
	touch $@

run: setup
	@$(BIN)/phonemeanalyser || { [ $$? -eq 3 ] && mkdir -p build \
	  && $(BIN)/phonemeanalyser screenshot phonemeanalyser/demo/demo.flac --at 4 -o build/demo.png \
	  && echo "The demo as a picture: build/demo.png"; }

# On a clean checkout one process compiles the modules first, or each worker would.
test: setup
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	{ $(BIN)/lint-imports && $(BIN)/mypy; } & $(if $(CI),$(BIN)/python -m pytest --collect-only -qq >/dev/null;) \
	  $(BIN)/python -m pytest -q -n auto --maxprocesses 8 --dist worksteal; tests=$$?; wait $$! && exit $$tests

# The demo page in Chromium, which hears a recording as its microphone, bundles there and in Firefox, and examples.
# Needs chromium, firefox-esr and npm, and the network once.
test-web: setup
	@$(BIN)/python -c 'import playwright' 2>/dev/null || $(BIN)/python -m pip install --quiet -e '.[test-web]'
	$(BIN)/python -m pytest -q -m browser

# The C# for Unity and Godot, compiled and run by Mono (mono-mcs, mono-runtime), the C++ for Unreal, by g++, and the GDScript, read by gdtoolkit.
test-csharp: setup
	@$(BIN)/python -c 'import gdtoolkit' 2>/dev/null || $(BIN)/python -m pip install --quiet -e '.[test-godot]'
	$(BIN)/python -m pytest -q -m csharp

bench: setup
	@$(BIN)/python -c 'import librosa' 2>/dev/null || $(BIN)/python -m pip install --quiet -e '.[bench]'
	$(BIN)/python -m tools.bench

# Other recognisers beside ours on the labelled recordings of CORPUS, as one table. They are installed into build/peers; needs npm, and the network
# once.
bench-peers: setup
	$(BIN)/python -m tools.bench.peers $(CORPUS)

fuzz: setup
	$(BIN)/python -m tools.fuzz

soak: setup
	@$(BIN)/python -c 'import moto, s3fs' 2>/dev/null || $(BIN)/python -m pip install --quiet -e '.[soak]'
	$(BIN)/python -m pytest -q -m long
	$(BIN)/python -m tools.soak
	$(BIN)/python -m tools.soak.serving

screenshots: setup
	$(BIN)/python -m tools.screenshots

# Takes new texts of the window up into the translations, and compiles these; fails while a text is untranslated.
translations: setup
	$(BIN)/python -m tools.translations

# Fits presets like the factory's to CORPUS, a folder in the corpus format, into FITTED; MORE is another corpus for the
# extended rules. The factory presets were fitted to more speakers than may be handed on: see tests/data/corpus/README.md.
CORPUS ?= tests/data/corpus
FITTED ?= build/presets
MORE ?=
fit: setup
	$(BIN)/python -m tools.fit.thesis $(CORPUS) -o $(FITTED)
	$(BIN)/python -m tools.fit.rules $(CORPUS) $(if $(MORE),--more $(MORE)) -o $(FITTED)
	$(BIN)/python -m tools.fit.templates $(CORPUS) -o $(FITTED)

# Builds the add-on for Blender into build/blender.
blender: setup
	@$(BIN)/python -m tools.blender

# Tests the add-on in Blender itself, which BPY names as a module; each version has one version of Python.
BPY ?= bpy==5.0.1
BPY_PYTHON ?= python3.11
BPY_HOME = build/$(subst ==,-,$(BPY))
test-blender: blender
	@[ -e $(BPY_HOME)/ready ] || { $(BPY_PYTHON) -m venv $(BPY_HOME) \
	  && $(BPY_HOME)/bin/python -m pip install --quiet --disable-pip-version-check '$(BPY)' pytest && touch $(BPY_HOME)/ready; }
	PYTHONPATH=.:engine $(BPY_HOME)/bin/python -m pytest -c tests/blender/pytest.ini --rootdir . --confcutdir tests/blender \
	  -p no:cacheprovider -q tests/blender

# Builds the documentation into build/docs; a link that leads nowhere fails.
docs: setup
	@$(BIN)/python -c 'import material, mkdocstrings' 2>/dev/null || $(BIN)/python -m pip install --quiet -e '.[docs]'
	NO_MKDOCS_2_WARNING=1 $(BIN)/python -m mkdocs build --strict

# Builds a program that needs no Python into build/bundle: a folder, and an archive of it.
bundle: setup
	$(BIN)/python -m tools.bundle

# Makes all files of a release into build/release, from a checkout without changes.
release: setup
	$(BIN)/python -m tools.release

# Has git check each commit, and its message.
hooks: setup
	@$(BIN)/python -c 'import pre_commit' 2>/dev/null || $(BIN)/python -m pip install --quiet -e '.[hooks]'
	$(BIN)/pre-commit install
