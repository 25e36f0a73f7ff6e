"""Tables of single presses, and several contacts together."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.interpolate import make_interp_spline

from design.layout.places.contact_grid import press_lattice
from design.layout.places.contact_places import pressed_nodes
from design.spec.object import ObjectSpec
from estimator.inversion.model.forward import ContactModel
from estimator.inversion.model.spline import CubicAxes, cubic_axis, spline_coefficients
from estimator.inversion.model.table import PressTable
from estimator.signals.field_setup import counts, sensed_field
from estimator.signals.interpolation import counts_at_force, press_traces, signal_gradient
from estimator.signals.press_states import press_states
from tests.support.mechanics.inverted import SPEC, contacts, inverted, presses


def test_splines_are_those_of_scipy_with_their_derivatives():
    nodes = np.array([0.0, 0.4, 1.0, 1.7, 3.0, 3.5, 4.1])
    values = np.random.default_rng(1).normal(size=(7, 3))
    at = np.linspace(0, 4.1, 40)
    axes = CubicAxes((cubic_axis(nodes + 1.0), cubic_axis(nodes)))
    (_, first), (_, along) = axes.weights((at[::-1], at))
    weights, slopes = along[..., 0], along[..., 1]
    coefficients = spline_coefficients((nodes,), values)
    near = coefficients[first[:, None] + np.arange(4)]
    oracle = make_interp_spline(nodes, values, k=3)
    assert_allclose(np.einsum("nb,nbc->nc", weights, near), oracle(at), atol=1e-12)
    assert_allclose(np.einsum("nb,nbc->nc", slopes, near), oracle(at, nu=1), atol=1e-11)


@pytest.fixture(scope="module")
def places():
    rng = np.random.default_rng(2)
    forces, _, signals = presses()
    face, xy = rng.integers(0, 5, 60), rng.uniform(-13, 13, (60, 2))
    traces = press_traces(signals, forces.faces[face], *xy.T)
    force = rng.uniform(0.1, 0.95, 60) * traces.force_n[:, -1]
    return face, xy, force, traces


def test_the_table_is_the_interpolation_of_presses_at_constant_force(places):
    face, xy, force, traces = places
    oracle = counts_at_force(traces, force[:, None]).counts[:, 0]
    found = inverted().model.signals.values(face, np.column_stack([xy, force]))
    assert np.sqrt(np.mean((found[:, 0] - oracle) ** 2) / np.mean(oracle**2)) < 2e-3
    _, _, signals = presses()
    slopes = signal_gradient(signals, signals.faces[face], *xy.T, force).jacobian
    for parameter in range(3):
        wrong = found[:, 1 + parameter] - slopes[..., parameter]
        assert np.sqrt(np.mean(wrong**2) / np.mean(slopes[..., parameter] ** 2)) < 0.02


def test_beyond_the_deepest_press_the_table_goes_on_along_its_slope(places):
    face, xy, _, traces = places
    reach = traces.force_n[:, -1]
    at, beyond = (
        inverted().model.signals.values(face, np.column_stack([xy, scale * reach]))
        for scale in (0.99, 1.05)
    )
    line = at[:, 0] + 0.06 * reach[:, None] * at[:, 3]
    assert np.sqrt(np.mean((beyond[:, 0] - line) ** 2) / np.mean(line**2)) < 0.02


def test_several_contacts_feel_the_field_of_their_summed_motions():
    forces, motions, _ = presses()
    model = inverted().model
    rng = np.random.default_rng(4)
    face, contact = contacts(rng, 8, 3, (2.0, 6.0))
    each = [
        press_states(forces, motions, forces.faces[face[:, k]], contact[:, k, :2], contact[:, k, 2])
        for k in range(3)
    ]
    moved = sum(one.motion(1.0)[0] for one in each)
    place = model.scene
    states = np.concatenate([np.zeros((1, *moved.shape[1:])), moved])
    seen = counts(place, sensed_field(place, states, model.field), SPEC).reshape(9, -1)
    exact = seen[1:] - seen[0]
    size = np.sqrt(np.mean(exact**2))
    summed = model.singles(face, contact)[:, :, 0].sum(axis=1)
    together = summed + model.interaction(face, contact)
    assert np.sqrt(np.mean((together - exact) ** 2)) < 3e-3 * size
    assert np.sqrt(np.mean((summed - exact) ** 2)) > 6e-3 * size


def test_one_contact_alone_has_no_interaction():
    model = inverted().model
    face, contact = contacts(np.random.default_rng(5), 6, 1)
    assert not model.interaction(face, contact).any()


def test_contacts_may_be_on_the_cells_whose_corners_are_all_pressed():
    """Of round faces: their area, and the nearest such place where a contact was moved beside them."""
    body = {"kind": "sphere", "size_mm": (44.0, 44.0, 44.0)}
    spec = ObjectSpec.model_validate(
        {"name": "x", "body": body, "contact_grid": {"count": "fill", "pitch_mm": 5.0}}
    )
    lattice, pressed = press_lattice(spec), pressed_nodes(spec)
    x, y, root = cubic_axis(lattice.x_mm), cubic_axis(lattice.y_mm), cubic_axis(np.arange(5.0))
    faces = np.array(spec.body.sensed)
    zeros = np.zeros((len(faces), len(x.nodes), len(y.nodes), 5, 3))
    table = PressTable(faces, x, y, root, zeros)
    model = ContactModel(spec, table, table, np.zeros((1, 6)), 3.0, skin=table)
    assert not model.whole
    there = pressed.reshape(len(faces), *lattice.shape)
    cells = there[:, 1:, 1:] & there[:, :-1, 1:] & there[:, 1:, :-1] & there[:, :-1, :-1]
    assert [len(middles) for middles in model.cells] == cells.sum(axis=(1, 2)).tolist()
    assert_allclose(model.area_mm2, cells.sum() * 2.5**2)
    far = np.array([[[50.0, 0.0, 1.0]], [[0.0, -50.0, 1.0]], [[0.3, -0.2, 2.0]]])
    moved = model.select_faces(np.array([[0], [1], [0]]), far)
    assert_allclose(moved[2], far[2])
    for k, axis, sign in ((0, 0, 1), (1, 1, -1)):
        assert_allclose(moved[k, 0, axis], sign * (abs(model.cells[k][:, axis]).max() + 1.25))
        assert abs(moved[k, 0, 1 - axis]) < 2.5
    one = model.select_face(1)
    assert_allclose(one.area_mm2, cells[1].sum() * 2.5**2)
