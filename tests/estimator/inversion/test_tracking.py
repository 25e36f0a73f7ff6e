"""Contacts followed from frame to frame, and the file and the noise of the estimator."""

from dataclasses import replace

import h5py
import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError, StoreError
from estimator.deploy.live_contacts import LiveContacts
from estimator.inversion.model.noise import MESH_ERROR, SUM_ERROR, design_error, disturbances
from estimator.inversion.problems import BLIND
from estimator.inversion.storage import is_inversion, load_inversion, save_inversion
from estimator.inversion.tracking import Tracker
from estimator.recordings.checks.stream import SoundReadings
from estimator.signals.hall import full_scale_counts
from tests.support.mechanics.inverted import SPEC, contacts, inverted, noisy_counts, presses


def press_over_time():
    """Rest, a press that grows and slides, a second on another face, then only that, then rest."""
    frames = 60
    face, contact = np.full((frames, 6), -1), np.zeros((frames, 6, 3))
    for row in range(frames):
        if 8 <= row < 44:
            face[row, 0] = 2
            contact[row, 0] = [-4 + 0.2 * (row - 8), 3.0, min(6.0, 0.8 * (row - 7))]
        if 24 <= row < 52:
            slot = 1 if row < 44 else 0
            face[row, slot], contact[row, slot] = 4, [5.0, -2.0, 6.0]
    return face, contact


@pytest.fixture(scope="module")
def followed():
    face, contact = press_over_time()
    counts = noisy_counts(inverted(), face, contact, np.random.default_rng(1), turned=False)
    tracker = Tracker(inverted())
    return face, contact, counts, [tracker.feed(frame) for frame in counts], tracker


def test_contacts_appear_slide_and_vanish(followed):
    face, contact, _, found, _ = followed
    true = (face >= 0).sum(axis=1)
    number = np.array([one.number[0] for one in found])
    steady = np.ones(len(true), bool)
    steady[8:11] = False  # below 2.5 N the first may go unseen
    assert np.mean(number[steady] == true[steady]) >= 0.95
    slid = [
        one.xy_mm[0, one.face[0] == 3][0] - contact[row, 0, :2]
        for row, one in enumerate(found[14:44], start=14)
        if 3 in one.face[0]
    ]
    assert np.median(np.linalg.norm(slid, axis=1)) < 0.5


def test_tracking_rarely_starts_anew(followed):
    *_, tracker = followed
    assert tracker.seen_anew <= 6


def test_odds_of_the_last_try_stand_while_the_next_one_waits(monkeypatch):
    """A faint contact: every try says 0.6, the first wait is one frame, the next three."""
    tracker, tried = Tracker(inverted()), []

    def changed(_, same):
        tried.append(len(told))
        return same, np.array([0.6])

    monkeypatch.setattr(tracker, "faint_contacts", lambda _: True)
    monkeypatch.setattr(tracker, "has_changed", changed)
    counts, told = np.zeros(inverted().model.channels), []
    for _ in range(6):
        told.append(float(tracker.feed(counts).odds[0]))
    assert tried == [0, 2]
    assert told == [0.6] * 6


def test_jaws_get_their_tips_together_and_a_third_contact_needs_more_than_noise():
    """One tip a jaw, then two: both appear in one frame. A weak third one is taken for noise where
    two jaws press, and read where nothing is known."""
    free = inverted()
    jaws = replace(free, priors=replace(free.priors, paired=True))
    face, contact = np.full((3, 6), -1), np.zeros((3, 6, 3))
    face[:, :2], contact[:, :2] = [1, 3], [[-6.0, 2.0, 6.0], [5.0, -6.0, 6.0]]
    face[1, 2:4], contact[1, 2:4] = [1, 3], [[7.0, -3.0, 6.0], [-6.0, 6.0, 6.0]]
    face[2, 2], contact[2, 2] = 2, [0.0, 0.0, 2.7]
    counts = noisy_counts(free, face, contact, np.random.default_rng(11), turned=False)
    tracker = Tracker(jaws)
    assert [int(tracker.feed(frame).number[0]) for frame in counts[:2]] == [2, 4]
    assert [int(one.read(counts[2:])[0].number[0]) for one in (free, jaws)] == [3, 2]
    seen = free.disturbances.observed(counts[1:2])
    found = jaws.search.contacts(seen)
    of_jaws = found.problems.select(found.best())
    for estimator, anew in ((free, 0), (jaws, 1)):
        tracker = Tracker(estimator)
        tracker.has_changed(seen, of_jaws)
        assert tracker.seen_anew == anew


def test_the_zero_is_taken_from_rest(followed):
    _, _, counts, _, _ = followed
    raw = np.random.default_rng(2).integers(-500, 500, 45) + counts
    reader = LiveContacts(inverted(), "first", 8)
    read = [reader.feed(frame.reshape(5, 3, 3), row / 10) for row, frame in enumerate(raw)]
    assert all(one is None for one in read[:8])
    told = read[40]
    assert told.number[0] == 2
    own = np.flatnonzero(told.face[0] == 5)[0]
    assert np.linalg.norm(told.xy_mm[0, own] - [5, -2]) < 2.0
    following = LiveContacts(inverted(), "rest", 8)
    last = [following.feed(frame.reshape(5, 3, 3), row / 10) for row, frame in enumerate(raw)]
    assert last[40].number[0] == 2
    assert last[-1].number[0] == 0


def test_a_channel_at_the_end_of_its_range_says_nothing(followed):
    """The channels of the chip that the press changes most begin 30 counts from the end of their range."""
    _, _, counts, _, _ = followed
    most = full_scale_counts(SPEC.sensors)
    channel = 3 * (int(abs(counts[20]).argmax()) // 3) + np.arange(3)
    raw = counts.copy()
    raw[:, channel] += np.sign(counts[20, channel]) * (most - 30.0)
    raw = np.clip(raw, -most, most)
    assert np.any(abs(raw[20, channel]) == most)
    reader = LiveContacts(inverted(), "first", 8)
    read = [reader.feed(frame.reshape(5, 3, 3), row / 10) for row, frame in enumerate(raw)]
    for row in (16, 18, 20, 22):
        assert read[row].explained[0]
        assert read[row].number[0] == 1
        wanted = [-4 + 0.2 * (row - 8), 3.0]
        assert np.linalg.norm(read[row].xy_mm[0, read[row].face[0] == 3][0] - wanted) < 2.0


def test_a_still_level_and_its_opposite_are_read_each_by_itself():
    """The zero asks for both in turn: what one reads must not depend on the other."""
    face, contact = np.full((1, 6), -1), np.zeros((1, 6, 3))
    face[0, :2], contact[0, :2] = [2, 4], [[2.0, 3.0, 6.0], [-3.0, 1.0, 6.0]]
    (counts,) = noisy_counts(inverted(), face, contact, np.random.default_rng(4), turned=False)
    reader = LiveContacts(inverted(), "none")
    read = [reader.read_still(sign * counts) for sign in (1, -1) * 6]
    assert read[0::2] == [read[0]] * 6
    assert read[1::2] == [read[1]] * 6
    assert read[0][1] > 3.0


def test_at_rest_a_contact_is_unlikely():
    """The share that the zero follows: near 0 at rest, near 1 under a press, between them always."""
    face, contact = np.full((8, 6), -1), np.zeros((8, 6, 3))
    face[4:, 0], contact[4:, 0] = 1, [2.0, -4.0, 5.0]
    counts = noisy_counts(inverted(), face, contact, np.random.default_rng(2), turned=False)
    reader = LiveContacts(inverted(), "none")
    share, force = np.transpose([reader.read_still(frame)[:2] for frame in counts])
    assert (share[:4] < 0.5).all()
    assert (share[4:] > 0.5).all()
    assert ((share >= 0) & (share <= 1)).all()
    assert_allclose(force[:4], 0)
    assert_allclose(force[4:], 5.0, rtol=0.3)


def test_readings_of_another_object_are_refused():
    with pytest.raises(InputError, match="reads 3 sensors on faces"):
        LiveContacts(inverted(), "none").feed(np.zeros((5, 2, 3)))
    missing = np.zeros((5, 3, 3))
    missing[2, 1, 0] = np.nan
    with pytest.raises(InputError, match="F3-X2, which the model uses, gives no reading"):
        LiveContacts(inverted(), "none").feed(missing)


def standing_chip(seed):
    """Two seconds of rest, then a press of 5 N, in raw counts; chip F2-S2 keeps its first reading."""
    frames = 60
    face, contact = np.full((frames, 6), -1), np.zeros((frames, 6, 3))
    face[30:, 0], contact[30:, 0] = 1, [2.0, -4.0, 5.0]
    rng = np.random.default_rng(seed)
    counts = noisy_counts(inverted(), face, contact, rng, turned=False).reshape(frames, 5, 3, 3)
    raw = np.round(counts + rng.uniform(-900, 900, (5, 3, 3)))
    raw[:, 1, 1] = raw[0, 1, 1] + [400.0, -300.0, 250.0]
    return raw


def test_a_chip_that_stands_still_makes_no_contacts():
    """It is left out as a recording's is: without that, the press that it does not feel makes ghosts."""
    numbers = {}
    for checked in (False, True):
        found = []
        for seed in range(3):
            reader, sound = LiveContacts(inverted(), "first", 20), SoundReadings()
            for raw in standing_chip(seed):
                out = np.isnan(sound.known(raw))
                found.append(reader.feed(raw, left_out=out if checked else None))
        read = [one.number[0] for one in found if one is not None]
        true = np.tile(np.repeat([0, 1], [10, 30]), 3)[: len(read)]
        numbers[checked] = np.mean(np.array(read) == true)
    assert numbers[True] >= 0.98 > numbers[False]


def test_a_channel_that_stood_still_while_zeroed_waits_for_the_next_zero():
    rng = np.random.default_rng(5)
    raw = np.round(rng.normal(0, 20, (80, 5, 3, 3)) + rng.uniform(-900, 900, (5, 3, 3)))
    raw[:40, 0, 0] = 0.0
    reader, sound = LiveContacts(inverted(), "first", 20), SoundReadings()
    found = [reader.feed(one, left_out=np.isnan(sound.known(one))) for one in raw]
    assert max(one.number[0] for one in found if one is not None) == 0


def test_a_file_gives_the_same_readings(tmp_path, followed):
    _, _, counts, _, _ = followed
    path = tmp_path / "contacts.nc"
    save_inversion(inverted(), path)
    again = load_inversion(path)
    some = counts[[3, 20, 30]]
    for one, other in zip(inverted().read(some)[0].xy_mm, again.read(some)[0].xy_mm, strict=True):
        assert_allclose(one, other, atol=1e-5)
    presses = np.array([0, 2]), np.array([[3.0, 1.0, 4.0], [-2.0, 5.0, 1.0]])
    skins = [estimator.model.skin.expected(*presses) for estimator in (inverted(), again)]
    assert_allclose(*skins, rtol=1e-6)
    assert is_inversion(path)
    assert not is_inversion(tmp_path / "no.nc")
    damaged = bytearray(path.read_bytes())
    damaged[len(damaged) // 2] ^= 0xFF
    path.write_bytes(damaged)
    with pytest.raises(StoreError, match="damaged"):
        load_inversion(path)


def test_axes_that_are_not_measured_say_nothing():
    only_z = SPEC.changed(sensors=SPEC.sensors.changed(axes=["Z"]))
    told = disturbances(only_z, 0.1, 0.0)
    assert np.all(told.noise_counts.reshape(-1, 3)[:, :2] == BLIND)
    assert_allclose(told.model_error, np.hypot(0.1, SUM_ERROR))


def test_the_error_of_a_design_is_that_of_its_tolerances():
    forces, motions, signals = presses()
    exact = SPEC.changed(tolerances=dict.fromkeys(SPEC.tolerances.model_dump(), 0.0))
    assert_allclose(design_error(exact, forces, motions, signals), MESH_ERROR, rtol=1e-6)
    assert 0.05 < design_error(SPEC, forces, motions, signals) < 0.5


@pytest.mark.parametrize(
    ("name", "value", "words"),
    [
        ("specification", "[" * 5000, "tables and description"),
        ("specification", '{"name": "a", "colour": 1}', r"another version of instobj \(colour\)"),
        ("priors", "[1]", "tables and description"),
        ("priors", "{}", "tables and description"),
        ("nearest_mm", "near", "tables and description"),
    ],
)
def test_a_file_whose_description_is_another_is_one_error(tmp_path, name, value, words):
    path = tmp_path / "contacts.nc"
    save_inversion(inverted(), path)
    with h5py.File(path, "a") as file:
        file.attrs[name] = value
    with pytest.raises(StoreError, match=rf"contacts\.nc: .*{words}.*Train it anew"):
        load_inversion(path)


def test_a_file_without_the_skin_is_refused(tmp_path):
    path = tmp_path / "contacts.nc"
    save_inversion(inverted(), path)
    with h5py.File(path, "a") as file:
        del file["skin"]
    with pytest.raises(StoreError, match=r"missing skin.*Train it anew"):
        load_inversion(path)


def held(number, rng, frames=100):
    """Raw counts of contacts that begin after 5 s of rest and stay, on an object that turns and warms."""
    face, contact = contacts(rng, 1, number, (4.0, 8.0))
    face, contact = face.repeat(frames, 0), contact.repeat(frames, 0)
    face[:25] = -1
    counts = noisy_counts(inverted(), face, contact, rng, turned=False)
    turn = np.outer(np.sin(np.arange(frames) / 30), [1.0, -0.6, 0.4, 0.0])
    warm = np.outer(np.arange(frames) / frames, [0.0, 0.0, 0.0, 1.0])
    return contact[0, :, 2].sum(), counts + (turn + warm) @ inverted().disturbances.columns.T


def test_a_zero_that_follows_rest_eats_no_hold_of_a_turning_object():
    """Zero and readings move by turning and warmth; the force of a hold stays (of two tips: below)."""
    force_n, counts = held(1, np.random.default_rng(31))
    reader = LiveContacts(inverted())
    found = [reader.feed(row.reshape(5, 3, 3), k / 5) for k, row in enumerate(counts + 700.0)]
    read = [np.nansum(one.force_n) for one in found[40:]]
    assert abs(np.mean(read[-20:]) - force_n) < 0.1 * force_n
    assert np.mean(np.array(read) > 0.5 * force_n) > 0.98


def test_a_hold_of_half_an_hour_keeps_its_force():
    """Readings of the half hour between are left out; the object turns and warms up. Then it is let go."""
    force_n, counts = held(2, np.random.default_rng(33), frames=90)
    rest = np.full((10, 6), -1), np.zeros((10, 6, 3))
    counts[80:] = noisy_counts(inverted(), *rest, np.random.default_rng(34), turned=False)
    reader = LiveContacts(inverted())
    time_s = np.arange(90) / 5 + 1800.0 * (np.arange(90) >= 40)
    found = [
        reader.feed(row.reshape(5, 3, 3), at)
        for row, at in zip(counts, time_s.tolist(), strict=True)
    ]
    late = found[40:80]
    assert np.mean([one.number[0] == 2 for one in late]) > 0.95
    assert abs(np.mean([np.nansum(one.force_n) for one in late]) - force_n) < 0.05 * force_n
    assert found[-1].number[0] == 0


def test_a_magnet_that_comes_near_moves_no_zero():
    """Rest, then a magnet 60 mm away: what nothing explains is no rest, and no press either."""
    rng = np.random.default_rng(40)
    none = np.full((40, 6), -1), np.zeros((40, 6, 3))
    counts = noisy_counts(inverted(), *none, rng, turned=False)
    counts[20:] += inverted().lookalike_columns[1] @ rng.standard_normal(15)
    reader = LiveContacts(inverted())
    found = [reader.feed(row.reshape(5, 3, 3), k / 5) for k, row in enumerate(counts)]
    assert not any(one.explained[0] for one in found[22:])


def test_drift_since_the_last_rest_widens_regions():
    face, contact = np.full((1, 6), -1), np.zeros((1, 6, 3))
    face[0, 0], contact[0, 0] = 2, [6.0, -6.0, 12.0]
    counts = noisy_counts(inverted(), face, contact, np.random.default_rng(3), turned=False)[0]
    fresh, late = (Tracker(inverted()).feed(counts, drift) for drift in (0.0, 30.0))
    assert late.position_radius_mm[0, 0] > 1.2 * fresh.position_radius_mm[0, 0]
    drifted = counts + np.random.default_rng(4).normal(0, 60, 45)
    assert Tracker(inverted()).feed(drifted, 60.0).explained[0]
    assert not Tracker(inverted()).feed(drifted).explained[0]


def test_drift_that_may_have_come_ends_no_hold():
    """After half an hour without rest channels may have drifted by 85 counts, as much as the hold shows."""
    force_n, counts = held(2, np.random.default_rng(32), frames=60)
    tracker = Tracker(inverted())
    found = [tracker.feed(row, 85.0 * (k > 35)) for k, row in enumerate(counts)]
    assert all(one.number[0] == 2 for one in found[36:])
    assert abs(np.mean([np.nansum(one.force_n) for one in found[36:]]) - force_n) < 0.05 * force_n
    assert tracker.feed(counts[0], 85.0).number[0] == 0
