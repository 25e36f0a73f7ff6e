"""Which test files go to one process together, and in what order."""

from pathlib import Path

from xdist.scheduler import LoadScopeScheduling

TOGETHER = (
    ("tests/fem/mesh/", "tests/fem/linear/", "tests/fem/contact/", "tests/fem/presses/"),
    ("tests/fem/candidates/",),
    ("tests/estimator/layouts/",),
    ("tests/estimator/deploy/", "tests/instobj/commands/test_predict.py"),
)
"""Folders and files that share meshes and responses of the whole run, or what torch loads to export a
network (3 s): one worker takes all of them."""

LONGEST_FIRST = (
    "tests/fem/",
    "tests/chain/",
    "tests/estimator/layouts/",
    "tests/planted_faults/",
    "tests/instobj/",
    "tests/benchmarks/",
)
"""So that no worker is left with a long file at the end."""


def room_of(path):
    """The folders that go together with that of a test file, or of a test by its name."""
    return next((folders for folders in TOGETHER if path.startswith(folders)), None)


MANY_WORKERS = 8


class FilesAndRooms(LoadScopeScheduling):
    """A worker takes a file at a time, or all folders that share fixtures.

    Of many workers, one would be left with the largest of these rooms: they share by the folder of
    `tests.support.shared` alone.
    """

    def _split_scope(self, nodeid):
        folders = room_of(nodeid) if self.numnodes < MANY_WORKERS else None
        return folders[0] if folders else nodeid.split("::")[0]


def longest_first(nodeid):
    """Rank of a test, then its file: less goes first."""
    ranks = (rank for rank, folder in enumerate(LONGEST_FIRST) if nodeid.startswith(folder))
    return min(ranks, default=len(LONGEST_FIRST)), nodeid.split("::")[0]


def own_turn(folders, worker):
    """The rooms of the folder of all tests, from another one on in every worker.

    Pytest compiles a test file when it is first collected, and finds what another process compiled
    before. Workers that collect in one order compile everything each: 3.5 s of a fresh clone.
    """
    if len(folders) != 1 or not Path(folders[0]).is_dir():
        return folders
    # folders with tests in them, and test files that lie beside them
    rooms = sorted(
        path
        for path in Path(folders[0]).glob("[!_.]*")
        if path.match("test_*.py") or any(path.rglob("test_*.py"))
    )
    begin = int(worker["workerid"].removeprefix("gw")) * len(rooms) // worker["workercount"]
    return [str(room) for room in rooms[begin:] + rooms[:begin]]
