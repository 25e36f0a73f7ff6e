"""Files of bodies that others wrote: damaged ones are one error, whatever their parser does."""

import os
import sys
from pathlib import Path

import cadquery as cq
import numpy as np
import pytest
import trimesh
from numpy.testing import assert_allclose

import design.body.foreign
from design.body.foreign import read_foreign_surface
from design.errors import InputError
from design.layout import stl_tip
from design.layout.stl_tip import stl_tip_vertices_mm

MISSING = "nothing there"


LIKE_STL = [pytest.param(suffix, marks=pytest.mark.slow) for suffix in ("ply", "obj", "off")]


@pytest.mark.parametrize("suffix", ["stl", "step", *LIKE_STL])
def test_the_surface_is_the_one_in_the_file(suffix, tmp_path):
    path = tmp_path / f"brick.{suffix}"
    if suffix == "step":
        cq.exporters.export(cq.Workplane().box(10, 20, 30), str(path))
    else:
        trimesh.creation.box((10, 20, 30)).export(path)
    found = read_foreign_surface(path, MISSING)
    surface = trimesh.Trimesh(found.vertices_mm, found.triangles)
    assert_allclose(surface.extents, (10, 20, 30), atol=1e-6)
    assert_allclose(surface.volume, 6000, rtol=1e-6)


READERS = {
    "crash": "import os, signal; os.kill(os.getpid(), signal.SIGSEGV)",
    "hang": "import time; time.sleep(60)",
    "memory": "x = bytearray(12 * 2**30)",
}


@pytest.mark.parametrize(
    ("fault", "said"),
    [("crash", "SIGSEGV"), ("hang", "not read within 2 s"), ("memory", "8 GiB of memory")],
)
def test_a_reader_that_crashes_hangs_or_fills_the_memory_is_one_error(
    fault, said, tmp_path, monkeypatch
):
    if fault == "memory" and sys.platform != "linux":
        pytest.skip("the limit of memory is kept on Linux alone")
    (tmp_path / f"{fault}_reader.py").write_text(READERS[fault])
    monkeypatch.setenv("PYTHONPATH", str(tmp_path))
    monkeypatch.setattr(design.body.foreign, "READER", f"{fault}_reader")
    path = tmp_path / "body.stl"
    path.write_text("solid")
    with pytest.raises(InputError, match=said):
        read_foreign_surface(path, MISSING, seconds=2.0 if fault == "hang" else 60.0)


def test_step_files_with_wrong_references_never_end_the_program(tmp_path):
    """Wrong entity references ended the whole program with SIGSEGV in 2 of 20 mutants."""
    whole = tmp_path / "brick.step"
    cq.exporters.export(cq.Workplane().box(10, 20, 30), str(whole))
    lines = whole.read_text().splitlines()
    starts = [k for k, line in enumerate(lines) if line.startswith("#")]
    rng, answers = np.random.default_rng(5), []
    for mutant in range(2):
        changed = list(lines)
        for k in rng.choice(starts, 40, replace=False):
            head, equals, body = changed[k].partition("=")
            numbers = [str(rng.integers(1, len(starts))) for _ in range(body.count("#"))]
            pieces = body.split("#")
            body = pieces[0] + "".join(
                "#" + number + piece.lstrip("0123456789")
                for number, piece in zip(numbers, pieces[1:], strict=True)
            )
            changed[k] = head + equals + body
        path = tmp_path / f"mutant{mutant}.step"
        path.write_text("\n".join(changed))
        answers.append(_answer(path))
    assert len(answers) == 2
    assert all("Export" in answer or answer.isdigit() for answer in answers)


def _answer(path):
    try:
        return str(len(read_foreign_surface(path, MISSING).triangles))
    except InputError as error:
        return str(error)


def test_what_is_no_file_is_said(tmp_path):
    os.mkfifo(tmp_path / "pipe.stl")
    for name, said in (
        ("none.stl", MISSING),
        ("pipe.stl", "a pipe, socket or device"),
        (".", "a folder"),
        ("x" * 300 + ".stl", "File name too long"),
        ("a\0b.stl", "not a file name"),
    ):
        with pytest.raises(InputError, match=said):
            read_foreign_surface(tmp_path / name, MISSING)
    with pytest.raises(InputError, match=r"no indenter\.vertices_mm"):
        stl_tip_vertices_mm(tmp_path / "none.stl")


def test_a_tip_of_any_size_is_closed_and_outward(monkeypatch):
    """A wedge of 0.012 mm³ and of 12 cm³, inside out, and torn; corners to a millionth."""
    corners = np.array([[x, y, z] for x in (0, 0.3) for y in (-0.1, 0.1) for z in (0.0, 0.4)])[
        [0, 1, 2, 3, 4, 6]
    ]
    wedge = trimesh.convex.convex_hull(corners)
    torn, inverted = wedge.copy(), wedge.copy()
    torn.update_faces(np.arange(len(torn.faces) - 1))
    inverted.invert()

    def told(mesh):
        monkeypatch.setattr(stl_tip, "read_stl_tip", lambda path: mesh)
        return np.array(stl_tip_vertices_mm(Path("tip.stl")))

    assert wedge.volume == pytest.approx(0.012)
    for scale in (1.0, 100.0):
        found, wanted = told(wedge.copy().apply_scale(scale)), scale * corners
        assert_allclose(found[np.lexsort(found.T)], wanted[np.lexsort(wanted.T)], atol=1e-9)
    exact = told(wedge.copy().apply_translation([1 / 3, 0, 0]))
    assert set(exact[:, 0]) == {0.333333, 0.633333}
    for mesh in (torn, inverted):
        with pytest.raises(InputError, match="not closed with its normals outward"):
            told(mesh)
