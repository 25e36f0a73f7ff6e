"""Table of all checks of a recording, in their order.

A check takes what is known so far and returns what it names (readings, or frames), with one sentence for
each cause and span. What it names is left out of signals and of labels.

1. `readings.CHECKS`: raw counts alone, of files and streams alike.
2. `cells.wrong_forces`: load cells alone.
3. `PRESSES` and `RESTS` below: labels and forces held against the signals.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float, Int

from estimator.recordings.checks.cells import unequal_jaws
from estimator.recordings.checks.faults import Fault, doubtful_presses
from estimator.recordings.checks.labels import (
    contacts_at_rest,
    hidden_contacts,
    pressed_faces,
    restless_presses,
    silent_presses,
)
from estimator.recordings.presses import CONTACT_FORCE_N
from estimator.recordings.table import RawTable, channels_text

Rows = tuple[Bool[np.ndarray, "frame"], list[Fault]]
_MOST_SPOILT = 0.1
"""Share of a channel's readings that may be spoilt."""


@dataclass(frozen=True)
class Judged:
    """A recording whose presses are numbered: what checks of presses see.

    Attributes
    ----------
    force_n : (frame, cell) from rest, at the instant that the cell reported it
    responses : (press, face) change of each face's signals under force, counts
    no_contact : (frame,) labels say that nothing touches
    rest : (frame,) load cells say so, at the instant of the signals
    """

    table: RawTable
    face: Int[np.ndarray, "frame cell"]
    force_n: Float[np.ndarray, "frame cell"]
    press: Int[np.ndarray, "frame"]
    responses: Float[np.ndarray, "press 5"]
    no_contact: Bool[np.ndarray, "frame"]
    rest: Bool[np.ndarray, "frame"]
    stretch: Int[np.ndarray, "frame"]
    block: Int[np.ndarray, "frame"]
    noise_counts: Float[np.ndarray, "5 sensor 3"]

    @property
    def touching(self) -> Bool[np.ndarray, "frame cell"]:
        return self.force_n >= CONTACT_FORCE_N

    @property
    def pressed(self) -> Bool[np.ndarray, "frame"]:
        return np.asarray(self.touching.any(axis=1))


def _restless(case: Judged) -> Rows:
    faults = restless_presses(case.rest, case.pressed, case.press)
    return np.zeros(len(case.press), bool), faults


def _unequal(case: Judged) -> Rows:
    faults = unequal_jaws(case.force_n, case.table.kind)
    return (case.pressed | ~case.rest) & bool(faults), faults


def _doubtful(case: Judged) -> Rows:
    if unequal_jaws(case.force_n, case.table.kind):  # which face is pressed cannot be told then
        return np.zeros(len(case.press), bool), []
    pressed = pressed_faces(case.face, case.force_n, case.press)
    return doubtful_presses(pressed, case.press, case.responses)


def _denied(case: Judged) -> Rows:
    return contacts_at_rest(case.touching, case.no_contact, case.press)


def _hidden(case: Judged) -> Rows:
    return hidden_contacts(
        case.table.counts, case.rest, case.stretch, case.block, case.noise_counts
    )


def _silent(case: Judged) -> Rows:
    return silent_presses(case.face, case.force_n, case.press, case.responses, case.noise_counts)


PRESSES: tuple[Callable[[Judged], Rows], ...] = (
    _restless,
    _unequal,
    _doubtful,
    _denied,
    _silent,
)
"""Checks of presses: frames that they name are no labels."""
RESTS: tuple[Callable[[Judged], Rows], ...] = (_hidden,)
"""Checks of rests: frames that they name tell no zero either."""


def judged(case: Judged, checks: tuple[Callable[[Judged], Rows], ...]) -> Rows:
    """Frames that one of the checks names, and what was named."""
    named, faults = np.zeros(len(case.press), bool), []
    for check in checks:
        rows, check_faults = check(case)
        named, faults = named | rows, faults + check_faults
    return named, faults


def spoilt_channels(
    counts: Float[np.ndarray, "frame 5 sensor 3"], lost: Bool[np.ndarray, "frame 5 sensor 3"]
) -> tuple[Bool[np.ndarray, "5 sensor 3"], list[Fault]]:
    """Channels of which more than a tenth of the readings is `lost` to faults: to leave them out costs
    less than their frames. Frames that lack half of the channels count for none."""
    has_reading = np.isfinite(counts) | lost
    whole = 2 * lost.sum(axis=(1, 2, 3)) >= has_reading.sum(axis=(1, 2, 3))
    part = (lost & ~whole[:, None, None, None]).sum(axis=0)
    share = part / np.maximum((has_reading & ~whole[:, None, None, None]).sum(axis=0), 1)
    spoilt = share > _MOST_SPOILT
    channels = [tuple(index) for index in np.argwhere(spoilt).tolist()]
    if not channels:
        return spoilt, []
    detail = f"more than {100 * _MOST_SPOILT:.0f} % of their readings are named above"
    where = channels_text(channels, np.any(has_reading, axis=0))
    return spoilt, [Fault("channels left out", where, detail, "set to NaN")]
