"""What magnets of one face take from each other, in batches: against sums over pairs by hand."""

from dataclasses import replace

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose

from estimator.layouts.presses.basis import press_basis
from estimator.layouts.presses.mixed_rows import influences, interpolate_motion_rows
from fem.candidates.influence import strains_turned
from fem.candidates.motions import Influence
from tests.support.mechanics.candidate_cases import FACE, at_contacts, random_layouts

COUNT = 3


@pytest.fixture(scope="module")
def held(spec, motions):
    """Made-up strain, smooth over candidates, and influences that are straight over depths and distance."""
    rng = np.random.default_rng(2)
    depth = motions.candidates[0].depth_mm
    slopes = rng.normal(size=(4, 6, 5))
    parts = np.meshgrid(depth, depth, 6.0 + 2.0 * np.arange(20), indexing="ij")
    values = sum(
        part[..., None, None] * one
        for part, one in zip([1 + 0 * parts[0], *parts], slopes, strict=True)
    )
    xyd = np.concatenate([one.xyd_mm for one in motions.candidates])
    shape = rng.normal(size=(4, motions.presses.shape[3], 5))
    strain = np.einsum("ck,krs->crs", np.column_stack([0 * xyd[:, :1] + 1, xyd / 10]), shape)
    table = Influence(depth, 6.0, 2.0, np.float32(values))
    return replace(motions, strain=np.float32(1e-2 * strain), influence=table), slopes


def by_hand(slopes, magnet_mm):
    """Motion of magnet i for each strain round j."""
    found = np.zeros((len(magnet_mm), len(magnet_mm), 6, 5))
    for i, (x, y, depth) in enumerate(magnet_mm):
        for j, (x_j, y_j, depth_j) in enumerate(magnet_mm):
            if i != j:
                distance, angle = np.hypot(x - x_j, y - y_j), np.arctan2(y - y_j, x - x_j)
                matrix = np.tensordot([1.0, depth_j, depth, max(distance, 6.0)], slopes, 1)
                turn = np.eye(3)
                turn[:2, :2] = strains_turned(angle)[1:3, 1:3]
                found[i, j] = np.kron(np.eye(2), turn) @ matrix @ strains_turned(angle).T
    return found


def test_influences_are_those_of_the_table_turned_from_one_magnet_to_the_other(spec, held):
    motions, slopes = held
    presses, layouts = press_basis(spec, motions, FACE, dtype=torch.float64), random_layouts(COUNT)
    layouts = replace(layouts, magnet_mm=layouts.magnet_mm.double())
    found = influences(presses.held, layouts.magnet_mm).numpy()
    for row in range(COUNT):
        wanted = by_hand(slopes, layouts.magnet_mm[row].numpy())
        assert_allclose(found[row], wanted, rtol=0, atol=1e-4 * abs(wanted).max())


def test_rows_have_what_the_other_magnets_strain_adds(spec, motions, held):
    """Unfolded to places, in presses to the score's force."""
    told, slopes = held
    layouts = random_layouts(COUNT, dtype=torch.float64)
    with_it, without = (
        press_basis(spec, given, FACE, own_rank=90, dtype=torch.float64)
        for given in (told, motions)
    )
    rows, plain = (
        interpolate_motion_rows(one, random_layouts(COUNT, dtype=torch.float64))[0]
        for one in (with_it, without)
    )
    added = (rows - plain).reshape(COUNT, 5, 6, -1) @ with_it.own_table.basis
    added = added.unflatten(3, (4, -1))[..., 3, :].numpy()
    node, weight = told.weights(FACE, layouts.magnet_mm.reshape(-1, 3).numpy())
    lattice = np.einsum("mk,mkrs->mrs", weight, told.strain[node]).reshape(COUNT, 5, -1, 5)
    shares = told.presses[FACE - 1].mean(axis=1)  # of 0.8 and 1.2 times the force
    strain = np.einsum("lmrs,pr->lmsp", lattice, at_contacts(spec, shares))
    for row in range(COUNT):
        at = layouts.magnet_mm[row].numpy()
        matrix = by_hand(slopes, at)
        wanted = np.einsum("ijms,jsp->imp", matrix, strain[row])
        off = abs(added[row] - wanted).max() / abs(wanted).max()
        assert off < 1e-5
