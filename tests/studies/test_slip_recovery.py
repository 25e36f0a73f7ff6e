"""A slip found in the resting signals of a toleranced twin, and frames carried over to it."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.frames.press_protocol import simulate_presses
from estimator.tolerances.assembly import designed
from estimator.tolerances.virtual_object import drawn_assembly, twin_signals
from studies.paper.slip_recovery import FoundSlip, carried_over, slip_from_rest
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses
from tests.support.physics_pages import assert_page, chosen

SLIP = FoundSlip((0.7, -0.5, 0.6), (0.5, -1.0, 1.5), 0.0)


@pytest.fixture(scope="module")
def made():
    """Specification, presses, and signals of a twin before and after its core slipped."""
    spec = coarse_spec()
    presses, twin = synthetic_presses(spec), drawn_assembly(spec, 7)
    return (
        spec,
        presses,
        twin_signals(spec, twin, *presses),
        twin_signals(spec, SLIP.applied(twin), *presses),
    )


def test_the_slip_of_a_twin_is_found_from_its_rest(made):
    spec, _, before, after = made
    change = after.baseline_counts - before.baseline_counts
    change = change + np.random.default_rng(0).normal(0, 14, change.shape)
    change[4, 1] = np.nan
    found = slip_from_rest(spec, change, 14.0)
    assert_allclose(found.shift_mm, SLIP.shift_mm, rtol=0, atol=0.2)
    assert_allclose(found.rotation_deg, SLIP.rotation_deg, rtol=0, atol=1.0)
    assert found.left < 0.35


def test_no_slip_is_found_where_there_is_none(made):
    spec, _, before, _ = made
    noise = np.random.default_rng(1).normal(0, 14, before.baseline_counts.shape)
    found = slip_from_rest(spec, noise, 14.0)
    assert_allclose(found.shift_mm, 0.0, atol=0.05)
    assert_allclose(found.rotation_deg, 0.0, atol=0.3)


def test_frames_carried_over_are_those_after_the_slip(made):
    spec, presses, before, after = made
    frames, wanted = (simulate_presses(spec, signals, "x") for signals in (before, after))
    design = designed(spec)
    expected = [twin_signals(spec, one, *presses) for one in (design, SLIP.applied(design))]
    moved = carried_over(frames, *expected)
    pressed = frames.contact_face[:, 0] > 0

    def off(one):
        return np.sqrt(np.mean((one.signal_counts - wanted.signal_counts)[pressed] ** 2))

    assert off(moved) < 0.4 * off(frames)
    assert_allclose(moved.signal_counts[~pressed], frames.signal_counts[~pressed])


def test_contacts_add_up(made):
    """Two contacts at once are carried over by what the slip changes in each of them."""
    spec, presses, *_ = made
    design = designed(spec)
    before, after = (twin_signals(spec, one, *presses) for one in (design, SLIP.applied(design)))
    frames = simulate_presses(spec, before, "x")
    rows = [int(np.flatnonzero(frames.place_id == place)[20]) for place in (1002, 4007)]
    single = frames.select(np.array(rows))
    pair = replace(
        single.select(np.array([0])),
        **{
            name: np.concatenate([getattr(single, name)[:1], getattr(single, name)[1:]], axis=1)
            for name in ("contact_face", "contact_xy_mm", "force_n")
        },
    )
    changes = [
        carried_over(one, before, after).signal_counts - one.signal_counts for one in (single, pair)
    ]
    assert np.abs(changes[1]).max() > 20
    assert_allclose(changes[1][0], changes[0].sum(axis=0), atol=1e-6)


def test_a_slip_found_is_as_on_the_page(made):
    spec, _, before, after = made
    change = after.baseline_counts - before.baseline_counts + np.arange(45).reshape(15, 3)
    change[4, 1] = np.nan
    found = slip_from_rest(spec, change, 14.0)
    lines = chosen(found, "shift_mm", "rotation_deg", "left")
    assert_page("estimator/calibration", lines, "slip, ")
