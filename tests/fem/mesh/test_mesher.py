"""The mesher's process: its mesh, and one error for each way to fail."""

import os
import time

import numpy as np
import pytest
import trimesh
from numpy.testing import assert_allclose

from design.errors import SolverError
from fem.mesh import mesher

NOTHING = {"vertices": np.zeros((0, 3))}


def child_that_runs(monkeypatch, code):
    monkeypatch.setattr(mesher, "_CHILD", ("-c", code))


def test_a_block_is_filled_and_nothing_is_left_behind(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    block = trimesh.creation.box((2.0, 1.0, 1.0))
    points, tets = mesher.run_mesher(
        {
            "vertices": np.asarray(block.vertices, float),
            "faces": np.asarray(block.faces, np.int32),
            "edge_length_abs": np.array(0.7),
            "epsilon": np.array(1e-3),
        }
    )
    corner = points[tets]
    volume = abs(np.linalg.det(corner[:, 1:] - corner[:, :1])) / 6
    assert_allclose(volume.sum(), 2.0, rtol=1e-3)
    assert os.listdir(tmp_path) == []


def test_a_crash_is_one_error_that_names_the_signal(monkeypatch):
    child_that_runs(monkeypatch, "import os; os.abort()")
    with pytest.raises(SolverError, match=r"it crashed \(SIGABRT\).*mesh\.envelope_mm"):
        mesher.run_mesher(NOTHING)


def test_what_the_mesher_says_last_stands_in_the_error(monkeypatch):
    child_that_runs(monkeypatch, "import sys; sys.exit('noise\\nno tetrahedra inside')")
    with pytest.raises(SolverError, match="on this body: no tetrahedra inside"):
        mesher.run_mesher(NOTHING)


def test_a_mesher_without_end_is_stopped(monkeypatch, tmp_path):
    """The child would leave a file after its sleep."""
    late = tmp_path / "late"
    child_that_runs(monkeypatch, f"import time; time.sleep(2); open({str(late)!r}, 'w')")
    start = time.monotonic()
    with pytest.raises(SolverError, match=r"did not finish this body in 2 tries of 0\.2 s"):
        mesher.run_mesher(NOTHING, seconds=0.2)
    assert time.monotonic() - start < 1.9
    time.sleep(2.2)
    assert not late.exists()


def test_a_mesher_that_hangs_once_is_asked_again(monkeypatch, tmp_path):
    """pytetwild#47: some calls never end, on bodies that the next call finishes."""
    once = tmp_path / "once"
    child_that_runs(
        monkeypatch,
        "import os, sys, time, numpy\n"
        f"if not os.path.exists({str(once)!r}):\n"
        f"    open({str(once)!r}, 'w').close(); time.sleep(60)\n"
        "numpy.savez(sys.argv[-1], points=numpy.ones((4, 3)), tets=numpy.zeros((1, 4), int))\n",
    )
    points, _ = mesher.run_mesher(NOTHING, seconds=3.0)
    assert points.shape == (4, 3)


def test_vertices_that_are_expected_grow_with_the_cube_of_fineness():
    corners = np.array([[0.0, 0, 0], [6, 0, 0], [0, 6, 0], [0, 0, 6]])
    content = {
        "bg_vertices": corners,
        "bg_tets": np.array([[0, 1, 2, 3]]),
        "edge_length_abs": np.array(9.0),
    }
    coarse, fine = (
        mesher.expected_vertices(content | {"bg_values": np.full(4, edge)}) for edge in (2.0, 1.0)
    )
    assert coarse == pytest.approx(2.2 * 36 / 8)
    assert fine == pytest.approx(8 * coarse)
    assert mesher.expected_vertices(NOTHING) == 0
