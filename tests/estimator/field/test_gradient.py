"""Derivatives of the field by a source's motion: against the series itself, moved and turned."""

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose

from estimator.field.gradient import field_change
from estimator.field.models import multipole_field
from estimator.field.sources import DiskMagnet

RING = DiskMagnet(6.0, 1.5, 1.43, inner_diameter_mm=2.0)
STEP = 1e-4


def poses(count=7):
    rng = np.random.default_rng(4)
    offset, axis = rng.standard_normal((2, 3, count))
    offset *= rng.uniform(6, 14, count) / np.linalg.norm(offset, axis=0)
    return torch.as_tensor(offset), torch.as_tensor(axis / np.linalg.norm(axis, axis=0))


def moved(offset, axis, order, motion):
    """Field after a small rigid motion (mm, rad) of the source."""
    shift, turn = motion[:3, None], motion[3:, None]
    turned = axis + torch.linalg.cross(turn.expand_as(axis), axis, dim=0)
    return torch.stack(multipole_field(tuple(offset - shift), tuple(turned), RING, order))


@pytest.mark.parametrize("order", [1, 3, 7])
def test_field_and_derivatives_are_those_of_the_series(order):
    offset, axis = poses()
    found = field_change(offset, axis, RING, order)
    still = moved(offset, axis, order, torch.zeros(6, dtype=torch.float64))
    assert_allclose(found.field, still, rtol=0, atol=1e-13 * abs(still).max())
    for k, motion in enumerate(STEP * torch.eye(6, dtype=torch.float64)):
        differences = [moved(offset, axis, order, sign * motion) for sign in (1, -1)]
        wanted = (differences[0] - differences[1]) / (2 * STEP)
        assert_allclose(found.by_motion[:, k], wanted, rtol=0, atol=1e-7 * abs(wanted).max())


def test_a_dipole_s_derivative_is_a_quarter_wrong_at_most_ten_mm_away_and_order_7_a_thousandth():
    offset = torch.tensor([[0.0, 6.0, 10.0], [0, 0, 0], [10, 8, 0]], dtype=torch.float64)
    axis = torch.tensor([[0.0], [0.0], [1.0]], dtype=torch.float64).expand(3, 3)
    disk = DiskMagnet(6.0, 1.0, 1.43)
    best = field_change(offset, axis, disk, 25).by_motion
    miss = {o: abs(field_change(offset, axis, disk, o).by_motion - best).max() for o in (1, 7)}
    size = abs(best).max()
    assert 0.1 < miss[1] / size < 0.25
    assert miss[7] / size < 1e-3


def test_second_derivatives_come_from_autograd():
    offset, axis = (given.requires_grad_() for given in poses(2))

    def change(r, n):
        return 1e3 * field_change(r, n, RING, 5).by_motion

    assert torch.autograd.gradcheck(change, (offset, axis), eps=1e-5, atol=1e-6, rtol=1e-4)


def test_even_orders_are_refused():
    offset, axis = poses(1)
    with pytest.raises(ValueError, match="odd orders only; got 4"):
        field_change(offset, axis, RING, 4)
