"""Bounds of two contacts from simulated presses, against finite differences of the forward model."""

from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.layout.places.contact_grid import contact_grid
from estimator.information import two_contacts
from estimator.information.contact_sets import contact_sets, spread_pairs, spread_places
from estimator.information.fisher import disturbance_counts
from estimator.information.two_contacts import opposite_faces, two_contact_bounds_mm
from estimator.signals.interpolation import counts_at_force, press_traces
from estimator.signals.presses import press_signals
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

SPEC = coarse_spec(
    contact_grid={"count": (3, 4), "pitch_mm": 6.0},
    score={"force_n": 6.0},
    indenter={"radius_mm": 4.5},
)
STEP = 1e-4


@pytest.fixture(scope="module")
def signals():
    return press_signals(SPEC, *synthetic_presses(SPEC))


@pytest.fixture(scope="module")
def jacobians(signals):
    """∂S/∂(x, y, F) in sigmas by central differences: face → (place, channel, 3)."""
    return {face: by_differences(signals, face) for face in range(1, 6)}


def by_differences(signals, face):
    sigma = disturbance_counts(SPEC.sensors, "fresh", 45)
    places = contact_grid(SPEC).xy_mm

    def counts(dx, dy, df):
        x, y = places.T
        traces = press_traces(signals, np.full(len(x), face), x + dx, y + dy)
        return counts_at_force(traces, np.full((len(x), 1), 6.0 + df)).counts[:, 0]

    columns = [(counts(*step) - counts(*-step)) / (2 * STEP) for step in STEP * np.eye(3)]
    return np.stack(columns, axis=-1) / sigma[:, None]


def worse_mm(a, b):
    joint = np.concatenate([a, b], axis=1)
    variance = np.diagonal(np.linalg.inv(joint.T @ joint))
    return np.sqrt(max(variance[:2].sum(), variance[3:5].sum()))


def test_two_contacts_on_a_face_have_the_bound_of_their_joint_information(signals, jacobians):
    found = two_contact_bounds_mm(SPEC, signals)
    pairs = contact_sets(SPEC, spread_places(SPEC), 2)
    every = [(face, a, b) for face in range(1, 6) for a, b in pairs]
    assert len(found["own"]) == len(found["all"]) == len(every)
    for row in range(0, len(every), 7):
        face, a, b = every[row]
        whole = jacobians[face]
        own = whole[:, 9 * (face - 1) : 9 * face]
        assert_allclose(found["own"][row], worse_mm(own[a], own[b]), rtol=2e-3)
        assert_allclose(found["all"][row], worse_mm(whole[a], whole[b]), rtol=2e-3)


def test_a_grasp_has_the_bound_of_contacts_on_both_faces(signals, jacobians):
    assert opposite_faces(SPEC) == ((2, 4), (3, 5))
    found = two_contact_bounds_mm(SPEC, signals)["grasp"]
    wanted = [
        worse_mm(one, other)
        for a, b in ((2, 4), (3, 5))
        for one in jacobians[a]
        for other in jacobians[b]
    ]
    assert_allclose(found, wanted, rtol=2e-3)


def test_pairs_are_those_whose_tips_do_not_touch():
    pairs = contact_sets(SPEC, spread_places(SPEC), 2)
    assert_allclose(spread_pairs(SPEC), pairs)
    huge = SPEC.changed(indenter=SPEC.indenter.changed(radius_mm=12.0))
    assert spread_pairs(huge).shape == (0, 2)


def test_nothing_is_told_of_what_the_object_has_none_of(signals):
    huge = SPEC.changed(indenter=SPEC.indenter.changed(radius_mm=12.0))
    found = two_contact_bounds_mm(huge, signals)
    assert len(found["own"]) == len(found["all"]) == 0
    assert len(found["grasp"]) == 2 * 12 * 12


def test_a_dead_channel_tells_nothing(signals):
    dead = {"sensors": [{"face": 2, "sensor": 1, "dead": ["X", "Y", "Z"]}]}
    broken = SPEC.model_validate(SPEC.model_dump() | {"as_built": dead})
    whole, less = (two_contact_bounds_mm(spec, signals) for spec in (SPEC, broken))
    of_face_2 = slice(len(whole["own"]) // 5, 2 * len(whole["own"]) // 5)
    assert np.all(less["own"][of_face_2] > whole["own"][of_face_2])
    others = np.delete(np.arange(len(whole["own"])), np.arange(len(whole["own"]))[of_face_2])
    assert_allclose(less["own"][others], whole["own"][others])


def test_half_the_noise_halves_every_bound(signals):
    sensors = SPEC.sensors
    noise = tuple(counts / 2 for counts in sensors.noise_counts)
    quiet = SPEC.changed(
        sensors=sensors.changed(noise_counts=noise, zeroing_counts=sensors.zeroing_counts / 2)
    )
    whole, half = (two_contact_bounds_mm(spec, signals) for spec in (SPEC, quiet))
    for name in ("own", "all", "grasp"):
        assert_allclose(half[name], whole[name] / 2, rtol=1e-6)


def test_faces_are_opposite_where_their_normals_are_more_than_120_degrees_apart(monkeypatch):
    """Whatever their order: 143° apart one after the other, 180° and 121.3° with others between."""
    normals = {
        2: [0, 0, 1],
        3: [0, 0.6, -0.8],
        5: [1, 0, 0],
        6: [0, -0.6, 0.8],
        9: [-0.52, 0.854, 0],
    }
    frames = [SimpleNamespace(number=n, normal=np.array(way, float)) for n, way in normals.items()]
    monkeypatch.setattr(two_contacts, "face_frames", lambda spec: frames)
    assert opposite_faces(SPEC) == ((2, 3), (3, 6), (5, 9), (6, 9))
