# Two commands for a newcomer: `make demo` and `make test`. Each installs what it needs, once.
PYTHON ?= python3
PIP_ARGS ?=
BIN := .venv/bin
INSTALLED := .venv/.installed

.PHONY: demo test test-slow test-rounding verify lint docs install clean

demo: $(INSTALLED)
	$(BIN)/instobj run --workers 2 examples/paper_cube.toml

# Each process on one thread: solvers that share threads wait for each other. Three on two cores, as
# tests of boards, browsers and commands wait for them. Compiled modules are kept for the next run;
# tests/support/scheduling.py says which files go to one process together. Memory that is freed stays
# with the process (glibc): fetching it anew takes a tenth of the time of the mechanics' tests.
KEEP_MEMORY := MALLOC_MMAP_MAX_=0 MALLOC_TRIM_THRESHOLD_=8589934592
PYTEST := PYTHONDONTWRITEBYTECODE= OMP_NUM_THREADS=1 MKL_NUM_THREADS=1 $(KEEP_MEMORY) \
	$(BIN)/pytest -q -n 3 --dist loadfile

test: $(INSTALLED)
	$(PYTEST)

test-slow: $(INSTALLED)
	INSTOBJ_TESTS_MESHES=anew $(PYTEST) -m slow

# Once per release: hours, of one core; the table goes into benchmarks/results and its measured page.
test-rounding: $(INSTALLED)
	$(BIN)/python -m tests.rounding; status=$$?; $(BIN)/python docs/measured.py; exit $$status

verify: $(INSTALLED)
	INSTOBJ_TESTS_MESHES=anew $(BIN)/pytest -q -m "slow or not slow" tests/fem/verification/test_verification.py --verification-page docs/verification

lint: $(INSTALLED)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/basedpyright
	$(BIN)/lint-imports

# The site, in docs/_build/html; INSTOBJ_GALLERY=full runs the gallery on objects of full size.
docs: .venv/.docs
	OMP_NUM_THREADS=1 MKL_NUM_THREADS=1 $(BIN)/sphinx-build -W --keep-going -q -b html docs docs/_build/html
	@echo "open docs/_build/html/index.html"

.venv/.docs: $(INSTALLED)
	$(BIN)/pip install --disable-pip-version-check $(PIP_ARGS) -c constraints.txt -e '.[docs]'
	@touch $@

install: $(INSTALLED)

$(INSTALLED): pyproject.toml constraints.txt
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
		{ echo "instobj needs Python 3.11 or newer; set PYTHON=/path/to/python3.11"; exit 1; }
	$(PYTHON) -m venv .venv
	$(BIN)/pip install --disable-pip-version-check $(PIP_ARGS) -c constraints.txt -e '.[test]'
	@touch $@

clean:
	rm -rf .venv .instobj runs cad_out/*/ docs/_build docs/gallery docs/reference/generated
