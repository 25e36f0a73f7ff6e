"""The paper's metrics against cases worked by hand."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from estimator.metrics import cross_correlation as alignment
from estimator.metrics.cross_correlation import align
from estimator.metrics.heatmaps import (
    NON_CONTACT_SHARE,
    ForceReference,
    face_metrics,
    force_reference,
)


def maps(shape, *contacts):
    result = np.zeros((1, *shape))
    for x, y, force in contacts:
        result[0, x, y] = force
    return result


def direct_zncc(predicted, true):
    """Correlation at every displacement by plain loops, zero outside."""
    p, t = predicted - predicted.mean(), true - true.mean()
    scale = np.sqrt(np.sum(p**2) * np.sum(t**2))
    nx, ny = t.shape
    result = {}
    for dx in range(1 - nx, nx):
        for dy in range(1 - ny, ny):
            total = 0.0
            for x in range(nx):
                for y in range(ny):
                    if 0 <= x + dx < nx and 0 <= y + dy < ny:
                        total += p[x + dx, y + dy] * t[x, y]
            result[dx, dy] = total / scale
    return result


def test_a_scaled_copy_is_perfect():
    true = maps((3, 3), (0, 2, 5.0), (1, 1, 2.0))
    aligned = align(0.3 * true + 0.1, true)
    assert_allclose(aligned.similarity, [1.0], atol=1e-12)
    assert_allclose(aligned.displacement_px, [[0, 0]], atol=0)


def test_shifted_peak_on_three_by_three_by_hand():
    """One pixel of nine: each zero-mean map has the peak at 8/9 and -1/9 elsewhere, norm² 8/9.

    Displacement (1, 0): six of the nine products stay inside, peak × peak + 5 × (1/81).
    """
    aligned = align(maps((3, 3), (2, 1, 4.0)), maps((3, 3), (1, 1, 7.0)))
    assert_allclose(aligned.similarity, [(64 / 81 + 5 / 81) / (8 / 9)], rtol=1e-12)
    assert_allclose(aligned.displacement_px, [[1, 0]], atol=0)


def test_fft_agrees_with_loops_on_asymmetric_maps():
    rng = np.random.default_rng(3)
    predicted, true = rng.random((4, 4, 6)), rng.random((4, 4, 6)) ** 3
    aligned = align(predicted, true)
    for frame in range(4):
        direct = direct_zncc(predicted[frame], true[frame])
        best = max(direct, key=direct.__getitem__)
        assert_allclose(aligned.similarity[frame], direct[best], rtol=1e-10)
        assert tuple(aligned.displacement_px[frame]) == best


def test_direction_of_the_displacement_is_from_true_to_predicted():
    aligned = align(maps((10, 10), (7, 2, 1.0)), maps((10, 10), (5, 6, 1.0)))
    assert aligned.displacement_px.tolist() == [[2.0, -4.0]]


def test_ties_take_the_shortest_displacement():
    """One predicted peak lies 1 pixel from one true tip and 3 from the other; both overlap alike."""
    true = maps((9, 9), (2, 4, 5.0), (6, 4, 5.0))
    aligned = align(maps((9, 9), (3, 4, 5.0)), true)
    direct = direct_zncc(maps((9, 9), (3, 4, 5.0))[0], true[0])
    best = max(direct.values())
    tied = [d for d, value in direct.items() if value > best - 1e-9]
    assert np.hypot(*aligned.displacement_px[0]) == min(np.hypot(*d) for d in tied)


@pytest.mark.parametrize("level", [0.0, 2.5, 1e-9])
def test_a_constant_prediction_is_undefined_not_perfect(level):
    true = maps((10, 10), (3, 8, 6.0))
    aligned = align(np.full_like(true, level), true)
    assert aligned.similarity.tolist() == [0.0]
    assert np.isnan(aligned.displacement_px).all()


def test_no_frames_give_empty_arrays():
    empty = np.zeros((0, 10, 10))
    assert align(empty, empty).similarity.shape == (0,)


def test_chunks_change_nothing(monkeypatch):
    rng = np.random.default_rng(0)
    predicted, true = rng.random((11, 5, 4)), rng.random((11, 5, 4))
    whole = align(predicted, true)
    monkeypatch.setattr(alignment, "CHUNK_FRAMES", 4)
    parts = align(predicted, true)
    assert_allclose(parts.similarity, whole.similarity, rtol=1e-12)
    assert_allclose(parts.displacement_px, whole.displacement_px, atol=0)


def worked_case():
    """Four frames on 3 × 3: two contacts at (0, 1), one at (2, 2), one at rest."""
    true = np.zeros((4, 3, 3))
    true[0, 0, 1], true[1, 0, 1], true[2, 2, 2] = 2.0, 10.0, 6.0
    predicted = true.copy()
    predicted[0, 0, 1], predicted[1, 0, 1] = 3.0, 8.0
    predicted[2] = 0
    predicted[2, 1, 2], predicted[2, 2, 2] = 4.0, 1.0
    predicted[3, 1, 1] = 1.7
    dataset = np.concatenate([true, maps((3, 3), (2, 2, 16.0))])
    return predicted, true, force_reference(dataset)


def test_force_reference_by_hand():
    _, _, reference = worked_case()
    assert reference.smallest_contact_n == 2.0
    assert reference.range_n[0, 1] == 8.0
    assert reference.range_n[2, 2] == 10.0
    assert np.isnan(reference.range_n[1, 1])


def test_face_metrics_by_hand():
    """Errors 1, 2 and 5 N of ranges 8, 8 and 10 N; total errors 1, 2, 1 N; frame 2 one pixel off."""
    result = face_metrics(3, *worked_case())
    assert_allclose(result.force_error_n, 8 / 3, rtol=1e-12)
    assert_allclose(result.force_error_percent, (12.5 + 25 + 50) / 3, rtol=1e-12)
    assert_allclose(result.total_force_error_n, 4 / 3, rtol=1e-12)
    assert_allclose(
        result.total_force_error_percent, (100 / 8 + 200 / 8 + 100 / 10) / 3, rtol=1e-12
    )
    assert_allclose(result.location_error_px, 1 / 3, rtol=1e-12)
    assert_allclose(result.location_error_x_px, 1 / 3, rtol=1e-12)
    assert_allclose(result.location_error_y_px, 0, atol=0)
    assert result.non_contact_accuracy == 1.0
    assert (result.contact_frames, result.rest_frames) == (3, 1)
    assert_allclose(result.maps.force_error_n[0, 1], 1.5, rtol=1e-12)
    assert_allclose(result.maps.location_error_px[2, 2], 1.0, rtol=1e-12)
    assert result.maps.contacts.sum() == 3
    assert np.isnan(result.maps.similarity[1, 0])


@pytest.mark.parametrize(("level", "accuracy"), [(1.79, 1.0), (1.81, 0.0)])
def test_non_contact_threshold_is_nine_tenths_of_the_smallest_contact(level, accuracy):
    predicted, true, reference = worked_case()
    predicted[3, 1, 1] = level
    assert face_metrics(3, predicted, true, reference).non_contact_accuracy == accuracy


def test_frames_with_other_faces_pressed_are_judged_apart():
    predicted, true, reference = worked_case()
    predicted[3, 1, 1] = 5.0
    result = face_metrics(3, predicted, true, reference, rest=np.zeros(4, dtype=bool))
    assert result.other_face_accuracy == 0.0
    assert np.isnan(result.non_contact_accuracy)
    assert result.summary()["non_contact_accuracy"] is None


def test_undefined_predictions_are_counted():
    predicted, true, reference = worked_case()
    predicted[0] = 0.0
    result = face_metrics(3, predicted, true, reference)
    assert result.undefined_frames == 1
    assert_allclose(result.location_error_px, 0.5, rtol=1e-12)


def test_force_reference_needs_a_contact():
    with pytest.raises(InputError, match="all zero"):
        force_reference(np.zeros((2, 3, 3)))


def test_a_frame_exactly_at_the_non_contact_threshold_is_not_quiet():
    predicted, true, reference = worked_case()
    predicted[3, 1, 1] = NON_CONTACT_SHARE * reference.smallest_contact_n
    assert face_metrics(3, predicted, true, reference).non_contact_accuracy == 0.0


def test_a_map_with_pixels_at_its_mean_is_aligned_too():
    ramp = np.tile(np.array([1.0, 2.0, 3.0]), (1, 3, 1))
    found = align(ramp, ramp)
    assert_allclose(found.similarity, 1)
    assert_allclose(found.displacement_px, 0)


def test_the_displaced_force_error_forgives_a_force_at_the_wrong_place():
    true = np.concatenate([maps((5, 5), (2, 2, 4.0)), maps((5, 5), (0, 0, 2.0))])
    shifted = np.concatenate([maps((5, 5), (3, 1, 3.5)), maps((5, 5), (0, 0, 2.0))])
    reference = ForceReference(2.0, np.full((5, 5), 2.0))
    found = face_metrics(1, shifted, true, reference)
    assert_allclose(found.force_error_percent, 100 * (4.0 / 2 + 0) / 2)
    assert_allclose(found.displaced_force_error_percent, 100 * (0.5 / 2 + 0) / 2)


def test_the_displaced_force_error_leaves_out_maps_that_are_unlike():
    true = maps((5, 5), (2, 2, 4.0))
    unlike = np.full((1, 5, 5), 1.0)
    unlike[0, 0, 0] = 1.1
    unlike[0, 4, 4] = 0.5
    unlike[0, 4, 0] = 0.5
    unlike[0, 0, 4] = 0.5
    reference = ForceReference(2.0, np.full((5, 5), 2.0))
    found = face_metrics(1, unlike, true, reference)
    assert found.similarity < 0.3
    assert np.isnan(found.displaced_force_error_percent)
    assert np.isfinite(found.force_error_percent)
