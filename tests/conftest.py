"""Types, what the processes of a run share, and how tests go to them."""

import ctypes
import gc
import os
import shutil
import sys
import tempfile
from pathlib import Path

import pytest

gc.disable()  # until all is imported: modules are no garbage

from tests.support import in_memory, scheduling, typechecks  # noqa: E402

in_memory.install()
_BRINGUP = [
    f"instobj.bench.bringup.{part}" for part in ("asking", "diagnosis", "simulated", "verdict")
]
"""What a bring-up works out; its dialogue and files are types of the command line."""
typechecks.install(["design", "fem", "estimator", "studies", *_BRINGUP])

from instobj.figures import saving  # noqa: E402  types are checked in what is imported from here
from instobj.render import raster  # noqa: E402
from tests.support import recorded_meshes  # noqa: E402

recorded_meshes.install()
saving.DPI = 60  # pictures in full take a minute of a run
raster.PIXELS = 400
os.fsync = lambda descriptor: None  # searches wait for the disk at every trial

VERIFICATION_OUTCOMES = pytest.StashKey[list]()


def pytest_runtest_setup():
    typechecks.next_test()


def pytest_addoption(parser):
    parser.addoption(
        "--verification-page",
        metavar="DIR",
        type=Path,
        help="write the table and figures of tests/fem/verification/test_verification.py into this folder",
    )


def pytest_configure(config):
    config.stash[VERIFICATION_OUTCOMES] = []
    if not hasattr(config, "workerinput"):
        shared = tempfile.mkdtemp(prefix="instobj_tests_")
        os.environ["INSTOBJ_TESTS_SHARED"] = shared  # for `tests.support.shared`, in all workers
        os.environ["XDG_STATE_HOME"] = shared  # not the list of files that the user wrote
        config.add_cleanup(lambda: shutil.rmtree(shared, ignore_errors=True))
    else:
        config.args = scheduling.own_turn(config.args, config.workerinput)


def pytest_collection_finish():
    gc.freeze()
    gc.set_threshold(20_000, 20, 50)  # a full search takes 0.3 s; tests left little to be found
    gc.enable()


MOST_LEFT_BYTES = 300_000_000
"""Growth of a process before it looks for what is unused: 0.1 s for each of 500 files."""
_resident_bytes = 0


def _resident() -> int:
    """Return the memory (bytes) that this process has, on Linux."""
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE")


def pytest_runtest_teardown(item, nextitem):
    """Give back what files of tests left in memory: `make test` has glibc keep what is freed, and three
    processes would keep several gigabytes each."""
    global _resident_bytes
    if sys.platform != "linux" or (nextitem is not None and nextitem.path == item.path):
        return
    if _resident() > _resident_bytes + MOST_LEFT_BYTES:
        gc.collect()
        ctypes.CDLL(None).malloc_trim(0)
        _resident_bytes = _resident()


@pytest.fixture
def verification_outcomes(request):
    """Outcomes of checks, written as a page when the run ends."""
    return request.config.stash[VERIFICATION_OUTCOMES]


def pytest_sessionfinish(session):
    folder = session.config.getoption("--verification-page")
    outcomes = session.config.stash[VERIFICATION_OUTCOMES]
    if folder and outcomes:
        from tests.support.verification.proof import write_page

        write_page(outcomes, folder)


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config, log):
    config.option.loadscopereorder = False
    return scheduling.FilesAndRooms(config, log)


def pytest_collection_modifyitems(items):
    items.sort(key=lambda item: scheduling.longest_first(item.nodeid))
