# Everything from a fresh Debian 12 machine: each target installs what it needs and is missing.
BIN := build/release/bin
VALVE := examples/valves/bodyparts3d-leaking.json
FUZZ := -runs=100000 -seed=1 -dict=tests/fuzz/json.dict
SOURCES := $(shell find core search io server clients/cli tests bench -name "*.h" -o -name "*.cpp" -o -name "*.inl")

WEB := clients/web
WEB_SOURCES := $(shell find $(WEB)/src $(WEB)/public $(WEB)/index.html $(WEB)/vite.config.ts -type f)

.PHONY: help demo serve test web web-test web-pictures chart bench bench-server instructions rivals build programs configure format format-check includes-check openapi-check readers-check asan fuzz clean

help:  ## this list
	@grep -E '^[a-z-]+:.*##' Makefile | sed -E 's/^([a-z-]+):.*## (.*)/  make \1\t\2/' | expand -t 24

demo: programs  ## ranked repair plans for a leaking valve of real human anatomy, with pictures
	@mkdir -p out
	$(BIN)/coapt close $(VALVE) --render out/leaking.png || [ $$? -eq 3 ]
	$(BIN)/coapt plan $(VALVE) --evaluations 600 --seed 1 --plans 3 -o out/report.html || [ $$? -eq 4 ]
	@echo "Pictures: out/leaking.png and out/report.html (open it in a browser)"

serve: programs web  ## the service with its page at http://127.0.0.1:8080
	@echo "Open http://127.0.0.1:8080 in a browser; Ctrl-C ends it."
	$(BIN)/coapt-server --db coapt.sqlite

test: build  ## build and run every test
	@cmake/install_packages.sh test
	ctest --preset release --parallel 2

web: build/web/index.html  ## the page, in build/web

build/web/index.html: $(WEB)/node_modules $(WEB_SOURCES)
	cd $(WEB) && npx --no-install vite build
	@touch $@

$(WEB)/node_modules: $(WEB)/package-lock.json
	@command -v npm >/dev/null || cmake/install_packages.sh npm
	npm ci --ignore-scripts --no-audit --no-fund --prefix $(WEB)
	@touch $@

web-test: build web  ## types, unit tests, and the page in a real browser with axe-core
	@cmake/install_packages.sh browser
	cd $(WEB) && npx --no-install tsc --noEmit && npx --no-install vitest run
	node --test --test-reporter=spec $(WEB)/test/page/*.test.mjs

web-pictures: programs web  ## the page's pictures in docs/images, and its times
	@cmake/install_packages.sh browser
	node $(WEB)/test/page/pictures.mjs docs/images
	node $(WEB)/test/page/times.mjs

chart: programs  ## accuracy against time, where methods fail, what the model's ingredients buy, into docs/images
	$(BIN)/coapt chart speed-accuracy -o docs/images
	$(BIN)/coapt chart stability -o docs/images
	$(BIN)/coapt chart ablation -o docs/images

bench: build  ## time of the parts of a closure, and of whole ones against method thesis
	$(BIN)/closure_benchmark

bench-server: build  ## what the service adds to a closure, watching jobs under load, hostile requests
	@cmake/install_packages.sh test bench
	bench/server/closures.py
	bench/server/jobs_under_load.py
	bench/server/hostile.py --requests 1000 --seconds 180

instructions: build  ## machine instructions of a closure by function, where clocks are noisy
	@cmake/install_packages.sh profile
	bench/instructions.sh

rivals:  ## coapt-rivals, the optimisers of pagmo and dlib that the search is measured against
	@cmake/install_packages.sh build rivals
	cmake --preset release -DCOAPT_RIVALS=ON
	cmake --build --preset release --target coapt-rivals

build: configure  ## the release build in build/release: programs, tests, benchmarks
	cmake --build --preset release

programs: configure  ## coapt and coapt-server alone
	cmake --build --preset release --target coapt coapt-server

configure:
	@cmake/install_packages.sh build
	cmake --preset release

format:  ## lay the sources out with clang-format
	@cmake/install_packages.sh format
	@clang-format -i $(SOURCES)

format-check:  ## fail if clang-format would change something
	@cmake/install_packages.sh format
	@clang-format --dry-run --Werror $(SOURCES)

includes-check:  ## fail if an include goes against the arrows of ARCHITECTURE.md
	cmake/check_includes.sh

openapi-check: build/openapi-check/node_modules  ## fail if the OpenAPI document breaks a rule that @redocly/cli recommends
	@cmake -D OUTPUT=build/openapi.json -P server/openapi.cmake
	@REDOCLY_TELEMETRY=off REDOCLY_SUPPRESS_UPDATE_NOTICE=true \
	  $</.bin/redocly lint --config server/openapi-check/redocly.yaml build/openapi.json

build/openapi-check/node_modules: server/openapi-check/package-lock.json
	@command -v cmake >/dev/null || cmake/install_packages.sh build
	@command -v npm >/dev/null || cmake/install_packages.sh npm
	@mkdir -p build/openapi-check
	@cp server/openapi-check/package*.json build/openapi-check/
	npm ci --ignore-scripts --no-audit --no-fund --prefix build/openapi-check
	@touch $@

readers-check: build build/readers-check/node_modules  ## fail if VTK, the glTF validator or another reader finds a file of coapt wrong
	@cmake/install_packages.sh readers
	tests/readers/check_files.py $(BIN)/coapt env NODE_PATH=build/readers-check/node_modules node tests/readers/validate_glb.js

build/readers-check/node_modules: tests/readers/package-lock.json
	@command -v npm >/dev/null || cmake/install_packages.sh npm
	@mkdir -p build/readers-check
	@cp tests/readers/package*.json build/readers-check/
	npm ci --ignore-scripts --no-audit --no-fund --prefix build/readers-check
	@touch $@

asan:  ## build and test with the address and undefined-behaviour sanitizers, but the long tests
	@cmake/install_packages.sh build test
	cmake --preset asan
	cmake --build --preset asan
	ctest --preset asan --parallel 2 --label-exclude long

fuzz:  ## 100,000 damaged valves, plans and requests each through readers and endpoints, under the sanitizers
	@cmake/install_packages.sh build fuzz
	cmake --preset fuzz
	cmake --build --preset fuzz --target fuzz_read_valve fuzz_read_plan fuzz_endpoints fuzz_seeds
	build/fuzz/bin/fuzz_seeds build/fuzz/corpus
	build/fuzz/bin/fuzz_read_valve $(FUZZ) build/fuzz/corpus/valve
	build/fuzz/bin/fuzz_read_plan $(FUZZ) build/fuzz/corpus/plan
	TMPDIR=/dev/shm build/fuzz/bin/fuzz_endpoints $(FUZZ) build/fuzz/corpus/endpoints

clean:  ## remove what was built
	rm -rf build out
