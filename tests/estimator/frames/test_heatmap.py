"""Heatmaps of contacts, and the labels of the public recordings."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from estimator.frames.heatmap import (
    faces_pressed,
    force_heatmaps,
    label_grid_mm,
    label_to_pixel,
    mm_to_pixel,
    pixel_to_mm,
)
from tests.support.recordings.synthetic_frames import synthetic_frames


def pixel_to_label(pixel):
    """Snake label of pixels (X, Y): row by row, every second one backwards."""
    x, y = pixel[..., 0], pixel[..., 1]
    return 10 * x + np.where(x % 2 == 1, 9 - y, y) + 1


@pytest.mark.parametrize(
    ("label", "pixel"),
    [(1, (0, 0)), (10, (0, 9)), (11, (1, 9)), (20, (1, 0)), (21, (2, 0)), (54, (5, 6)), (44, (4, 3))],
)  # fmt: skip
def test_snake_labels(label, pixel):
    assert tuple(label_to_pixel(np.array([label]))[0]) == pixel
    assert pixel_to_label(np.array([pixel]))[0] == label


def test_all_labels_round_trip():
    labels = np.arange(1, 101)
    pixels = label_to_pixel(labels)
    assert len(np.unique(pixels, axis=0)) == 100
    assert pixel_to_label(pixels).tolist() == labels.tolist()


@pytest.mark.parametrize("label", [0, 101, -3])
def test_labels_without_a_pixel_are_refused(label):
    with pytest.raises(InputError, match="1…100"):
        label_to_pixel(np.array([5, label]))


def test_places_in_mm_are_those_of_the_paper():
    """(X, Y) lies at ((X − 4.5)·3, (Y − 4.5)·3) mm."""
    grid = label_grid_mm()
    assert_allclose(pixel_to_mm(np.array([[0, 9], [5, 6]]), *grid), [[-13.5, 13.5], [1.5, 4.5]])


def test_nearest_pixel_and_border():
    grid = (np.array([-3.0, 0.0, 3.0]), np.array([0.0, 2.0]))
    points = np.array([[-1.4, 0.9], [-1.6, 1.1], [40.0, -40.0]])
    assert mm_to_pixel(points, *grid).tolist() == [[1, 0], [0, 1], [2, 0]]


def test_heatmap_holds_the_normal_force_at_the_nearest_pixel():
    frames = synthetic_frames(presses=1)
    maps = force_heatmaps(frames, 4)[:, 2]
    on_4 = frames.contact_face[:, 0] == 4
    assert_allclose(maps.sum(axis=(1, 2))[on_4], frames.force_n[on_4, 0, 2], rtol=1e-12)
    assert not maps[~on_4].any()
    row = np.flatnonzero(on_4)[25]
    x, y = np.unravel_index(maps[row].argmax(), maps[row].shape)
    centre = np.array([frames.grid_x_mm[x], frames.grid_y_mm[y]])
    assert_allclose(frames.contact_xy_mm[row, 0], centre, atol=0.21)


def test_contacts_on_one_pixel_add_up():
    frames = synthetic_frames(presses=1, faces=(4,))
    twice = np.repeat(frames.contact_face, 2, axis=1)
    doubled = type(frames)(
        **{
            **vars(frames),
            "contact_face": twice,
            "contact_xy_mm": np.repeat(frames.contact_xy_mm, 2, axis=1),
            "force_n": np.repeat(frames.force_n, 2, axis=1),
        }
    )
    assert_allclose(
        force_heatmaps(doubled, 4)[:, 2], 2 * force_heatmaps(frames, 4)[:, 2], rtol=1e-12
    )


def test_faces_pressed_skips_invalid_frames():
    frames = synthetic_frames(presses=1, places=[3])
    assert faces_pressed(frames) == (2, 4)
    hidden = type(frames)(**{**vars(frames), "valid": frames.contact_face[:, 0] != 2})
    assert faces_pressed(hidden) == (4,)
