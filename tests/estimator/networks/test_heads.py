"""What the heads of a network say, its loss, and what an estimator makes of its members, by hand."""

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose
from torch import nn

from estimator.networks.intervals.coverage import WHOLLY_NEW_FROM, Coverage, gp_weight
from estimator.networks.network import ContactEstimator, HeadsNetwork, Reading
from estimator.networks.training.data import Batch
from estimator.networks.training.losses import heads_loss

GRID_X_MM, GRID_Y_MM = np.array([-0.5, 0.5]), np.array([-3.0, 0.0, 3.0])


def heads_network(bias, **options):
    """Two channels, 2 × 3 pixels; the heads say `bias` whatever comes in."""
    network = HeadsNetwork(np.ones(2), GRID_X_MM, GRID_Y_MM, (4,), 10.0, **options)
    with torch.no_grad():
        network.heads.weight.zero_()
        network.heads.bias.copy_(torch.tensor(bias))
    return network


LOGITS = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0]


def test_heads_are_shares_force_contact_place_and_spreads_in_their_units():
    heads = heads_network([*LOGITS, 0.3, -0.7, 0.5, -1.0, 1.2, -0.4]).heads_of(torch.zeros(1, 2))
    assert_allclose(heads.share_logits[0].detach(), LOGITS)
    assert heads.force.item() == pytest.approx(np.log1p(np.exp(0.3)))
    assert heads.contact_logit.item() == pytest.approx(-0.7)
    assert_allclose(heads.xy_mm[0].detach(), [0.5 * 1.0, -3.0])  # a narrow grid counts as ±1 mm
    soft = np.log1p(np.exp([1.2, -0.4]))
    assert heads.force_spread.item() == pytest.approx(0.1 * soft[0], rel=0.02)
    assert heads.position_spread_mm.item() == pytest.approx(soft[1], rel=0.02)


def test_tangential_forces_come_before_the_normal_one_and_keep_their_sign():
    bias = [*LOGITS, -0.6, 0.4, 0.3, -0.7, 0.5, -1.0, 1.2, -0.4]
    heads = heads_network(bias, axes=3).heads_of(torch.zeros(1, 2))
    assert_allclose(heads.force[0].detach(), [-0.6, 0.4, np.log1p(np.exp(0.3))], rtol=1e-6)


def test_continuous_shares_are_a_spot_about_the_place():
    """Of one pitch across x and three along y between neighbours."""
    network = heads_network([*LOGITS, 0.3, -0.7, 0.5, -1.0, 1.2, -0.4], continuous=True)
    logits = network.heads_of(torch.zeros(1, 2)).share_logits[0].detach().numpy()
    pixels = np.array([[x, y] for x in GRID_X_MM for y in GRID_Y_MM])
    away = ((pixels - [0.5, -3.0]) / [1.0, 3.0]) ** 2
    assert logits.max() == pytest.approx(0)
    assert_allclose(logits / logits[1], away.sum(axis=1) / away.sum(axis=1)[1], atol=1e-6)
    assert (logits <= 1e-9).all()


def test_faint_shares_go_and_the_others_are_one_together():
    network = heads_network([*LOGITS, 0.3, -0.7, 0.5, -1.0, 1.2, -0.4])
    network.near.copy_(torch.eye(6))
    network.faint.fill_(0.2)
    share = torch.tensor([[0.5, 0.15, 0.1, 0.09, 0.16, 0.0]])
    found = network.gathered(share, torch.log(share + 1e-30))
    kept = np.array([0.5, 0.15 * 0.5, 0.0, 0.0, 0.16 * 0.6, 0.0])
    assert_allclose(found[0], kept / kept.sum(), atol=1e-5)


def test_the_loss_of_heads_is_the_sum_of_its_parts():
    network = heads_network([*LOGITS, 0.3, -0.7, 0.5, -1.0, 1.2, -0.4])
    counts = torch.zeros(2, 2)
    share = torch.tensor([[0.0, 0.0, 0.0, 0.0, 0.25, 0.75], [0.0] * 6])
    target = Batch(
        counts, share, share, torch.tensor([[0.49], [0.0]]), torch.tensor([1.0, 0.0]),
        torch.tensor([[0.3, 1.0], [0.0, 0.0]]),
    )  # fmt: skip
    heads = network.heads_of(counts)
    missed = abs(np.log1p(np.exp(0.3)) - np.array([0.49, 0.0]))
    away = np.sqrt(np.array([0.2**2 + 4.0**2, 0.5**2 + 3.0**2]) + 1e-6)
    force_spread, spread_mm = heads.force_spread[0].item(), heads.position_spread_mm[0].item()
    sizes = np.log(force_spread) + missed / force_spread + np.log(spread_mm) + away / spread_mm
    log_share = np.array(LOGITS) - np.log(np.exp(LOGITS).sum())
    touch = np.log1p(np.exp(-0.7)) + np.array([0.7, 0.0])
    wanted = 8 * missed.mean() + touch.mean() + 0.3 * 0.7 * away[0] / 2 + 0.1 * sizes[0] / 2
    placed = wanted - 0.7 * (0.25 * log_share[4] + 0.75 * log_share[5]) / 2
    assert heads_loss(network, counts, target).item() == pytest.approx(placed, rel=1e-5)
    spot = heads_network([*LOGITS, 0.3, -0.7, 0.5, -1.0, 1.2, -0.4], continuous=True)
    assert heads_loss(spot, counts, target).item() == pytest.approx(wanted, rel=1e-5)


class Said(nn.Module):
    """A member, trees or a process that says the same of every frame."""

    def __init__(self, answer):
        super().__init__()
        self.answer = answer
        grid = np.stack(np.meshgrid(GRID_X_MM, GRID_Y_MM, indexing="ij"), -1).reshape(-1, 2)
        self.register_buffer("grid_mm", torch.tensor(grid).float())

    def forward(self, counts):
        return self.answer


def member(force_n, xy_mm, contact, halfwidth_n, radius_mm):
    heatmap = torch.zeros(1, 1, 2, 3)
    heatmap[0, 0, 1, 2] = force_n
    one = torch.ones(1)
    return Said(
        Reading(
            heatmap, force_n * one, torch.tensor([xy_mm]), contact * one, halfwidth_n * one,
            radius_mm * one, 0 * one,
        )
    )  # fmt: skip


def estimator(novelty, **parts):
    coverage = Coverage(2, 1)
    coverage.reference.copy_(torch.zeros(1, 2))
    coverage.forward = lambda counts: torch.tensor([novelty])
    coverage.force_slope_n.fill_(0.5)
    coverage.place_slope_mm.fill_(0.25)
    members = [member(4.0, [0.2, 1.0], 1.0, 0.3, 0.1), member(6.0, [0.4, 2.0], 0.5, 0.5, 0.3)]
    made = ContactEstimator(members, coverage)
    for name, part in parts.items():
        setattr(made, name, part)
    made.force_quantile.fill_(2.0)
    made.position_quantile.fill_(3.0)
    return made


def test_members_are_averaged_and_novelty_widens_their_intervals():
    found = estimator(1.0)(torch.zeros(1, 2))
    assert found.force_n.item() == pytest.approx(5.0)
    assert_allclose(found.xy_mm[0], [0.3, 1.5], rtol=1e-6)
    assert found.force_halfwidth_n.item() == pytest.approx(0.8)
    assert found.position_radius_mm.item() == pytest.approx(0.6)
    novel = estimator(5.0)(torch.zeros(1, 2))
    assert novel.force_halfwidth_n.item() == pytest.approx(0.8 + 0.5 * 2)
    assert novel.position_radius_mm.item() == pytest.approx(0.6 + 0.25 * 2)
    furthest = np.hypot(0.8, 4.5)
    assert estimator(4e4)(torch.zeros(1, 2)).position_radius_mm.item() == pytest.approx(furthest)


def test_trees_take_their_share_less_where_contact_is_in_doubt():
    trees = Said((torch.tensor([9.0]), torch.tensor([[-0.5, 0.0]])))
    made = estimator(1.0, forest=trees)
    made.force_share.fill_(0.4)
    made.place_shares.copy_(torch.tensor([0.5, 0.3, 0.2]))
    found = made(torch.zeros(1, 2))
    trusted = 9 * 0.75**2
    assert found.force_n.item() == pytest.approx(0.6 * 5 + 0.4 * trusted)
    centre = 0.5 * np.array([0.3, 1.5]) + 0.3 * np.array([0.5, 3.0]) + 0.2 * np.array([-0.5, 0.0])
    assert_allclose(found.xy_mm[0], centre, rtol=1e-6)
    assert found.heatmap_n.sum().item() == pytest.approx(found.force_n.item())


@pytest.mark.parametrize("novelty", [1.0, 1.25, 1.5, WHOLLY_NEW_FROM, 9.0])
def test_a_process_answers_as_far_as_a_frame_is_new(novelty):
    process = Said((torch.tensor([1.0]), torch.tensor([[-0.5, -1.0]])))
    found = estimator(novelty, process=process)(torch.zeros(1, 2))
    share = min(max(novelty - 1.0, 0.0), 1.0)
    new = share**2 * (3 - 2 * share)
    assert gp_weight(torch.tensor([novelty])).item() == pytest.approx(new)
    assert found.force_n.item() == pytest.approx(5 + new * (1 - 5))
    assert_allclose(found.xy_mm[0], np.array([0.3, 1.5]) + new * np.array([-0.8, -2.5]), atol=1e-6)
    assert found.force_halfwidth_n.item() == pytest.approx((1 - new) * 0.8 + 0.5 * new)
    assert found.position_radius_mm.item() == pytest.approx((1 - new) * 0.6 + 0.25 * new)
    assert found.novelty.item() == novelty
