# The front door: thin names over CMake presets (CMakePresets.json). `make help` lists them.

PREFIX ?= /usr/local
JOBS   ?= $(shell nproc)
BUILD  := build
export CMAKE_GENERATOR ?= $(if $(shell command -v ninja),Ninja,Unix Makefiles)
export CTEST_OUTPUT_ON_FAILURE := 1

WHIRL    := $(BUILD)/whirl
INSTALL  := scripts/install-dependencies.sh
# A build that exists keeps its options: `make` after `make test` does not throw the tests out.
CONFIGURE = test -f $(BUILD)/CMakeCache.txt || cmake --preset release -DWHIRL_TESTS=OFF
COMPILE   = cmake --build $(BUILD) --parallel $(JOBS) --target whirl
SOURCES   = $(shell git ls-files --cached --others --exclude-standard '*.c' '*.cc' '*.h')
SCRIPTS   = $(shell git ls-files --cached --others --exclude-standard 'explorer/*.ts' 'explorer/*.mjs')
PRETTIER  = explorer/node_modules/.bin/prettier --log-level warn
FUZZERS   = $(patsubst tests/fuzz/%.c,%,$(wildcard tests/fuzz/fuzz_*.c))

.PHONY: all help test check sanitize paper explorer gallery docs bench soak install packages format lint asan tsan clang fuzz clean
.DEFAULT_GOAL := all

all:            ## build/whirl
	@$(INSTALL) --check build
	@$(CONFIGURE)
	@$(COMPILE)

help:           ## these lines
	@sed -n 's/^\([a-z ]*\):.*##/  make \1  /p' Makefile

dependencies-%:
	@$(INSTALL) $(subst -, ,$*)

# ---------------------------------------------------------------- tests

# Where tests run by themselves nothing may be left out; a person without a network still gets the rest.
EXPLORER = scripts/explorer.sh $(if $(CI),,--if-possible) $(BUILD)/explorer

test:           ## everything is built, run and proved (about 11 minutes on two cores, 5 more where packages are missing)
	@echo "make test: about 11 minutes on two cores, and 5 more for packages where they are missing"
	@$(INSTALL) build report python test explorer browser docs octave
	cmake --preset release -DWHIRL_TESTS=ON
	cmake --build $(BUILD) --parallel $(JOBS)
	$(EXPLORER)
	ctest --test-dir $(BUILD) -j $(JOBS)

check:          ## the tests of daily work, under a minute once things are built
	@$(INSTALL) --check build report python test
	cmake --preset release -DWHIRL_TESTS=ON
	cmake --build $(BUILD) --parallel $(JOBS)
	ctest --test-dir $(BUILD) -j $(JOBS) -L 'unit|cli' -LE slow --output-on-failure

sanitize: dependencies-build-report-test tsan ## units and commands under the sanitizers, a minute of fuzzing
	cmake --preset asan
	cmake --build $(BUILD)/asan --parallel $(JOBS)
	cmake --preset fuzz
	cmake --build $(BUILD)/fuzz --parallel $(JOBS) --target $(FUZZERS)
	scripts/fuzz.sh $(BUILD)/fuzz 60
	ctest --test-dir $(BUILD)/asan -j $(JOBS) -L 'unit|cli' --no-tests=error

soak: test sanitize clang ## what takes longer: long fuzzing, all tests under the sanitizers, both compilers
	ctest --test-dir $(BUILD)/asan --timeout 7200 -j $(JOBS)
	scripts/fuzz.sh $(BUILD)/fuzz 1800
	tests/soak/kills.sh $(BUILD)/whirl tests/cli/good.yaml 1000
	tests/soak/shards.sh $(BUILD)/whirl cases 1000
	tests/mpi.sh tests/soak/ranks.sh $(BUILD)/whirl cases 300
	tests/memory/no_memory.py $(BUILD)/whirl $(BUILD)/tests/libfailing_malloc.so tests/cli/good.yaml tests/memory/units.xml 0
	tests/soak/long_points.sh $(BUILD)/whirl tests/cli/good.yaml 10
	WHIRL_SOAK=1 ctest --test-dir $(BUILD) --timeout 7200 -j $(JOBS) -R 'verdicts|grazes|readings|model_points|faults|changes'

asan clang: %: dependencies-build-report-test ## all tests in that build
	cmake --preset $*
	cmake --build $(BUILD)/$* --parallel $(JOBS)
	ctest --test-dir $(BUILD)/$* -j $(JOBS) --timeout 3600

tsan: dependencies-build-test ## a threaded study under the thread sanitizer
	cmake --preset tsan -DWHIRL_TESTS=OFF
	cmake --build $(BUILD)/tsan --parallel $(JOBS) --target whirl
	scripts/thread-check.sh $(BUILD)/tsan

fuzz: dependencies-build-test ## the readers are fuzzed for ten minutes
	cmake --preset fuzz
	cmake --build $(BUILD)/fuzz --parallel $(JOBS) --target $(FUZZERS)
	scripts/fuzz.sh $(BUILD)/fuzz 600

# ---------------------------------------------------------------- the paper

PAPER   := $(BUILD)/paper
READINGS := paper paper-literal paper-derived
RESULTS := $(READINGS:%=$(PAPER)/%.h5)

paper:          ## the 2015 paper's study, from its three case files to a report and its explorer (about 6 minutes)
	@echo "make paper: about 6 minutes on two cores, and 5 more for packages where they are missing"
	@$(INSTALL) build report explorer
	@$(CONFIGURE)
	@$(COMPILE)
	@mkdir -p $(PAPER)
	@$(EXPLORER)
	@$(MAKE) --no-print-directory $(PAPER)/report/report.html $(PAPER)/changes/report.html $(PAPER)/map/report.html
	@echo "The report is $(PAPER)/report/report.html"
	@echo "Where and why the motion changes: $(PAPER)/changes/report.html; regimes over two parameters: $(PAPER)/map/report.html"

# A run is done again when its case or the command has changed since. These rules are for `make paper`, which builds
# the command first. One that was interrupted goes on from its journal; its partial result is no target that is made.
.DELETE_ON_ERROR:
$(PAPER)/%.h5: cases/%.yaml $(WHIRL)
	$(WHIRL) run $< -o $@ $(if $(wildcard $@.journal),--resume,--force)

$(PAPER)/report/report.html: $(RESULTS) cases/paper-claims.yaml $(wildcard $(BUILD)/explorer/template.html)
	$(WHIRL) report $(RESULTS) -o $(@D) --claims cases/paper-claims.yaml

$(PAPER)/changes/report.html: $(PAPER)/paper-changes.h5
$(PAPER)/map/report.html: $(PAPER)/paper-map.h5
$(PAPER)/changes/report.html $(PAPER)/map/report.html: $(wildcard $(BUILD)/explorer/template.html)
	$(WHIRL) report $(filter %.h5,$^) -o $(@D)

# ---------------------------------------------------------------- the explorer

explorer: dependencies-build-explorer ## the explorer's engine and page: build/explorer
	scripts/explorer.sh $(BUILD)/explorer

gallery: explorer ## explorers of the example cases: build/gallery
	@$(CONFIGURE)
	@$(COMPILE)
	scripts/gallery.sh $(BUILD)

# ---------------------------------------------------------------- the rest

docs: dependencies-build-report-python-docs ## the documentation as a site that needs no network: build/docs (some three minutes)
	@$(CONFIGURE)
	@$(COMPILE)
	docs/site/build.py $(BUILD)
	@echo "The site is $(BUILD)/docs/index.html"

bench: dependencies-build-report-bench ## measured speed beside other programs; writes docs/benchmarks.md and its picture
	cmake --preset release -DWHIRL_BENCH=ON
	cmake --build $(BUILD) --parallel $(JOBS) --target bench
	bench/run.py $(BUILD) --docs docs

install: all    ## into PREFIX (/usr/local)
	cmake --build $(BUILD) --parallel $(JOBS)
	cmake --install $(BUILD) --prefix $(abspath $(PREFIX))

format: dependencies-lint ## the sources, by clang-format, prettier and black
	clang-format -i $(SOURCES)
	scripts/node-packages.sh
	$(PRETTIER) --write $(SCRIPTS)
	black --quiet bindings/python

lint: dependencies-build-test-lint ## formats, long lines, clang-tidy and cppcheck, without changing anything
	cmake --preset release -DWHIRL_TESTS=ON
	cmake --build $(BUILD) --target build_revision
	scripts/node-packages.sh
	$(PRETTIER) --check $(SCRIPTS)
	black --quiet --check bindings/python
	scripts/long-lines.sh
	scripts/lint.sh $(BUILD) $(SOURCES)

packages: all   ## Debian packages of HEAD in build/package, with lintian; scripts/package-check.sh tries them
	@$(INSTALL) build package explorer
	$(EXPLORER)
	JOBS=$(JOBS) scripts/package.sh $(BUILD)/package $$(find $(BUILD)/explorer -name template.html)

clean:          ## removes what was built
	rm -rf $(BUILD)
