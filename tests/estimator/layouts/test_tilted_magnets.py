"""Tilted magnets turn with the silicone's plane that they lie in, not with that of the face."""

from dataclasses import replace

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from design.layout.body import face_frames
from design.spec.object import ContactGridSpec
from estimator.layouts.batch import layouts_of
from estimator.layouts.presses.basis import press_basis
from estimator.layouts.presses.mixed_rows import interpolate_motion_rows
from tests.support.mechanics.candidate_cases import at_contacts, made_up_motions
from tests.support.objects.search_cases import made_up_spec

FACE = 1
SLOPES = np.array([[0.3, -0.2, 0.5], [0.1, -0.1, 0.2], [-0.4, 0.6, -0.2]]) * 1e-3


def turned(slopes, turn_rad, share):
    """½ curl u + share · E n × n about the axis n of a magnet, which nothing tilted."""
    curl = np.array(
        [slopes[2, 1] - slopes[1, 2], slopes[0, 2] - slopes[2, 0], slopes[1, 0] - slopes[0, 1]]
    )
    axis = Rotation.from_rotvec([*turn_rad, 0.0]).as_matrix()[:, 2]
    return curl / 2 + share * np.cross((slopes + slopes.T) / 2 @ axis, axis)


@pytest.fixture(scope="module")
def spec():
    """A cube with few places: compressing the table of a hundred takes most of the time."""
    return made_up_spec().changed(contact_grid=ContactGridSpec(count=(4, 3), pitch_mm=6.0))


def motions_in_even_strain(spec, share):
    """The same slopes everywhere, in the pressed face's frame; presses differ in size alone."""
    table = made_up_motions(spec)
    frame = face_frames(spec)[FACE - 1]
    lattice = table.candidates[FACE - 1]
    assert lattice.face == FACE
    local = lattice.xyd_mm * [1, 1, -1]
    moved = np.concatenate(
        [
            local @ SLOPES.T @ frame.axes.T,
            np.tile(turned(SLOPES, (0, 0), share), (len(local), 1)) @ frame.axes.T,
        ],
        axis=1,
    )
    size = table.force_n[FACE - 1] * np.linspace(1.0, 2.0, table.force_n.shape[1])[:, None]
    own, presses = np.array(table.by_candidate), np.array(table.presses)
    first = sum(map(len, table.candidates[: FACE - 1]))
    own[first : first + len(local), FACE - 1] = 0
    own[first : first + len(local), FACE - 1, 0] = moved
    presses[FACE - 1, :, :, 0] = size
    strained = replace(table, by_candidate=own, presses=presses, jeffery_parameter=share)
    return strained, at_contacts(spec, size)


@pytest.mark.parametrize("share", [pytest.param(0.0, marks=pytest.mark.slow), 0.64])
def test_in_even_strain_a_tilted_magnet_turns_by_jefferys_law(spec, share):
    motions, size = motions_in_even_strain(spec, share)
    presses = press_basis(spec, motions, FACE, dtype=torch.float64)
    layouts = layouts_of(spec, FACE, torch.float64)
    turns = np.deg2rad([[0, 0], [0.06, 0], [0, 0.06], [-0.05, 0.07], [0.08, 0.04]])
    layouts = replace(layouts, turn_rad=torch.as_tensor(turns[None]))
    own, _ = interpolate_motion_rows(presses, layouts)
    unfolded = (own.reshape(len(turns), 6, -1) @ presses.own_table.basis).reshape(
        len(turns), 6, 4, -1
    )
    found = (unfolded[:, 3:, 3] / torch.as_tensor(size.mean(axis=1))).mean(dim=2).numpy()
    wanted = np.array([turned(SLOPES, turn, share) for turn in turns])
    assert_allclose(found[0], wanted[0], rtol=0, atol=1e-5 * np.linalg.norm(SLOPES))
    change = wanted[1:] - wanted[0]
    assert_allclose(found[1:] - found[0], change, rtol=0, atol=0.02 * abs(change).max() + 1e-9)
