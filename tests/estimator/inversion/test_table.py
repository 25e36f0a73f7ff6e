"""Tables of presses as splines: polynomials come back exactly, beyond the deepest press on a line."""

from types import SimpleNamespace

import numpy as np
from numpy.testing import assert_allclose

from design.layout.places.contact_grid import PlaceGrid
from estimator.inversion.model import table
from estimator.signals.interpolation import Traces

GRID = PlaceGrid(np.array([-6.0, -3.0, 0.0, 3.0, 6.0]), np.array([-4.0, -1.0, 2.0, 5.0]))
FORCE_N = np.linspace(np.sqrt(0.5), np.sqrt(9.5), 14) ** 2 - 0.5


def polynomial(x, y, force):
    """Two channels, cubic in x, y and the shifted root of the force, with their derivatives."""
    root = np.sqrt(force + 0.5) - np.sqrt(0.5)
    slope = 0.5 / np.sqrt(force + 0.5)
    a, ax = x**3 - 2 * x, 3 * x**2 - 2
    b, by = 1 + y - 0.1 * y**3, 1 - 0.3 * y**2
    c, cr = root + 0.5 * root**3, 1 + 1.5 * root**2
    one = [a * b * c, ax * b * c, a * by * c, a * b * cr * slope]
    two = [a + b + c, ax, by, cr * slope]
    return np.stack([np.stack(one, -1), np.stack(two, -1)], axis=-1)


def made():
    values = [
        (1 + face) * polynomial(*np.broadcast_arrays(*GRID.xy_mm.T[:, :, None], FORCE_N))[..., 0, :]
        for face in range(2)
    ]
    return table.force_table(np.array([3, 5]), GRID, FORCE_N, np.stack(values))


def test_values_and_slopes_of_polynomials_are_exact_on_every_face():
    """More contacts than are worked on at a time."""
    rng = np.random.default_rng(0)
    contact = np.column_stack(
        [rng.uniform(-6, 6, 300), rng.uniform(-4, 5, 300), rng.uniform(0, 9, 300)]
    )
    face = rng.integers(0, 2, 300)
    found = made().values(face, contact)
    wanted = (1 + face)[:, None, None] * polynomial(*contact.T)
    assert_allclose(found, wanted, atol=2e-5 * abs(wanted).max(), rtol=1e-4)
    only = made().select_face(1)
    assert only.faces.tolist() == [5]
    assert_allclose(only.values(np.zeros(300, int), contact)[face == 1], found[face == 1])
    pulled = np.array([[0.0, 0.0, -1.0]])
    at_rest = made().values(np.zeros(1, int), np.zeros((1, 3)))
    assert_allclose(made().values(np.zeros(1, int), pulled), at_rest)


def test_forces_stand_evenly_in_their_root_up_to_the_hardest_place():
    force = np.array([[[1.0, 9.0], [2.0, 4.0]], [[1.0, 8.0], [1.0, 99.0]]])
    pressed = np.array([[True, True], [True, False]])
    signals = SimpleNamespace(force_n=force, pressed=pressed)
    nodes = table.force_nodes.__wrapped__(signals)
    assert_allclose(nodes, FORCE_N, atol=1e-12)
    assert len(nodes) == 14
    assert_allclose(made().largest_force_n, 9.0)


def test_beyond_its_deepest_press_a_place_goes_on_along_the_slope_at_its_end():
    force = np.array([[0.0, 1.0, 2.0, 4.0]])
    counts = np.stack([3 * force, force**2], axis=-1)
    traces = Traces(np.arange(4.0), force, counts, np.zeros((1, 4), bool))
    found = table.interpolate_forces(traces, np.array([0.0, 2.0, 4.0, 6.0]))
    assert_allclose(found[0, :, 0], [0, 6, 12, 18], atol=1e-9)
    slope = (16 - found_at(traces, 3.92)) / 0.08
    assert_allclose(found[0, :, 1], [0, 4, 16, 16 + 2 * slope], atol=1e-6)


def found_at(traces, force):
    from scipy.interpolate import PchipInterpolator

    return PchipInterpolator(traces.force_n[0], traces.counts[0, :, 1])(force)
