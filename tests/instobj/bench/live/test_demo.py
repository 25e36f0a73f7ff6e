"""The simulated hand of the demo: touches within the object, counts of its forward model."""

from functools import lru_cache

import numpy as np
import pytest

from estimator.recordings.boards.lines import Frame, LineDecoder, Load, encode_header
from instobj.bench.live.demo import hand_lines, simulated_hand
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

SPEC = coarse_spec()


@lru_cache(maxsize=1)
def presses():
    return synthetic_presses(SPEC)


@lru_cache(maxsize=1)
def hand():
    return simulated_hand(SPEC, *presses())


def test_contacts_lie_on_the_faces_and_press_as_hard_as_the_table_knows():
    forces, _ = presses()
    there = hand().face >= 0
    assert hand().face.max() < len(hand().faces)
    assert np.abs(hand().contact[there, :2]).max() < abs(forces.lattice.x_mm).max()
    assert 3.0 < hand().contact[there, 2].max() < forces.force_n.max()
    together = there.sum(axis=1)
    assert set(together) == {0, 1, 2, 3}


def test_rest_reads_as_the_baseline_and_a_press_as_its_own_signals():
    quiet = ~(hand().face >= 0).any(axis=1)
    assert quiet.mean() > 0.1
    rest = hand().counts[quiet]
    np.testing.assert_allclose(rest - rest[0], 0.0, atol=1e-6)
    moved = np.abs(hand().counts - rest[0]).max(axis=1)
    force = np.where(hand().face >= 0, hand().contact[..., 2], 0.0).sum(axis=1)
    assert moved[force > 3].min() > 2 * hand().noise_counts.max()


def test_lines_decode_to_the_counts_with_the_chips_noise():
    rng, decoder, names = np.random.default_rng(1), LineDecoder(), []
    for face in hand().faces:
        names += [f"F{face}-{axis}{chip}" for chip in (1, 2, 3) for axis in "XYZ"]
    decoder.feed(encode_header(names))
    read, loads = [], []
    for number in range(400):
        for message in decoder.feed(hand_lines(hand(), number, rng)):
            (read if isinstance(message, Frame) else loads).append(message)
    assert decoder.statistics.damaged_lines == decoder.statistics.lost_frames == 0
    noise = np.array([one.counts for one in read]) - hand().counts[0]  # 2 s of rest
    np.testing.assert_allclose(noise.std(axis=0), hand().noise_counts, rtol=0.15)
    assert abs(noise.mean(axis=0) / hand().noise_counts).max() < 5 / 20
    assert len(loads) == 3 * 80
    assert all(isinstance(one, Load) and one.face == 0 for one in loads)


def test_the_true_contacts_are_told_as_a_load_cells():
    knot = int(np.argmax((hand().face >= 0).sum(axis=1)))
    number = knot * 5
    decoder = LineDecoder()
    loads = [
        one
        for one in decoder.feed(hand_lines(hand(), number, np.random.default_rng(1)))
        if isinstance(one, Load)
    ]
    slots = np.flatnonzero(hand().face[knot] >= 0)
    assert [one.face for one in loads] == [int(hand().faces[f]) for f in hand().face[knot, slots]]
    for one, (x, y, force_n) in zip(loads, hand().contact[knot, slots], strict=True):
        assert one.tips_mm == (pytest.approx((x, y), abs=1e-3),)
        assert one.force_n == pytest.approx(force_n, abs=1e-3)
