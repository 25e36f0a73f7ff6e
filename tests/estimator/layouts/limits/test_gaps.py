"""Gaps of a batch against those that `design.layout` has, one pair at a time."""

from itertools import combinations

import numpy as np
import torch
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from design.body.surface_chart import flat_frame
from design.body.triangles import Block
from design.layout.boards import gap_mm
from design.layout.pockets import (
    Body,
    Outline,
    Pocket,
    axis_in_object_mm,
    distance_of_segments_mm,
    tilted_frame,
)
from estimator.layouts.limits.gaps import (
    missing_between_boxes_mm,
    missing_between_prisms_mm,
    shortest_way,
)
from tests.support.objects.pocket_gaps import gap_across_edge_mm

RADIUS, LEAST = 2.5, 1.0


def test_ways_between_segments_are_the_design_s():
    rng = np.random.default_rng(1)
    ends = rng.uniform(-1, 1, (4, 3, 50))
    ends[:, :, 0] = [[0, 0, 0], [2, 0, 0], [1, 3, 0], [5, 3, 0]]  # parallel
    way = shortest_way(*torch.as_tensor(ends)).numpy()
    wanted = [distance_of_segments_mm(ends[:2, :, k], ends[2:, :, k]) for k in range(ends.shape[2])]
    assert_allclose(np.linalg.norm(way, axis=0), wanted, atol=1e-9)


def test_boxes_lack_what_their_gaps_lack():
    """Layouts of five boxes, turned at random, some of them far from the others."""
    rng = np.random.default_rng(2)
    centre = rng.uniform(-6, 6, (8, 5, 3))
    axes = Rotation.random(40, random_state=3).as_matrix().reshape(8, 5, 3, 3)
    axes[0] = np.eye(3)
    half = rng.uniform(0.5, 2.5, (8, 5, 3))
    for halves in (half, np.array([1.0, 2.0, 0.5])):
        each = np.broadcast_to(halves, half.shape)
        found = missing_between_boxes_mm(
            torch.as_tensor(centre), torch.as_tensor(axes), torch.as_tensor(halves), LEAST
        )
        blocks = [
            [Block(c, a.T, h) for c, a, h in zip(*row, strict=True)]
            for row in zip(centre, axes, each, strict=True)
        ]
        wanted = [
            sum(max(0.0, LEAST - gap_mm(a, b)) for a, b in combinations(row, 2)) for row in blocks
        ]
        assert_allclose(found, wanted, atol=1e-6)
        assert max(wanted) > 1


def test_prisms_of_two_faces_lack_what_the_gaps_across_their_edge_lack():
    rng = np.random.default_rng(4)
    frames = [flat_frame(number, np.array([13.0, 13.0, 13.0])) for number in (1, 3)]
    radii = torch.as_tensor(RADIUS * rng.uniform(0.6, 1.4, 12))
    outlines = [Outline((radius, radius), True) for radius in radii.tolist()]
    pockets = [
        [
            Pocket(
                Body(
                    np.array([*rng.uniform(-11, 11, 2), -3.0]),
                    tilted_frame(*rng.uniform(-25, 25, 2)),
                    outline,
                    2.0,
                    "a magnet",
                ),
                outline,
            )
            for outline in outlines
        ]
        for _ in frames
    ]
    prisms = []
    for frame, made in zip(frames, pockets, strict=True):
        ends = np.stack([axis_in_object_mm(frame, one) for one in made])
        axis = np.stack([frame.axes @ one.axis for one in made])
        parts = ends[:, 0].T, ends[:, 1].T, axis.T
        prisms.append(tuple(torch.as_tensor(part.copy())[:, None, None] for part in parts))
    found = missing_between_prisms_mm(*prisms, radii, LEAST)[0, 0].numpy()
    wanted = np.array(
        [
            [max(0.0, LEAST - gap_across_edge_mm(frames[0], a, frames[1], b)) for b in pockets[1]]
            for a in pockets[0]
        ]
    )
    assert_allclose(found, wanted, atol=1e-5)
    assert 3 < np.count_nonzero(wanted) < 140
