"""What a caller can tell apart: a bad specification, recording, stored result, failed solve."""

import numpy as np
import pytest
import scipy.sparse as sp

from design.errors import InputError, RecordingError, SolverError, SpecError, StoreError
from design.files import atomic_path
from design.processes import reason_of
from design.spec_io import load_spec
from estimator.frames.dataset import load_frames
from estimator.recordings.formats.files import read_table
from fem.linear.factorization import solve_symmetric


def bad_specification(folder):
    (folder / "cube.toml").write_text('name = "cube"\nshell = { thickness_mm = "thick" }')
    load_spec(folder / "cube.toml")


def damaged_recording(folder):
    (folder / "1probe.csv").write_text("time_s,F1-X1\n0,1\n1,2,3\n")
    read_table(folder / "1probe.csv")


def damaged_result(folder):
    (folder / "frames.nc").write_bytes(b"\x89HDF\r\n\x1a\n" + bytes(500))
    load_frames(folder / "frames.nc")


def unwritable_folder(folder):
    (folder / "file").write_text("")
    with atomic_path(folder / "file" / "frames.nc"):
        pass


def folder_in_place_of_the_file(folder):
    (folder / "frames.nc").mkdir()
    with atomic_path(folder / "frames.nc"):
        pass


def singular_system(folder):
    solve_symmetric(sp.csr_matrix((4, 4)), np.ones((4, 1)))


@pytest.mark.parametrize(
    ("fault", "kind", "builtin"),
    [
        (bad_specification, SpecError, ValueError),
        (damaged_recording, RecordingError, ValueError),
        (damaged_result, StoreError, OSError),
        (unwritable_folder, StoreError, OSError),
        (folder_in_place_of_the_file, StoreError, OSError),
        (singular_system, SolverError, ArithmeticError),
    ],
)
def test_each_fault_has_its_kind_and_python_s_own_class(tmp_path, fault, kind, builtin):
    with pytest.raises(builtin) as caught:
        fault(tmp_path)
    assert isinstance(caught.value, kind)
    assert isinstance(caught.value, InputError) == (builtin is ValueError)


@pytest.mark.parametrize(
    ("fault", "said"),
    [
        (unwritable_folder, "/file is a file, not a folder. Choose a writable folder with --out"),
        (folder_in_place_of_the_file, "frames.nc: a folder of that name is there. Choose"),
    ],
)
def test_what_is_in_the_way_of_a_file_is_named_and_nothing_is_left(tmp_path, fault, said):
    with pytest.raises(StoreError) as caught:
        fault(tmp_path)
    assert said in str(caught.value)
    assert len(list(tmp_path.iterdir())) == 1


def test_the_path_of_a_recording_stands_once_before_what_is_wrong_in_it(tmp_path):
    with pytest.raises(RecordingError) as caught:
        damaged_recording(tmp_path)
    path = str(tmp_path / "1probe.csv")
    assert str(caught.value).startswith(f"{path}: it lacks the columns cell1_force_n")
    assert str(caught.value).count(path) == 1


@pytest.mark.parametrize(
    ("code", "said", "memory_gib", "reason"),
    [
        (1, "one\ntwo\nthree: it is wrong\n", None, "three: it is wrong"),
        (3, " \n", None, "it ended with code 3"),
        (-11, "anything", None, "it crashed (SIGSEGV)"),
        (1, "x\nMemoryError", 2.5, "it needs more than 2.5 GiB of memory"),
        (1, "x\nMemoryError", None, "MemoryError"),
    ],
)
def test_why_a_process_ended_is_its_last_line(code, said, memory_gib, reason):
    assert reason_of(code, said, memory_gib) == reason
