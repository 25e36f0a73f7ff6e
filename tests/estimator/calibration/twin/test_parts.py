"""Parts of twins by hand: kernels, memories of errors, evidence, and the order of frames."""

from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose
from sklearn.gaussian_process.kernels import Matern

from design.errors import InputError
from design.spec.object import ObjectSpec
from estimator.calibration.twin import digital_twin, discrepancy
from estimator.calibration.twin.digital_twin import left_share, rows_of_face
from estimator.calibration.twin.pressed_places import PressedPlaces
from fem.presses.results import MagnetMotions, PressForces


def test_the_process_over_places_is_a_matern_of_five_halves():
    rng = np.random.default_rng(0)
    a, b = rng.uniform(-9, 9, (5, 2)), rng.uniform(-9, 9, (4, 2))
    made = object.__new__(discrepancy.Discrepancy)
    made.__dict__["prior"] = SimpleNamespace(length_mm=7.0)
    assert_allclose(made.matern(a, b), Matern(7.0, nu=2.5)(a, b))


def test_fields_grow_with_the_force_and_its_square_over_ten_newton():
    fields = np.array([[[1.0, 2.0]], [[10.0, -4.0]]])
    found = discrepancy.scaled_by_force(fields, np.array([[0.0, 5.0, 10.0]]))
    assert_allclose(found, [[[0, 0], [0.5 + 2.5, 1 - 1], [11, -2]]])


def test_the_presses_of_one_face_are_cut_out_of_all():
    from design.layout.places.contact_grid import PlaceGrid

    faces, grid = np.array([2, 5]), PlaceGrid(np.arange(2.0), np.arange(2.0))
    force = np.arange(8.0).reshape(2, 4, 1)
    motion = np.arange(48.0).reshape(2, 4, 1, 1, 6)
    depth = np.ones(1)
    forces, motions = rows_of_face(
        PressForces(faces, grid, depth, force, 2 * force),
        MagnetMotions(faces, grid, depth, motion), 5,
    )  # fmt: skip
    assert forces.faces.tolist() == motions.faces.tolist() == [5]
    assert_allclose(forces.force_n, force[1:])
    assert_allclose(forces.contact_area_mm2, 2 * force[1:])
    assert_allclose(motions.motion, motion[1:])


def pressed(places=7):
    """Places at three levels with two channels; frames, forces and errors of zeros are all different."""
    rng = np.random.default_rng(5)
    root = rng.normal(0, 4, (places, 3, 3))
    return PressedPlaces(
        3, np.array([1, 5]), rng.uniform(-9, 9, (places, 2)),
        np.sort(rng.uniform(2, 9, (places, 3)), axis=1), rng.normal(0, 400, (places, 3, 2)),
        rng.integers(9, 40, (places, 3)), np.einsum("pij,pkj->pik", root, root),
    )  # fmt: skip


def test_what_a_prediction_leaves_of_a_place_is_about_the_means_of_its_levels():
    """Noise of three levels about their mean: of each 2/3, less 2/3 of what two share."""
    spec, seen = ObjectSpec(name="cube"), pressed(4)
    predicted = 0.7 * seen.counts + 1e4
    predicted[2] = np.nan
    seen.counts[3] *= 1e-6  # nothing but noise: the share of that
    predicted[3] = seen.counts[3] + [[300.0, 0], [0, 0], [0, -600.0]]
    found = left_share(spec, seen, predicted)
    white = seen.white_counts2(spec)
    for place, share in enumerate(found):
        zero, noise = seen.zero_counts2[place], 2 * white[place].sum() / 3
        for i in range(3):
            noise += 2 * (2 / 3 * zero[i, i] - 1 / 3 * (zero[i].sum() - zero[i, i]))
        wrong, size = (
            np.sum((values - values.mean(axis=0)) ** 2) - noise
            for values in (seen.counts[place] - predicted[place], seen.counts[place])
        )
        wanted = 1.0 if place == 2 else np.sqrt(max(wrong, 0) / max(size, noise))
        assert share == pytest.approx(wanted)
        assert place == 3 or wanted > 0.25
    assert found[3] > 1
    exact = left_share(spec, seen, seen.counts)
    assert_allclose(exact, 0)


@pytest.mark.parametrize(("impossible", "drawn"), [(0, True), (19, True), (20, False)])
def test_an_object_is_drawn_twenty_times_at_most(impossible, drawn):
    """Some draws in a row are no object; the most probable one is asked once."""
    asked = []

    def signals(numbers, forces, motions):
        asked.append(numbers)
        return None if len(asked) <= impossible else "signals"

    twin = SimpleNamespace(
        numbers=np.array([0.5, -0.25]),
        factor=np.array([[1e-3, 0.0], [2e-3, 1e-3]]),
        unknowns=SimpleNamespace(signals=signals, face=4, spec=SimpleNamespace(name="made")),
        forces=None,
        motions=None,
        _with_discrepancy=lambda made, numbers, rng: (made, numbers),
    )
    told = digital_twin.CalibratedTwin.signals.__wrapped__
    if drawn:
        made, numbers = told(twin, np.random.default_rng(7))
        rng = np.random.default_rng(7)
        draws = [twin.numbers + twin.factor @ rng.standard_normal(2) for _ in asked]
        assert_allclose(asked, draws)
        assert_allclose(numbers, draws[-1])
        assert (made, len(asked)) == ("signals", impossible + 1)
    else:
        with pytest.raises(InputError, match="presses of face 4 fit no object of 'made'"):
            told(twin, np.random.default_rng(7))
        assert len(asked) == 20
    asked.clear()
    if impossible:
        with pytest.raises(InputError, match="face 4"):
            told(twin, None)
    else:
        assert_allclose(told(twin, None)[1], twin.numbers)
    assert len(asked) == 1
