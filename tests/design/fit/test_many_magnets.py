"""Hundreds of magnets are checked in seconds: neighbours are measured, not all pairs."""

import time
from itertools import combinations

import numpy as np
import pytest

from design.errors import SpecError
from design.layout.pockets import distance_of_segments_mm, near_pairs
from design.spec_io import parse_spec

BODIES = {
    "box": {"size_mm": [60.0, 60.0, 60.0]},
    "capsule": {"kind": "capsule", "size_mm": [44.0, 44.0, 76.0]},
}


def test_near_pairs_are_those_of_all_pairs():
    rng = np.random.default_rng(5)
    ends = rng.uniform(-10, 10, size=(60, 1, 3)) + rng.normal(size=(60, 2, 3))
    reach = rng.uniform(0.1, 2.0, size=60)
    reach[7] = 6.0  # one that reaches far past the others
    wanted = {
        (a, b): distance_of_segments_mm(ends[a], ends[b])
        for a, b in combinations(range(60), 2)
        if distance_of_segments_mm(ends[a], ends[b]) <= reach[a] + reach[b]
    }
    found = {(a, b): away for a, b, away in near_pairs(list(ends), reach.tolist())}
    assert len(wanted) > 20
    assert found == pytest.approx(wanted)
    assert list(found) == sorted(found)


@pytest.mark.parametrize("body", BODIES)
def test_six_hundred_magnets_are_checked_in_ten_seconds(body):
    places = [
        [float(x), float(y)] for x in np.linspace(-12, 12, 25) for y in np.linspace(-12, 12, 24)
    ]
    content = {"name": "x", "body": BODIES[body], "magnets": {"positions_mm": places}}
    started = time.process_time()
    with pytest.raises(SpecError, match="touch or overlap"):
        parse_spec(content, "x")
    assert time.process_time() - started < 10


def test_two_magnets_at_one_place_are_refused():
    with pytest.raises(SpecError, match=r"names \(3, 4\) twice on one face"):
        parse_spec({"name": "x", "magnets": {"positions_mm": [[3, 4], [0, 0], [3, 4]]}}, "x")
