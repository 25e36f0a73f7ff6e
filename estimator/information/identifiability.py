"""Number of identifiable contacts: rank and condition of their joint information.

k contacts have 3k unknowns (x, y, F each) against 3 channels per sensor. Enough channels make the
information's rank full; whether places can then be read is a matter of its condition.

Signals of several contacts are taken as the sum of those of each alone. Condition numbers hold for
signals in units of a fresh zero's sigma and parameters in mm and N.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Literal

import numpy as np
from jaxtyping import Float, Int

from design.layout.places.contact_grid import contact_grid
from design.spec.object import ObjectSpec
from design.spec.sensors import fastest_frame_rate_hz
from design.tables import write_records
from estimator.information.contact_sets import contact_sets, spread_places
from estimator.information.fisher import disturbance_counts, squared_rows, whitened
from estimator.information.sensitivity import own_channels
from estimator.signals.interpolation import press_traces
from estimator.signals.live import live_jacobian
from estimator.signals.nuisances import nuisance_columns
from estimator.signals.presses import Signals, press_signals
from fem.presses.results import MagnetMotions, PressForces

Channels = Literal["own", "all"]
_SENSOR_COUNTS = (1, 2, 3, 4, 5)
"""Numbers of sensors of a face that are compared, besides its own."""
CONTACT_COUNTS = (1, 2, 3)
"""Numbers of contacts that are asked for."""
_RANK_TOLERANCE = 1e-9
"""Share of the largest singular value below which one counts as 0."""


@dataclass(frozen=True)
class WorstSet:
    """The contact set that is resolved worst, and its blindest direction.

    `direction` (contact, 3): unit change of (x, y, F) in mm and N that moves the signals least.
    """

    face: int
    condition: float
    xy_mm: Float[np.ndarray, "contact 2"]
    direction: Float[np.ndarray, "contact 3"]


@dataclass(frozen=True)
class Identifiability:
    """Information of k simultaneous contacts on one face over many sets of places.

    Attributes
    ----------
    contacts, sensors, channels : k, Hall sensors per face, and whose channels are read
    unknowns, signals : 3k parameters, and the number of channels
    sets : contact sets judged, over all faces
    rank_least : smallest rank of the information over the sets
    told_median : median number of directions known to better than 1 mm or 1 N
    condition_median : median condition number of the whitened Jacobian (∞ where rank is short)
    bound_10_mm, bound_median_mm, bound_90_mm : position bound of a set's worst contact, quantiles
    bound_share_within_limit : sets whose every contact is bounded within `limits.position_bound_mm`
    force_bound_median_n : force bound of a set's worst contact
    worst : the set of largest condition
    """

    contacts: int
    sensors: int
    channels: Channels
    unknowns: int
    signals: int
    sets: int
    rank_least: int
    told_median: float
    condition_median: float
    bound_10_mm: float
    bound_median_mm: float
    bound_90_mm: float
    bound_share_within_limit: float
    force_bound_median_n: float
    worst: WorstSet


def identifiability(
    spec: ObjectSpec,
    forces: PressForces,
    motions: MagnetMotions,
    sensor_counts: Sequence[int] | None = None,
    contact_counts: Sequence[int] = CONTACT_COUNTS,
    progress: Callable[[str], None] | None = None,
) -> tuple[Identifiability, ...]:
    """Every number of contacts against every number of sensors, own channels and all.

    Each contact presses with `score.force_n` (or as far as its deepest press goes), freshly zeroed;
    tips do not touch each other. By default one to five sensors per face are compared. Other numbers
    of them than the specification's stand evenly on its ring, whether or not their boards would fit
    there; where sensors sit in the shell their number cannot change without new mechanics.

    Raises
    ------
    InputError
        The face is too small for that many tips, or a sensor lies in a magnet or saturates.
    """
    places = spread_places(spec)
    sets = {k: contact_sets(spec, places, k) for k in contact_counts}
    rows = []
    for count in sensor_counts or comparable_sensor_counts(spec):
        if progress:
            progress(f"{count} sensors per face")
        jacobians = whitened_jacobians(spec, forces, motions, places, count)
        for channels in ("own", "all"):
            for k in contact_counts:
                rows.append(judge_sets(spec, jacobians, places, sets[k], count, channels))
    return tuple(rows)


def comparable_sensor_counts(spec: ObjectSpec) -> tuple[int, ...]:
    """Numbers of sensors per face that the stored mechanics can answer for."""
    count = spec.sensors.count_per_face
    return (
        (count,)
        if spec.arrangement == "sensors-in-shell"
        else tuple(sorted({*_SENSOR_COUNTS, count}))
    )


@dataclass(frozen=True)
class FaceJacobians:
    """∂S/∂(x, y, F) of single presses, whitened (`estimator.information.fisher.whitened`), 0 of channels
    that are not live: of all channels, and of the face's own where they alone are read.

    Channels that clip in some presses only still tell of nuisances: contacts share one whitening.
    """

    face: int
    whitened: Float[np.ndarray, "place channel 3"]
    face_channels: Float[np.ndarray, "place own 3"]


def whitened_jacobians(
    spec: ObjectSpec,
    forces: PressForces,
    motions: MagnetMotions,
    places: Int[np.ndarray, "place"],
    sensors: int,
) -> tuple[FaceJacobians, ...]:
    """Derivatives at some contact locations for another number of sensors per face."""
    variant = with_sensor_count(spec, sensors)
    return jacobians_of(variant, press_signals(variant, forces, motions), places)


def with_sensor_count(spec: ObjectSpec, sensors: int) -> ObjectSpec:
    """Another number of sensors per face, evenly on the ring."""
    ring = spec.sensors
    if sensors == ring.count_per_face:
        return spec
    ring = ring.changed(count_per_face=sensors, positions_mm=None)
    fastest = fastest_frame_rate_hz(ring, len(spec.body.sensed))
    return spec.changed(sensors=ring.changed(frame_rate_hz=min(ring.frame_rate_hz, fastest)))


def jacobians_of(
    spec: ObjectSpec, signals: Signals, places: Int[np.ndarray, "place"]
) -> tuple[FaceJacobians, ...]:
    """Derivatives of an object's own signals at some contact locations, face by face."""
    sigma = disturbance_counts(spec.sensors, "fresh", signals.baseline_counts.size)
    nuisances = nuisance_columns(spec)
    x, y = contact_grid(spec).xy_mm[places].T
    jacobians = []
    for face in signals.faces.tolist():
        force = score_forces_n(spec, signals, face, places)
        slopes = live_jacobian(spec, signals, np.full(len(x), face), x, y, force).swapaxes(1, 2)
        # channels that stand still in every press tell nothing of nuisances
        shared = nuisances * np.asarray(slopes.any(axis=(0, 1)))[:, None]
        read = (np.arange(len(sigma)), own_channels(signals, spec.sensors, face))
        white = (
            whitened(slopes[..., channels], sigma[channels], shared[channels]) for channels in read
        )
        jacobians.append(FaceJacobians(face, *(channels.swapaxes(1, 2) for channels in white)))
    return tuple(jacobians)


def score_forces_n(
    spec: ObjectSpec, signals: Signals, face: int, places: Int[np.ndarray, "place"]
) -> Float[np.ndarray, "place"]:
    """`score.force_n`, or what the deepest press reaches where that is less."""
    x, y = contact_grid(spec).xy_mm[places].T
    traces = press_traces(signals, np.full(len(x), face), x, y)
    return np.minimum(spec.score.force_n, traces.force_n[:, -1])


@dataclass(frozen=True)
class SetInformation:
    """Information in the whitened Jacobians of contact sets; parameters run contact by contact."""

    rank: Int[np.ndarray, "set"]
    resolved: Int[np.ndarray, "set"]
    condition: Float[np.ndarray, "set"]
    position_bound_mm: Float[np.ndarray, "set contact"]
    force_bound_n: Float[np.ndarray, "set contact"]
    blindest: Float[np.ndarray, "set contact 3"]


def set_information(whitened: Float[np.ndarray, "set channel parameter"]) -> SetInformation:
    """Rank, condition and Cramér–Rao bounds of 3k parameters from ∂S/∂(x, y, F, x, y, F, …).

    Raises no error where channels are fewer than parameters: the bounds are infinite there.
    """
    sets, _, parameters = whitened.shape
    _, singular, right = np.linalg.svd(squared_rows(whitened), full_matrices=False)
    resolved = singular > _RANK_TOLERANCE * singular[:, :1]
    rank = resolved.sum(axis=1)
    full = rank == parameters
    with np.errstate(divide="ignore"):
        condition = np.where(full, singular[:, 0] / np.where(full, singular[:, -1], 1), np.inf)
    inverse = np.where(resolved, singular, 1.0) ** -2.0
    # Diagonal of (JᵀJ)⁻¹ = Σ_k v_k v_kᵀ/σ_k²: s set, k singular value, i parameter
    variance = np.einsum("sk,ski->si", inverse, right**2).reshape(sets, -1, 3)
    variance[~full] = np.inf
    return SetInformation(
        rank,
        np.sum(singular > 1, axis=1),
        condition,
        np.sqrt(variance[:, :, 0] + variance[:, :, 1]),
        np.sqrt(variance[:, :, 2]),
        right[:, -1].reshape(sets, -1, 3),
    )


def judge_sets(
    spec: ObjectSpec,
    jacobians: tuple[FaceJacobians, ...],
    places: Int[np.ndarray, "place"],
    sets: Int[np.ndarray, "set contact"],
    sensors: int,
    channels: Channels,
) -> Identifiability:
    information = [set_information(stacked) for stacked in _stacked(jacobians, sets, channels)]
    position = np.concatenate([info.position_bound_mm.max(axis=1) for info in information])
    force = np.concatenate([info.force_bound_n.max(axis=1) for info in information])
    rank = np.concatenate([info.rank for info in information])
    # `inverted_cdf` picks sets that exist: no interpolation between finite and infinite bounds
    low, middle, high = np.quantile(position, (0.1, 0.5, 0.9), method="inverted_cdf")
    signals = (1 if channels == "own" else len(jacobians)) * 3 * sensors
    return Identifiability(
        sets.shape[1],
        sensors,
        channels,
        3 * sets.shape[1],
        signals,
        len(position),
        int(rank.min()),
        float(np.median(np.concatenate([info.resolved for info in information]))),
        _middle(np.concatenate([info.condition for info in information])),
        float(low),
        float(middle),
        float(high),
        float(np.mean(position <= spec.limits.position_bound_mm)),
        _middle(force),
        worst_set(spec, jacobians, places, sets, information),
    )


def _stacked(
    jacobians: tuple[FaceJacobians, ...], sets: Int[np.ndarray, "set contact"], channels: Channels
) -> Iterator[Float[np.ndarray, "set channel parameter"]]:
    """Jacobians of the sets on each face, face by face, contacts side by side."""
    for face in jacobians:
        used = face.face_channels if channels == "own" else face.whitened
        yield np.concatenate([used[sets[:, k]] for k in range(sets.shape[1])], axis=2)


def worst_set(
    spec: ObjectSpec,
    jacobians: tuple[FaceJacobians, ...],
    places: Int[np.ndarray, "place"],
    sets: Int[np.ndarray, "set contact"],
    information: list[SetInformation],
) -> WorstSet:
    condition = np.stack([info.condition for info in information])
    face, row = np.unravel_index(int(np.argmax(condition)), condition.shape)
    xy = contact_grid(spec).xy_mm[places[sets[row]]]
    return WorstSet(
        jacobians[face].face, float(condition[face, row]), xy, information[face].blindest[row]
    )


def _middle(values: Float[np.ndarray, "n"]) -> float:
    return float(np.quantile(values, 0.5, method="inverted_cdf"))


def table_row(row: Identifiability) -> dict[str, float | int | str]:
    """Plain values without the worst set."""
    return {name: value for name, value in asdict(row).items() if name != "worst"}


def save_identifiability(rows: Sequence[Identifiability], path: Path | str) -> None:
    """Bounds of each number of contacts and sensors (CSV); the header has the units."""
    write_records(path, [table_row(row) for row in rows])
