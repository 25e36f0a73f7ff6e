"""Chips that do not answer, answer in another's column, or give single wrong readings."""

import numpy as np
import pytest

from estimator.adoption.chips import clean_chips
from tests.support.recordings.foreign_logs import ForeignObject, make_log

LOG = make_log(ForeignObject(magnets_mm=((3.0, -2.0),)), shape=(3, 3), pitch=(13, 16), rows=20)
HALF = len(LOG.counts) // 3


def asked(clean):
    return {finding.question: finding for finding in clean.findings}


def test_a_sound_log_has_no_finding():
    clean = clean_chips(LOG.counts)
    assert clean.findings == ()
    np.testing.assert_array_equal(clean.counts, LOG.counts)


@pytest.mark.parametrize("silent", [(12, 13, 14), (3,)])
def test_silent_chips_are_named_with_their_rows(silent):
    counts = LOG.counts.copy()
    counts[:HALF, list(silent)] = 0
    clean = clean_chips(counts)
    found = asked(clean)["silent chips"]
    assert f"rows 0-{HALF - 1}" in found.answer
    assert "exactly 0" in found.evidence
    assert np.isnan(clean.counts[:HALF, list(silent)]).all()
    assert "columns moved" not in asked(clean)


def test_columns_that_moved_up_when_chips_were_skipped_go_back():
    """The object has chips whose levels differ: those that answer fit moved, not as written."""
    own = LOG.counts + np.random.default_rng(2).normal(0, 900, (1, 15, 3)).round()
    counts = own.copy()
    counts[:HALF, :12] = own[:HALF, 3:]
    counts[:HALF, 12:] = 0
    clean = clean_chips(counts)
    found = asked(clean)
    assert "chips 13-15" in found["silent chips"].answer
    assert "chips 1-3 are missing" in found["columns moved"].answer
    assert found["columns moved"].p < 0.02
    np.testing.assert_array_equal(clean.counts[:HALF, 3:], own[:HALF, 3:])
    assert np.isnan(clean.counts[:HALF, :3]).all()
    np.testing.assert_array_equal(clean.counts[HALF:], own[HALF:])


def test_a_frozen_chip_and_a_single_wrong_reading_are_named_and_left_out():
    counts = LOG.counts.copy()
    counts[50:90, 4] = (-8764, 16329, 1)
    counts[700, 7, 1] += 16000
    clean = clean_chips(counts)
    wrong = [finding.answer for finding in clean.findings if finding.question == "wrong readings"]
    assert any("chip 5, rows 50-89: (-8764, 16329, 1)" in text for text in wrong)
    assert any("chip 8 y, row 700" in text for text in wrong)
    assert np.isnan(clean.counts[50:90, 4]).all()
    assert np.isnan(clean.counts[700, 7, 1])
    assert np.isnan(clean.counts).sum() == 3 * 40 + 1


def test_moved_columns_of_a_log_whose_chips_are_shuffled_go_back_too():
    own = LOG.counts + np.random.default_rng(2).normal(0, 900, (1, 15, 3)).round()
    order = np.random.default_rng(3).permutation(15)
    counts = own.copy()
    counts[:HALF, :12] = own[:HALF, 3:]
    counts[:HALF, 12:] = 0
    clean = clean_chips(counts[:, order])
    assert "columns moved" in asked(clean)
    wanted = own.copy()
    wanted[:HALF, :3] = np.nan
    np.testing.assert_array_equal(clean.counts, wanted[:, order])
