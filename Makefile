# Short names for CMake presets (CMakePresets.json) and scripts. `make help` lists them.

PREFIX ?= /usr/local
JOBS   ?= $(shell nproc)
BUILD  := build
export CMAKE_GENERATOR ?= $(if $(shell command -v ninja),Ninja,Unix Makefiles)
export CTEST_OUTPUT_ON_FAILURE := 1

WHIRL    := $(BUILD)/whirl
INSTALL  := scripts/install-dependencies.sh
# A build folder that exists keeps its options: `make` after `make test` still builds the tests.
CONFIGURE = test -f $(BUILD)/CMakeCache.txt || cmake --preset release -DWHIRL_TESTS=OFF
COMPILE   = cmake --build $(BUILD) --parallel $(JOBS) --target whirl

.PHONY: all help test test-all check sanitize ci soak clang fuzz paper explorer gallery docs bench install packages format lint \
        clean test-steps all-steps check-steps sanitize-steps sanitize-build sanitize-release thread-steps lint-steps
.NOTPARALLEL:
.DEFAULT_GOAL := all

all:            ## build/whirl
	@$(INSTALL) --check build
	@$(CONFIGURE)
	@$(COMPILE)

help:           ## these lines
	@sed -n 's/^\([a-z -]*\):.*##/  make \1  /p' Makefile

dependencies-%:
	@$(INSTALL) $(subst -, ,$*)

# ---------------------------------------------------------------- tests

# In continuous integration (CI) the explorer must be built; elsewhere it is left out if it cannot be built, as without
# a network.
EXPLORER = scripts/explorer.sh $(if $(CI),,--if-possible) $(BUILD)/explorer
# A proof is a sequence of phases; a table at its end shows the time of each.
export PHASES := $(CURDIR)/$(BUILD)/phases.txt
PHASE   := scripts/phase.sh
prove    = @$(PHASE) --begin && $(MAKE) --no-print-directory $(1) && $(PHASE) --table
# BUSY: tests at a time; one more than cores, because tests of browsers and of kills wait.
BUSY = $(shell echo $$(($(JOBS) + 1)))
# LEAVE: label of the tests that a proof leaves out (cmake/testing.cmake). WIDE: instruction set of the sanitized build
# in addition to the portable ones; empty: all.
LEAVE := long
WIDE  := avx2

test:           ## builds everything, and runs all tests that are not long (15 minutes on two cores)
	@echo "make test: 15 minutes on two cores, and 5 more for packages where they are missing"
	$(call prove,test-steps)

test-all:       ## all tests, those of units and commands under the sanitizers, too (two hours on two cores)
	$(call prove,test-steps sanitize-steps LEAVE=none WIDE=)

check:          ## the tests of daily work, four minutes on two cores once things are built
	$(call prove,check-steps)

sanitize:       ## units and commands under the sanitizers, a minute of fuzzing, a threaded study
	$(call prove,sanitize-steps)

ci:             ## what continuous integration runs: all tests, sanitize, and lint (an hour on two cores)
	$(call prove,all-steps sanitize-steps lint-steps)

test-steps:
	@$(PHASE) packages $(INSTALL) build report python test explorer browser docs octave
	@$(PHASE) "build: configure" cmake --preset release -DWHIRL_TESTS=ON
	@$(PHASE) "build: compile" cmake --build $(BUILD) --parallel $(JOBS)
	@$(PHASE) "build: explorer" $(EXPLORER)
	@$(PHASE) tests ctest --test-dir $(BUILD) -j $(BUSY) -LE '^($(LEAVE))$$'

all-steps: LEAVE := none
all-steps: test-steps

check-steps:
	@$(INSTALL) --check build report python test
	@$(PHASE) "build: configure" cmake --preset release -DWHIRL_TESTS=ON
	@$(PHASE) "build: compile" cmake --build $(BUILD) --parallel $(JOBS)
	@$(PHASE) "tests: layers and circles" ctest --test-dir $(BUILD) -j $(JOBS) -R '^architecture'
	@$(PHASE) "tests: units and commands" ctest --test-dir $(BUILD) -j $(JOBS) -L 'unit|cli' -LE long

sanitize-steps: sanitize-build thread-steps
	@$(PHASE) "sanitized: a minute of fuzzing" scripts/fuzz.sh $(BUILD)/sanitize 60
	@$(PHASE) "sanitized: tests" ctest --test-dir $(BUILD)/sanitize -j $(BUSY) -L 'unit|cli|compilers' -LE '^($(LEAVE))$$' --no-tests=error

# Both builds by sanitizers reuse the release's object of Eigen's part of the library. The build for the thread
# sanitizer also reuses layers without threads.
sanitized = -DWHIRL_OTHER=$(CURDIR)/$(BUILD)
ALONE    := report;import

sanitize-release:
	@$(PHASE) packages $(INSTALL) build report test
	@$(CONFIGURE)
	@cmake --build $(BUILD) --parallel $(JOBS) --target whirl_base >/dev/null

sanitize-build: sanitize-release
	@$(PHASE) "sanitized: configure" cmake --preset sanitize $(sanitized) "-DWHIRL_WIDE=$(WIDE)"
	@$(PHASE) "sanitized: compile" cmake --build $(BUILD)/sanitize --parallel $(JOBS)

thread-steps: sanitize-release
	@cmake --build $(BUILD) --parallel $(JOBS) --target $(addprefix whirl_,$(subst ;, ,$(ALONE))) >/dev/null
	@$(PHASE) "threads: configure" cmake --preset threads $(sanitized) "-DWHIRL_TAKEN=$(ALONE)"
	@$(PHASE) "threads: compile" cmake --build $(BUILD)/threads --parallel $(JOBS) --target whirl
	@$(PHASE) "threads: studies under the thread sanitizer" scripts/thread-check.sh $(BUILD)/threads

soak: test-all clang ## what takes longer: long fuzzing, all tests under the sanitizers, both compilers
	cmake --build $(BUILD)/sanitize --parallel $(JOBS) --target validation determinism
	ctest --test-dir $(BUILD)/sanitize --timeout 7200 -j $(JOBS)
	scripts/fuzz.sh $(BUILD)/sanitize 1800
	tests/soak/kills.sh $(BUILD)/whirl tests/cli/good.yaml 1000
	tests/determinism/tables.sh $(BUILD)/whirl cases 200 4
	tests/soak/shards.sh $(BUILD)/whirl cases 1000
	tests/mpi.sh tests/soak/ranks.sh $(BUILD)/whirl cases 300
	tests/memory/out_of_memory.py $(BUILD)/whirl $(BUILD)/tests/libfailing_malloc.so tests/cli/good.yaml tests/memory/units.xml 0
	tests/soak/mutants.py $(BUILD)/sanitize/whirl 40 $(filter-out %-claims.yaml,$(wildcard cases/*.yaml))
	tests/soak/long_points.sh $(BUILD)/whirl tests/cli/good.yaml 10
	WHIRL_SOAK=1 ctest --test-dir $(BUILD) --timeout 7200 -j $(JOBS) -R 'verdicts|grazes|readings|model_points|faults|changes|invariant|test_fit|orbits_in_sweeps'

clang: dependencies-build-report-test ## all tests in a build by clang
	cmake --preset clang
	cmake --build $(BUILD)/clang --parallel $(JOBS)
	ctest --test-dir $(BUILD)/clang -j $(JOBS) --timeout 3600

fuzz: sanitize-build ## the readers are fuzzed for ten minutes
	scripts/fuzz.sh $(BUILD)/sanitize 600

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

# A run is done again when its case or the command has changed since. These rules are for `make paper`, which builds the
# command first. An interrupted run continues from its journal; make deletes its partial result.
.DELETE_ON_ERROR:
$(PAPER)/%.h5: cases/%.yaml $(WHIRL)
	$(WHIRL) run $< -o $@ $(if $(wildcard $@.journal),--resume,--force)

$(PAPER)/report/report.html: $(RESULTS) cases/paper-claims.yaml $(wildcard $(BUILD)/explorer/template.html)
	$(WHIRL) report $(RESULTS) -o $(@D) --claims cases/paper-claims.yaml --force

$(PAPER)/changes/report.html: $(PAPER)/paper-changes.h5
$(PAPER)/map/report.html: $(PAPER)/paper-map.h5
$(PAPER)/changes/report.html $(PAPER)/map/report.html: $(wildcard $(BUILD)/explorer/template.html)
	$(WHIRL) report $(filter %.h5,$^) -o $(@D) --force

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
	@$(COMPILE) whirl_shared
	docs/site/build.py $(BUILD)
	@echo "The site is $(BUILD)/docs/index.html"

bench: dependencies-build-report-bench ## measured speed compared with other programs; writes docs/benchmarks.md and its picture
	@$(CONFIGURE)
	cmake $(BUILD) -DWHIRL_BENCH=ON
	cmake --build $(BUILD) --parallel $(JOBS) --target bench
	bench/run.py $(BUILD) --docs docs $(BENCH_OPTIONS)

# CMake looks again for what was installed since the build was configured, such as Octave's compiler.
install: all    ## into PREFIX (/usr/local)
	cmake $(BUILD) >/dev/null
	cmake --build $(BUILD) --parallel $(JOBS)
	cmake --install $(BUILD) --prefix $(abspath $(PREFIX))

format: dependencies-lint ## the sources, by clang-format, prettier and black
	git ls-files '*.c' '*.cc' '*.h' | xargs clang-format -i
	scripts/node-packages.sh
	git ls-files 'explorer/*.ts' 'explorer/*.mjs' | xargs explorer/node_modules/.bin/prettier --log-level warn --write
	black --quiet bindings/python

lint:           ## formats, long lines, clang-tidy and cppcheck of all sources, without changing anything
	$(call prove,lint-steps)

# Compilers and linters read the same sources: the generated headers are made first.
lint-steps:
	@$(INSTALL) build test lint
	@cmake --preset release -DWHIRL_TESTS=ON >/dev/null
	@cmake --build $(BUILD) --target build_revision >/dev/null
	@scripts/node-packages.sh
	@$(PHASE) lint scripts/lint.sh $(BUILD)

packages: all   ## Debian packages of HEAD in build/package, with lintian; scripts/package-check.sh tries them
	@$(INSTALL) build package explorer python
	$(EXPLORER)
	JOBS=$(JOBS) scripts/package.sh $(BUILD)/package $$(find $(BUILD)/explorer -name template.html)

clean:          ## removes what was built
	rm -rf $(BUILD)
