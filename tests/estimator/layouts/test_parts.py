"""Parts of layout scores against NumPy: least squares, chips that turn, false forces, worst ratios."""

from types import SimpleNamespace

import numpy as np
import torch
from numpy.testing import assert_allclose

from design.layout.body import core_frames
from design.spec.object import ObjectSpec
from estimator.layouts import batch_scores, cross_face
from estimator.layouts.limits import curved


def tensor(values):
    return torch.as_tensor(np.asarray(values, float))


def test_a_false_force_is_that_of_the_own_press_that_is_nearest_up_to_twice_the_force(monkeypatch):
    """Every own place at forces in steps of a thousandth: the nearest signals win."""
    rng = np.random.default_rng(2)
    layouts, neighbours, places, channels, force = 2, 3, 4, 6, 5.0
    own = rng.normal(size=(channels, layouts, 4, places))
    other = rng.normal(size=(layouts, neighbours, channels, places))
    presses = SimpleNamespace(count=places, force_n=force)

    def neighbour_changes(scorer, given, columns):
        assert columns.tolist() == [12, 13, 14, 15]
        return tensor(other)

    monkeypatch.setattr(cross_face, "neighbour_changes", neighbour_changes)
    monkeypatch.setattr(
        cross_face, "press_changes",
        lambda scorer, given: SimpleNamespace(by_parameter=tensor(own)),
    )  # fmt: skip
    found = cross_face.false_forces_n.__wrapped__(SimpleNamespace(presses=presses), None).numpy()
    share = np.linspace(0, 2, 2001)
    for layout in range(layouts):
        shown = share[:, None, None] * own[:, layout, 3].T
        for neighbour in range(neighbours):
            for place in range(places):
                seen = 10 / force * other[layout, neighbour, :, place]
                away = np.sum((shown - seen) ** 2, axis=2)
                wanted = share[np.unravel_index(away.argmin(), away.shape)[0]] * force
                assert_allclose(found[layout, neighbour, place], wanted, atol=0.004)


def test_scores_of_several_forces_are_geometric_means_and_false_forces_are_of_the_nearest(
    monkeypatch,
):
    """Scorers at 1, 4 and 12 N: 12 N is nearest to the 10 N at which faces disturb each other."""
    asked = {}

    def at_one_force(scorers, layouts, places, named):
        force = scorers[0].presses.force_n
        asked[force] = set(named)
        scores = {"median_position_bound_mm": tensor([1 / force, 2 / force])}
        for name in named:
            scores[name] = tensor([force, force + 1])
        return scores

    monkeypatch.setattr(batch_scores, "scores_at_one_force", at_one_force)
    counts = [
        SimpleNamespace(largest_counts=tensor([n, 24.0]), kept_counts=tensor([9 - n, n]))
        for n in (3.0, 1.0, 12.0, 4.0)
    ]
    monkeypatch.setattr(batch_scores, "places_information", lambda scorers, layouts: counts)
    presses = [SimpleNamespace(force_n=n) for n in (4.0, 1.0, 12.0, 4.0)]
    scorers = [SimpleNamespace(presses=one) for one in presses]
    names = {"median_false_force_n"}
    found = batch_scores.batch_scores.__wrapped__(scorers, [None] * 4, names)
    assert asked == {1.0: set(), 4.0: set(), 12.0: names}
    mean = 48 ** (1 / 3)
    assert_allclose(found["median_position_bound_mm"], [1 / mean, 2 / mean])
    assert_allclose(found["median_false_force_n"], [12, 13])
    assert_allclose(found["largest_counts"], [12, 24])
    assert_allclose(found["kept_counts"], [8, 12])


def test_a_face_counts_as_often_as_the_faces_that_it_stands_for():
    one, other = SimpleNamespace(faces=3), SimpleNamespace(faces=1)
    found = batch_scores.all_faces.__wrapped__(
        [one, other], [tensor([[1.0, 2.0]]), tensor([[5.0]])]
    )
    assert found.tolist() == [[1, 2, 1, 2, 1, 2, 5]]


class Board:
    """A surface with one recess whose board sinks by 0.3 mm; the core's patch ends at 9 mm."""

    spec = ObjectSpec(name="cube")
    core = core_frames(spec)[0]

    def boards(self, sensor_mm):
        axes = torch.eye(3, dtype=torch.float64)[[1, 0, 2]].expand(1, 1, 3, 3)
        return tensor([[[1.0, 2.0, 10.0]]]), axes, tensor([[0.3]])

    def reach_mm(self, places_mm):
        return np.full(len(places_mm), 9.0)


def test_a_recess_lies_under_its_board_as_deep_as_it_sinks():
    """Radial along y here: 0.5 mm ahead of the sensor, and half as deep as it is."""
    layouts = SimpleNamespace(sensor_mm=tensor([[[3.0, 4.0]]]))
    boards = SimpleNamespace(
        centre=tensor([[[3.3, 4.4]]]), radial=tensor([[[0.6, 0.8]]]), half_mm=(2.0, 1.5)
    )
    centre, axes, half = curved.recess_boxes.__wrapped__(Board(), layouts, boards)
    deep = (Board.spec.core.recess_depth_mm + 0.3) / 2
    assert_allclose(centre - Board.core.centre_mm, [[[1.0, 2.5, 10.0 - deep]]])
    assert_allclose(half, [[[2.0, 1.5, deep]]])
    assert_allclose(axes[0, 0], np.eye(3)[[1, 0, 2]])
