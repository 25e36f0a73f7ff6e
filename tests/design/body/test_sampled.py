"""Distances to a surface that is alike in all octants, measured in one of them."""

from numpy.testing import assert_allclose

from design.body import sampled
from design.body.kinds.ellipsoid import Ellipsoid


class Everywhere(Ellipsoid):
    """An ellipsoid measured at every point."""

    mirrored = False


def test_distances_to_an_ellipsoid_are_measured_in_one_octant(monkeypatch):
    """18 of them took 79 s where `instobj new` looks for a size that works."""
    measured, plain = [], sampled.measured_distance_mm

    def counting(surface, points_mm):
        measured.append(len(points_mm))
        return plain(surface, points_mm)

    monkeypatch.setattr(sampled, "measured_distance_mm", counting)
    monkeypatch.setattr(sampled, "_GRID_POINTS", 6_000)
    size, everywhere = (32.0, 26.0, 40.0), []
    for kind in (Ellipsoid, Everywhere):
        everywhere.append(sampled._field.__wrapped__(kind(size, 0.0, 0.5)).coefficients)
    assert_allclose(everywhere[0], everywhere[1], rtol=0, atol=1e-9)
    (coarse, octant), (_, whole) = measured[:2], measured[2:]
    assert octant < whole / 5
    assert coarse < whole / 5
