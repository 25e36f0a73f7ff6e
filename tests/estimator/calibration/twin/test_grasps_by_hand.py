"""Twins of whole objects on a mechanics that is a sum: what cases leave out, keep and predict."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from estimator.calibration.twin import grasp_twin
from estimator.calibration.twin.grasp_twin import SIZES
from estimator.calibration.twin.pressed_cases import PressedCases
from estimator.calibration.twin.unknowns import FARTHEST, STIFFENING, Unknowns

NUMBERS = 3 + len(STIFFENING)
"""The third is the modulus."""
SPEC = SimpleNamespace(tolerances=SimpleNamespace(modulus_relative=0.3))


class Numbers(Unknowns):
    """As many as given, of no object."""

    def __init__(self, spec=None, faces=()):
        self.__dict__.update(spec=spec, faces=faces)

    def __len__(self):
        return NUMBERS


class Linear:
    """Six cases at two levels, four channels that are sums of the numbers; seven numbers of a size
    that cases tell well, the first beyond what it may be."""

    rng = np.random.default_rng(3)
    design = rng.normal(0, 40, (12, 4))
    slopes = rng.normal(0, 20, (12, 4, NUMBERS))
    noise2 = rng.uniform(1, 4, (6, 2, 4))
    true = np.array([9.0, -1.0, 0.6, 0.4, -0.8, 1.2, 0.1, -0.3])[:NUMBERS]
    strange = rng.normal(0, 25, (6, 2, 4))

    def __init__(self, seen):
        self.seen = seen

    def expected(self, numbers):
        return self.design + self.slopes @ numbers


def seen_as(counts):
    chip = np.sqrt(np.mean(counts**2, axis=2, keepdims=True)) * np.ones(counts.shape)
    case, level = counts.shape[:2]
    return PressedCases(
        np.arange(4), np.full((case, 1), 3), np.zeros((case, 1, 2)), np.ones((case, level, 1)),
        counts, Linear.noise2, chip, np.ones(3),
    )  # fmt: skip


def solved(rows, right, variance):
    """Ridge regression with a prior of 1: stacked least squares, and the inverse of its square."""
    weight = 1 / np.sqrt(variance)
    matrix = np.vstack([(rows * weight[:, None]), np.eye(NUMBERS)])
    found = np.linalg.lstsq(matrix, np.append(right * weight, np.zeros(NUMBERS)))[0]
    return found, np.linalg.inv(matrix.T @ matrix)


def calibrated(monkeypatch, counts):
    seen, asked = seen_as(counts), []

    def most_probable(mechanics, left_over, measured, start):
        asked.append((left_over.variance, measured, start))
        at = 0.5 * np.ones(NUMBERS)
        return at, mechanics.expected(at), Linear.slopes

    monkeypatch.setattr(grasp_twin, "Unknowns", Numbers)
    monkeypatch.setattr(grasp_twin, "_Mechanics", lambda *given: Linear(given[-1]))
    monkeypatch.setattr(grasp_twin, "most_probable", most_probable)
    for name in ("_cases_left_out", "_solved"):
        monkeypatch.setattr(grasp_twin, name, getattr(grasp_twin, name).__wrapped__)
    return seen, asked, grasp_twin.calibrate_on_cases.__wrapped__(SPEC, None, None, seen)


def test_the_share_left_over_is_that_which_predicts_cases_left_out_best(monkeypatch):
    """Every case by ridge regression on the others, for each size; numbers stay within their limits."""
    counts = (Linear.design + Linear.slopes @ Linear.true).reshape(6, 2, 4)
    counts = counts + 0.3 * Linear.strange
    seen, asked, found = calibrated(monkeypatch, counts)
    off = counts.reshape(12, 4) - Linear.design
    of_design = grasp_twin.left_share(seen, off)
    assert_allclose(found.design_share, of_design)
    ((variance, measured, start),) = asked
    size = np.clip(np.sqrt(np.mean(of_design**2)) / 2, 0.02, 1.0)
    assert 0.02 < size < 1
    chip2 = seen.chip_counts**2
    assert_allclose(variance, (Linear.noise2 + 2 * size**2 * chip2).reshape(12, 4))
    assert_allclose(measured, counts.reshape(12, 4))
    assert_array_equal(start, np.zeros(NUMBERS))
    case, tried = np.repeat(np.arange(6), 2), {}
    for size in SIZES:
        variance, left = (Linear.noise2 + 2 * size**2 * chip2).reshape(12, 4), off.copy()
        for out in range(6):
            rows = case != out
            numbers, _ = solved(
                Linear.slopes[rows].reshape(-1, NUMBERS), off[rows].ravel(), variance[rows].ravel()
            )
            left[~rows] -= Linear.slopes[~rows] @ np.clip(numbers, -FARTHEST, FARTHEST)
        whole = solved(Linear.slopes.reshape(-1, NUMBERS), off.ravel(), variance.ravel())
        tried[size] = left, whole
    means = {
        size: np.mean(grasp_twin.left_share(seen, left) ** 2) for size, (left, _) in tried.items()
    }
    left, (numbers, covariance) = tried[min(means, key=means.get)]
    assert_allclose(found.left, left.reshape(6, 2, 4), atol=1e-9)
    assert_allclose(found.left_share, grasp_twin.left_share(seen, left))
    assert_allclose(found.numbers, np.clip(numbers, -FARTHEST, FARTHEST), atol=1e-9)
    assert_allclose(found.modulus_error, 0.3 * np.sqrt(covariance[2, 2]))
    assert found.helps
    assert found.strained == (abs(numbers) >= FARTHEST).sum() == 1


def test_where_the_design_predicts_cases_left_out_as_well_no_number_is_told(monkeypatch):
    counts = Linear.design.reshape(6, 2, 4) + Linear.strange
    _, _, found = calibrated(monkeypatch, counts)
    assert not found.helps
    assert_array_equal(found.numbers, np.zeros(NUMBERS))
    assert_allclose(found.modulus_error, 0.3)
    assert_allclose(found.left, Linear.strange)
    assert np.mean(found.left_share**2) >= np.mean(found.design_share**2)


def test_a_start_s_share_stays_between_the_smallest_and_the_largest(monkeypatch):
    counts = Linear.design.reshape(6, 2, 4) + 1e-3
    seen, asked, _ = calibrated(monkeypatch, counts)
    variance = Linear.noise2 + 2 * 0.02**2 * seen.chip_counts**2
    assert_allclose(asked[0][0], variance.reshape(12, 4))


def test_a_case_left_out_that_is_no_object_counts_as_infinitely_wrong():
    counts = (Linear.design + Linear.slopes @ Linear.true).reshape(6, 2, 4)
    mechanics = Linear(seen_as(counts))
    mechanics.expected = lambda numbers: (
        np.where(np.arange(12)[:, None] == 5, np.nan, 1.0) * np.ones(4)
    )
    left_over = grasp_twin._left_over(mechanics.seen, 0.1)
    off = counts.reshape(12, 4) - Linear.design
    left = grasp_twin._cases_left_out.__wrapped__(mechanics, left_over, Linear.slopes, off)
    rows = np.arange(12) != 5
    assert_allclose(left[rows], counts.reshape(12, 4)[rows] - 1)
    assert np.isneginf(left[5]).all()


def test_motions_of_all_contacts_of_a_case_add_up_each_at_its_own_force(monkeypatch):
    """Two cases at two levels, the first pressed twice; forces of 0, 2 and 6 N at the tables' ends, held
    beyond them; bodies move in proportion to the force, from where they rest."""
    monkeypatch.setattr(grasp_twin, "twin_model", lambda spec, assembly, states: states.shape)
    still = 0.25 * np.arange(12.0).reshape(2, 6)

    def counts_of(spec, scene, states, model):
        assert (spec, scene, model) == ("spec", "scene", (4, 2, 6))
        return 3 * states[:, :, :3] + states[:, :, 3:] ** 2

    monkeypatch.setattr(grasp_twin, "counts_of", counts_of)
    force = np.array([[[1.0, 5.0], [2.0, 9.0]], [[3.0, 6.0], [1.0, 4.0]]])
    seen = SimpleNamespace(counts=np.zeros((2, 2, 5)), channels=np.arange(5), force_n=force)
    unknowns = SimpleNamespace(
        spec="spec",
        assembly=lambda numbers: SimpleNamespace(scene="scene"),
        correction=lambda numbers: numbers[0],
    )
    unit = np.random.default_rng(0).normal(size=(3, 2, 6))

    def places(*rows):
        def of(assembly, correction):
            newton = np.tile([2.0, correction], (len(rows), 1))
            return newton, still + newton[..., None, None] * unit[list(rows), None]

        return SimpleNamespace(of=of)

    mechanics = object.__new__(grasp_twin._Mechanics)
    mechanics.unknowns, mechanics.seen, mechanics.rest = unknowns, seen, still
    mechanics.parts = [
        (np.array([0, 1]), np.array([0, 0]), places(0, 1)),
        (np.array([0]), np.array([1]), places(2)),
    ]
    found = grasp_twin._Mechanics.expected.__wrapped__(mechanics, np.array([6.0]))
    rows = []
    for case, level in ((0, 0), (0, 1), (1, 0), (1, 1)):
        held = np.minimum(force[case, level], 6.0)
        moved = held[0] * unit[case] + (held[1] * unit[2] if case == 0 else 0)
        change = 3 * moved[:, :3] + (still + moved)[:, 3:] ** 2 - still[:, 3:] ** 2
        rows.append(change.ravel()[:5])
    assert_allclose(found, rows)
    for flat in (2.0, 1.5):
        none = grasp_twin._Mechanics.expected.__wrapped__(mechanics, np.array([flat]))
        assert np.isnan(none).all()
        assert none.shape == (4, 5)


def test_errors_of_sensors_without_any_clear_change_are_the_mean():
    seen = replace(seen_as(np.full((6, 2, 4), 100.0)), channels=np.array([0, 1, 2, 4]))
    errors = grasp_twin.sensor_errors(seen, np.full((6, 2, 4), 30.0), 3)
    first = np.mean((900 - Linear.noise2[..., :3]) / 1e4)
    second = np.mean((900 - Linear.noise2[..., 3]) / 1e4)
    assert_allclose(errors[:, 0] ** 2, [first, second, (first + second) / 2])
    assert errors[0] != pytest.approx(errors[1], rel=1e-5)


@pytest.mark.parametrize(
    ("shares", "helps"), [((0.9, 0.3, 0.3, 0.3, 0.3, 0.3), True), ((0.6,) * 6, False)]
)
def test_cases_are_judged_by_the_squares_of_their_shares(monkeypatch, shares, helps):
    """At one size a bad case among good ones, or all alike; others leave somewhat more by squares, the
    design a half. Cubes would say the contrary."""
    best, others = np.array(shares), np.full(6, 0.49 if helps else 0.61)
    tried = []

    def left_out(mechanics, left_over, jacobian, right):
        tried.append(left_over.variance)
        return np.full((12, 4), -1.0 if len(tried) == 2 else -2.0)

    def share(seen, left):
        return {-1.0: best, -2.0: others}.get(float(left.flat[0]), np.full(6, 0.5))

    counts = Linear.design.reshape(6, 2, 4) + Linear.strange
    monkeypatch.setattr(grasp_twin, "_cases_left_out", left_out)
    monkeypatch.setattr(grasp_twin, "left_share", share)
    left_out.__wrapped__ = left_out  # as `calibrated` takes it without its check of shapes
    seen, _, found = calibrated(monkeypatch, counts)
    assert_array_equal(found.left_share, best)
    assert found.helps == helps
    rows = Linear.slopes.reshape(-1, NUMBERS), Linear.strange.ravel()
    variance = (Linear.noise2 + 2 * SIZES[1] ** 2 * seen.chip_counts**2).ravel()
    numbers = np.clip(solved(*rows, variance)[0], -FARTHEST, FARTHEST)
    assert_allclose(found.numbers, helps * numbers)
    assert_allclose(found.left, np.full((6, 2, 4), -1.0) if helps else Linear.strange)
