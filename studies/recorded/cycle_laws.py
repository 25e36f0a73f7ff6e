"""Loading cycles at one place: what of force and field follows travel, lag and relaxation.

Laws of growing freedom, each fitted to the first half of the cycles and judged on the second:
- small strain: force as (travel − contact)^{3/2}, a sphere's; field in proportion to that distance;
- any elastic law: a polynomial of the travel, the same on both ways;
- the same of a travel that was reached some time ago: machines report where they have been told to
  go. No relaxing solid bears its load after its travel, so that a positive lag is theirs;
- the same with one relaxation, y = e − g ∫ (1 − exp(−(t − s)/θ)) de(s): one term of a Prony series
  on the elastic response (Fung's quasi-linear viscoelasticity).
The null of lag and relaxation is the judged half with the two ways of each cycle exchanged (time runs
back within it): an elastic law does not notice, a law of history does.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, Int
from scipy.signal import lfilter

from design.errors import InputError
from estimator.recordings.formats.travel import TravelRecording

STEP_S = 0.1
LAGS_S = np.round(np.arange(-0.5, 1.01, 0.1), 1)
TIMES_S = (1.0, 3.0, 10.0, 30.0, 100.0)
SHARES = (0.05, 0.1, 0.2, 0.3, 0.4, 0.5)
DEGREE = 7
_RETURNED = 0.02
_FEWEST_CYCLES = 4


@dataclass(frozen=True)
class Cycles:
    """Readings at equal steps of time: travel (mm, from the shallowest place, `axis` of the machine),
    load and the change of field since the beginning (mT); `cycle` numbers the cycles from 0, −1
    before the first."""

    time_s: Float[np.ndarray, "frame"]
    travel_mm: Float[np.ndarray, "frame"]
    load: Float[np.ndarray, "frame"]
    change_mt: Float[np.ndarray, "frame channel"]
    cycle: Int[np.ndarray, "frame"]
    axis: str

    @property
    def count(self) -> int:
        """Return how many cycles."""
        return int(self.cycle.max()) + 1


@dataclass(frozen=True)
class LawScore:
    """One law: share of the variance explained of the judged cycles, and of their exchanged ways (None
    where the law does not notice); the lag, relaxation time and share found (None where none)."""

    law: str
    explained: float
    exchanged: float | None = None
    lag_s: float | None = None
    time_s: float | None = None
    share: float | None = None


def cycles_of(recording: TravelRecording) -> Cycles:
    """Cut a recording of one machine axis going there and back into cycles.

    Raises
    ------
    InputError
        No loads, more than one moving axis, or fewer than four cycles.
    """
    if recording.load is None or np.isfinite(recording.load).sum() < 2:
        raise InputError("the recording holds no loads. Give one with a load cell in states.csv")
    span = np.ptp(recording.tip_mm, axis=0)
    moving = int(np.argmax(span))
    if np.sort(span)[1] > 0.1 or span[moving] < 0.5:
        raise InputError(
            f"cycles go along one axis; this recording spans {', '.join(f'{s:.3g}' for s in span)} mm. "
            "Give a recording of loading cycles at one place"
        )
    time = recording.time_s - recording.time_s[0]
    even = np.arange(0, time[-1], STEP_S)
    travel = np.interp(even, time, recording.tip_mm[0, moving] - recording.tip_mm[:, moving])
    if abs(travel.min()) > travel.max():
        travel = -travel
    known = np.isfinite(recording.load)
    field = recording.field_mt.reshape(len(time), -1)
    change = np.stack([np.interp(even, time, channel) for channel in field.T], axis=1)
    leaves = np.diff((travel > _RETURNED * travel.max()).astype(int), prepend=0) == 1
    cycle = np.cumsum(leaves) - 1
    if cycle.max() + 1 < _FEWEST_CYCLES:
        raise InputError(
            f"{cycle.max() + 1} loading cycles were found; {_FEWEST_CYCLES} or more are needed to fit "
            "some and judge others"
        )
    load = np.interp(even, time[known], recording.load[known])
    first = change[: max(1, int(leaves.argmax()))].mean(axis=0)
    return Cycles(even, travel, load, change - first, cycle, "xyz"[moving])


def force_laws(cycles: Cycles) -> list[LawScore]:
    """The laws for the load."""
    values = cycles.load[:, None]
    small = judged_share(
        cycles, [sphere_basis(cycles.travel_mm, at) for at in contact_basis(cycles)], values
    )
    return [LawScore("small strain", small), *_laws(cycles, values)]


def field_laws(cycles: Cycles) -> list[LawScore]:
    """The laws for all channels together, and how far the field follows the load alone."""
    values = cycles.change_mt
    lines = [
        np.column_stack([np.ones(len(cycles.time_s)), np.maximum(cycles.travel_mm - at, 0)])
        for at in contact_basis(cycles)
    ]
    scores = [LawScore("small strain", judged_share(cycles, lines, values)), *_laws(cycles, values)]
    by_load = power_basis(cycles.load / max(cycles.load.max(), 1e-12))
    return [*scores, LawScore("any law of the load", judged_share(cycles, [by_load], values))]


def loop_shares(cycles: Cycles, lag_s: float) -> Float[np.ndarray, "cycle"]:
    """Work lost over work done in every whole cycle, at a lag of the travel."""
    travel = late_travel(cycles, lag_s)
    found = []
    for number in range(cycles.count):
        rows = np.flatnonzero(cycles.cycle == number)
        middle = (cycles.load[rows][1:] + cycles.load[rows][:-1]) / 2
        work = middle * np.diff(travel[rows])
        found.append(work.sum() / work[work > 0].sum())
    return np.array(found)


def _laws(cycles: Cycles, values: np.ndarray) -> list[LawScore]:
    still = power_basis(cycles.travel_mm / cycles.travel_mm.max())
    elastic = judged_share(cycles, [still], values)
    late = [
        (lag, power_basis(late_travel(cycles, lag) / cycles.travel_mm.max()))
        for lag in LAGS_S.tolist()
    ]
    lag, basis = min(late, key=lambda one: squares_left(cycles, one[1], values))
    mirrored = mirrored_ways(cycles)
    scores = [
        LawScore("any elastic law", elastic),
        LawScore(
            "elastic, lag",
            judged_share(cycles, [basis], values),
            judged_share(cycles, [basis], values, mirrored),
            lag,
        ),
    ]
    relaxed = [
        (lag, time, share, base - share * (base - relaxing_travel(base, time)))
        for lag, base in late
        for time in TIMES_S
        for share in SHARES
    ]
    lag, time, share, basis = min(relaxed, key=lambda one: squares_left(cycles, one[3], values))
    explained = judged_share(cycles, [basis], values)
    exchanged = judged_share(cycles, [basis], values, mirrored)
    return [*scores, LawScore("elastic, lag, relaxation", explained, exchanged, lag, time, share)]


def contact_basis(cycles: Cycles) -> np.ndarray:
    return np.linspace(0, 0.5, 26) * cycles.travel_mm.max()


def sphere_basis(travel_mm: np.ndarray, contact_mm: float) -> np.ndarray:
    return np.maximum(travel_mm - contact_mm, 0)[:, None] ** 1.5


def power_basis(share: Float[np.ndarray, "frame"]) -> Float[np.ndarray, "frame power"]:
    return np.polynomial.chebyshev.chebvander(2 * share - 1, DEGREE)


def late_travel(cycles: Cycles, lag_s: float) -> np.ndarray:
    """The travel of some time ago."""
    return np.interp(cycles.time_s - lag_s, cycles.time_s, cycles.travel_mm)


def relaxing_travel(basis: np.ndarray, time_s: float) -> np.ndarray:
    """∫ exp(−(t − s)/θ) de(s)."""
    kept = np.exp(-STEP_S / time_s)
    return np.asarray(lfilter([1.0, -1.0], [1.0, -kept], basis - basis[:1], axis=0))


def cycle_halves(cycles: Cycles) -> tuple[np.ndarray, np.ndarray]:
    middle = cycles.count // 2
    fitted = (cycles.cycle >= 0) & (cycles.cycle < middle)
    return fitted, cycles.cycle >= middle


def squares_left(cycles: Cycles, basis: np.ndarray, values: np.ndarray) -> float:
    """Squares left of the cycles that are fitted."""
    fitted, _ = cycle_halves(cycles)
    law, *_ = np.linalg.lstsq(basis[fitted], values[fitted], rcond=None)
    return float(np.sum((values[fitted] - basis[fitted] @ law) ** 2))


def judged_share(
    cycles: Cycles, bases: list[np.ndarray], values: np.ndarray, rows: np.ndarray | None = None
) -> float:
    """Share explained of the judged cycles by the basis that fits the others best; `rows` puts other
    frames in the judged ones' place."""
    fitted, judged = cycle_halves(cycles)
    basis = min(bases, key=lambda one: squares_left(cycles, one, values))
    law, *_ = np.linalg.lstsq(basis[fitted], values[fitted], rcond=None)
    predicted = basis @ law
    shown = values if rows is None else values[rows]
    left = shown[judged] - predicted[judged]
    about = shown[judged] - shown[judged].mean(axis=0)
    return float(1 - np.sum(left**2) / np.sum(about**2))


def mirrored_ways(cycles: Cycles) -> np.ndarray:
    """Frames with the ways of every cycle exchanged: those of nearest travel on the other way."""
    rows = np.arange(len(cycles.time_s))
    for number in range(cycles.count):
        own = np.flatnonzero(cycles.cycle == number)
        top = own[0] + int(np.argmax(cycles.travel_mm[own]))
        there, back = np.arange(own[0], top + 1), np.arange(top, own[-1] + 1)
        travel = cycles.travel_mm
        rows[there] = [back[np.argmin(abs(travel[back] - travel[k]))] for k in there]
        rows[back[1:]] = [there[np.argmin(abs(travel[there] - travel[k]))] for k in back[1:]]
    return rows
