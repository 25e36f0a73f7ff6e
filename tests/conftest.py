"""Types, what the processes of a run share, and which files go to one process together."""

import os
import shutil
import tempfile
from pathlib import Path

import pytest
from xdist.scheduler import LoadScopeScheduling

from tests.support import typechecks

typechecks.install(["design", "fem", "estimator"])

from instobj.figures import saving  # noqa: E402  types are checked in what is imported from here
from instobj.render import parts  # noqa: E402
from tests.support import recorded_meshes  # noqa: E402

recorded_meshes.install()
saving.DPI = 60  # pictures in full take a minute of a run
parts.PIXELS = 400

TOGETHER = (
    ("tests/fem/mesh/", "tests/fem/linear/", "tests/fem/contact/", "tests/fem/presses/"),
    ("tests/fem/candidates/",),
    ("tests/estimator/layouts/",),
)
"""Folders whose files share meshes and responses of the whole run: one worker takes all of them."""

LONGEST_FIRST = ("tests/fem/", "tests/chain/", "tests/instobj/", "tests/benchmarks/")
"""So that no worker is left with a long file at the end."""

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
        config.add_cleanup(lambda: shutil.rmtree(shared, ignore_errors=True))


@pytest.fixture
def verification_outcomes(request):
    """Outcomes of checks, written as a page when the run ends."""
    return request.config.stash[VERIFICATION_OUTCOMES]


def pytest_sessionfinish(session):
    folder = session.config.getoption("--verification-page")
    outcomes = session.config.stash[VERIFICATION_OUTCOMES]
    if folder and outcomes:
        from tests.support.verification import write_page

        write_page(outcomes, folder)


class _FilesAndRooms(LoadScopeScheduling):
    """A worker takes a file at a time, or all folders that share fixtures."""

    def _split_scope(self, nodeid):
        rooms = (folders[0] for folders in TOGETHER if nodeid.startswith(folders))
        return next(rooms, nodeid.split("::")[0])


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config, log):
    config.option.loadscopereorder = False
    return _FilesAndRooms(config, log)


def pytest_collection_modifyitems(items):
    ranks = {folder: rank for rank, folder in enumerate(LONGEST_FIRST)}

    def rank(item):
        return min((r for f, r in ranks.items() if item.nodeid.startswith(f)), default=len(ranks))

    items.sort(key=rank)
