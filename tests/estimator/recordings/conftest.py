"""The same presses as a gripper file and as a generic CSV, without and with tangential forces."""

import pytest

from estimator.recordings.formats.files import read_table
from tests.support.recordings.generic_csv import with_shear, write_generic_csv
from tests.support.recordings.made_recordings import gripper_arrays, write_gripper

CASES = ((54, 57), (23, 28))


@pytest.fixture(scope="module")
def gripper(tmp_path_factory):
    return write_gripper(tmp_path_factory.mktemp("g") / "g.csv", gripper_arrays(CASES), CASES)


@pytest.fixture(scope="module")
def table(gripper):
    return read_table(gripper)


@pytest.fixture(scope="module")
def good(table, tmp_path_factory):
    """A short CSV of two load cells, one tip each."""
    path = tmp_path_factory.mktemp("c") / "good.csv"
    write_generic_csv(table, path)
    return path.read_text()


@pytest.fixture(scope="module")
def sheared(table, tmp_path_factory):
    """The short CSV with tangential forces."""
    path = tmp_path_factory.mktemp("s") / "sheared.csv"
    write_generic_csv(with_shear(table), path)
    return path.read_text()
