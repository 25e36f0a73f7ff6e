"""The reader of foreign files, in this process: STEP files and clouds of points by hand."""

import cadquery as cq
import numpy as np
import pytest
import trimesh
from numpy.testing import assert_allclose

from design.solids.foreign import main, solid_of_mesh, solid_of_step


def written(folder, shape):
    path = folder / "part.step"
    cq.exporters.export(cq.Workplane(obj=shape), str(path))
    return path


def test_solids_of_a_step_file_are_closed_placed_and_turned_outwards(tmp_path):
    brick = cq.Solid.makeBox(10, 20, 30)
    ball = cq.Solid.makeSphere(5.0, cq.Vector(), cq.Vector(0, 0, 1), -90, 90, 360)
    both = cq.Compound.makeCompound([brick, ball.moved(cq.Location(cq.Vector(40, -7, 3)))])
    surface = trimesh.Trimesh(*solid_of_step(written(tmp_path, both)))
    one, other = sorted(surface.split(), key=lambda piece: -piece.volume)
    assert one.volume == pytest.approx(6000)
    assert_allclose(one.bounds, [[0, 0, 0], [10, 20, 30]], atol=1e-9)
    assert other.volume == pytest.approx(4 / 3 * np.pi * 125, rel=0.02)
    assert_allclose(other.bounds.mean(axis=0), [40, -7, 3], atol=0.04)


def test_what_has_no_surface_has_no_triangles(tmp_path):
    edge = cq.Edge.makeLine(cq.Vector(0, 0, 0), cq.Vector(1, 2, 3))
    trimesh.PointCloud(np.eye(3)).export(tmp_path / "cloud.ply")
    for found in (solid_of_step(written(tmp_path, edge)), solid_of_mesh(tmp_path / "cloud.ply")):
        assert [part.shape for part in found] == [(0, 3), (0, 3)]


@pytest.mark.parametrize(("long_mm", "code"), [(1999.9, 0), (2000.1, 1)])
def test_a_solid_of_more_than_two_metres_is_refused(tmp_path, capsys, long_mm, code):
    path, out = written(tmp_path, cq.Solid.makeBox(long_mm, 1, 1)), tmp_path / "out.npz"
    assert main(str(path), str(out)) == code
    assert out.exists() is not bool(code)
    assert ("it is 2 m long, more than 2 m" in capsys.readouterr().err) is bool(code)
