"""Contacts of a stream, against a zero that follows rest and holds."""

from dataclasses import replace

import numpy as np
import pytest

from estimator.deploy.live_contacts import LiveContacts
from estimator.inversion.tracking import Tracker
from tests.support.mechanics.inverted import SPEC, contacts, inverted, motion_of
from tests.support.turned_frames import magnets_field_t, read_out


@pytest.mark.parametrize("jaws", [False, True])
def test_the_zero_follows_held_tips_and_no_jaws(jaws, monkeypatch):
    """Jaws change signals by other patterns than the tips whose derivatives a hold needs."""
    rng, read = np.random.default_rng(51), Tracker.feed

    def read_as_jaws(self, *frame):
        sets = read(self, *frame)
        level = np.where(sets.face[..., None] > 0, 0.0, np.nan)
        return replace(sets, tilt_deg=level * np.ones(2))

    if jaws:
        monkeypatch.setattr(Tracker, "feed", read_as_jaws)
    force_n = contacts(rng, 1, 1, (6.0, 6.0))
    motion = np.stack([np.zeros((25, 6)), motion_of(*force_n)[0]])
    raw = read_out(SPEC, magnets_field_t(SPEC, motion)[np.repeat([0, 1], [15, 35])], rng)
    reader, levels = LiveContacts(inverted()), []
    for number, row in enumerate(raw):
        reader.feed(row.reshape(5, 3, 3), 0.5 * number)
        levels.append(reader.level.level)
    moved = np.abs(levels[-1] - levels[16]).max()
    assert (moved == 0) == jaws
