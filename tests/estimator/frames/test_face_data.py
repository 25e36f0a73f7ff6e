"""The part of a data set that concerns one face: its frames, channels, contacts and their centre."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from design.errors import InputError
from estimator.frames.face_data import channel_counts, face_data, live_channels
from tests.support.recordings.synthetic_frames import synthetic_frames

FACE = 4


@pytest.fixture(scope="module")
def frames():
    return synthetic_frames(presses=1, loaded=6, places=range(4))


def test_a_face_has_its_own_channels_unless_every_face_is_asked_for(frames):
    silent = frames.signal_counts.copy()
    silent[3, 3, 1, 2] = np.nan
    data = face_data(replace(frames, signal_counts=silent), FACE)
    own = live_channels(data)
    assert own == tuple((4, s, a) for s in range(3) for a in range(3) if (s, a) != (1, 2))
    every = live_channels(data, every_face=True)
    assert len(every) == 44
    assert {face for face, _, _ in every} == {1, 2, 3, 4, 5}
    wanted = [silent[:, face - 1, s, a] for face, s, a in own]
    assert_allclose(channel_counts(data.frames, own), np.stack(wanted, axis=1))
    for k in range(9):
        silent[k, 3, k // 3, k % 3] = np.nan
    dead = face_data(replace(frames, signal_counts=silent), FACE)
    with pytest.raises(InputError, match="every channel of face 4 misses"):
        live_channels(dead)


def test_frames_are_rest_contact_or_of_other_faces(frames):
    data = face_data(frames, FACE)
    assert (data.rest.sum(), data.contact.sum(), len(data)) == (32, 24, 80)
    assert_array_equal(data.rest, frames.contact_face[:, 0] == 0)
    assert_array_equal(data.contact, frames.contact_face[:, 0] == FACE)
    assert_allclose(
        data.heatmap_n.sum(axis=(1, 2))[data.contact], frames.force_n[data.contact, 0, 2]
    )
    assert_allclose(data.centre_mm[data.contact], frames.contact_xy_mm[data.contact, 0])
    assert np.isnan(data.centre_mm[~data.contact]).all()
    assert len(data.select(data.contact)) == 24


def test_a_centre_is_weighed_by_normal_forces_of_the_face_s_own_contacts(frames):
    row = int(np.flatnonzero(frames.contact_face[:, 0] == FACE)[0])
    contact = np.array([[4, 4, 2]])
    xy = np.array([[[0.0, 0.0], [3.0, -6.0], [9.0, 9.0]]])
    force = np.zeros((1, 3, 3))
    force[0, :, 2] = 1.0, 2.0, 50.0
    one = replace(
        frames.select(np.array([row])), contact_face=contact, contact_xy_mm=xy, force_n=force
    )
    assert_allclose(face_data(one, FACE).centre_mm, [[2.0, -4.0]])


def test_invalid_silent_and_faint_frames_are_left_out(frames):
    pressed = np.flatnonzero(frames.contact_face[:, 0] == FACE)
    valid, force, signal = frames.valid.copy(), frames.force_n.copy(), frames.signal_counts.copy()
    valid[0] = False
    force[pressed[0], 0, 2] = 0.0
    force[pressed[1], 0, 2] = np.nan
    signal[1, 3] = np.nan
    signal[2, 2] = np.nan
    data = face_data(replace(frames, valid=valid, force_n=force, signal_counts=signal), FACE)
    kept = np.setdiff1d(np.arange(len(frames)), [0, 1, pressed[0], pressed[1]])
    assert_allclose(data.frames.time_s, frames.time_s[kept])
    with pytest.raises(InputError, match="face 7 is not in the data set"):
        face_data(frames, 7)
    with pytest.raises(InputError, match="no valid frame with readings of face 4"):
        face_data(replace(frames, valid=np.zeros(len(frames), bool)), FACE)
