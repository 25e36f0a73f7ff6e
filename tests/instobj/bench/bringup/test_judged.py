"""What recordings of a bring-up are judged by, with the judges made up: which recordings go where."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.spec.object import ObjectSpec
from estimator.tolerances.selftest import POOR_FIT, Fault, Hypothesis
from instobj.bench.bringup.diagnosis import levels
from instobj.bench.bringup.diagnosis.channels import signed_permutations
from instobj.bench.bringup.diagnosis.findings import ChipFound

SPEC = ObjectSpec(name="cube")


@pytest.mark.parametrize("turn", signed_permutations()[::7])
def test_levels_are_turned_back_to_the_axes_drawn_at_the_chip_s_place(turn):
    chips = [ChipFound(1, turn), ChipFound(0, np.eye(3))]
    field = np.array([[1.0, 2, 3], [4, 5, 6]])
    counts = np.stack([turn @ field[1], field[0]])
    assert_allclose(levels.turn_to_design(chips, counts), field)
    lame = counts.copy()
    lame[0, 1] = np.nan
    found = levels.turn_to_design(chips, lame)
    (lost,) = np.flatnonzero(abs(turn[1]) > 0.5)
    assert np.flatnonzero(np.isnan(found[1])).tolist() == [lost]
    assert_allclose(np.delete(found[1], lost), np.delete(field[1], lost))
    assert_allclose(found[0], field[0])


def test_flips_that_are_known_are_built_into_the_model_magnet_by_magnet():
    count = SPEC.magnets.count
    found = levels.with_flips(SPEC, [count, 1, 2 * count + 1]).as_built.magnets
    sensed = SPEC.body.sensed
    assert [(one.face, one.magnet, one.flipped) for one in found] == [
        (sensed[0], 2, True), (sensed[1], 1, True), (sensed[2], 2, True),
    ]  # fmt: skip


def test_levels_beyond_all_tolerances_are_told_as_such_below_a_thousandth():
    fault = Fault("flipped magnet", "F3-M1")
    assert levels.level_findings(Hypothesis((), 0.0, 0.5)) == []
    (told,) = levels.level_findings(Hypothesis((fault,), 12.34, POOR_FIT))
    assert (told.kind, told.where) == ("resting levels", "flipped magnet: F3-M1")
    assert told.measured == "ln of the odds 12.3, as far off with probability 0.001"
    (far,) = levels.level_findings(Hypothesis((fault,), 12.34, 0.99 * POOR_FIT))
    assert far.where == "object"
    assert far.measured.startswith("beyond all tolerances (ln of the odds 12.3")
