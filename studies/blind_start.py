"""Contacts as maximum likelihood reads them from a blind start, beside their Cramér–Rao bound.

The bound holds near the truth; an estimator that starts blind also meets places far away that give
nearly the same signals, and faces end, which the bound does not know. Frames are simulated from the
forward model with a fresh zero's disturbances; the estimator knows that model, the face and the
number of contacts, and nothing of where they are or how hard they press.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from itertools import permutations
from pathlib import Path
from typing import Any

import numpy as np
from jaxtyping import Float, Int

from design.layout.places.contact_grid import contact_grid
from design.layout.places.positions import live_channels
from design.spec.object import ObjectSpec
from estimator.information.contact_sets import contact_sets, spread_places
from estimator.information.fisher import disturbance_counts
from estimator.information.identifiability import (
    CONTACT_COUNTS,
    Channels,
    Identifiability,
    comparable_sensor_counts,
    identifiability,
    score_forces_n,
    table_row,
    with_sensor_count,
)
from estimator.information.sensitivity import own_channels
from estimator.inversion.model.forward import ContactModel, contact_model
from estimator.inversion.priors import Priors
from estimator.inversion.problems import BLIND, Observations
from estimator.inversion.search import Search
from estimator.signals.nuisances import nuisance_columns
from estimator.signals.presses import Signals, press_signals
from fem.presses.results import MagnetMotions, PressForces
from instobj.figures.saving import save_figure
from instobj.figures.style import PALETTE, draw_limit
from instobj.stages.run import Run
from instobj.store.readers import PRESSES
from studies.layouts import QUICK_MESH, changed
from studies.registry import Study, StudyResult

FRAMES = 100
"""Frames that are inverted."""
_LEAST_FORCE_N = 0.1
"""Least force of a contact that is sought."""
_QUICK_FRAMES = 10
_RESAMPLED = 1000
"""Bootstrap draws of an interval."""


@dataclass(frozen=True)
class BlindStart:
    """Contacts that maximum likelihood reads from a blind start, k of them on one face.

    Attributes
    ----------
    contacts, sensors, channels : as of `Identifiability`
    blind_frames : simulated, spread over the faces and over sets of places
    blind_median_mm, blind_90_mm : distance of a frame's worst contact, quantiles; infinite where no
        contacts are found
    blind_median_low_mm, blind_median_high_mm : 90 % of the median's bootstrap over frames
    blind_share_within_limit : frames whose every contact is found within `limits.position_bound_mm`
    blind_share_low, blind_share_high : 90 % of its bootstrap
    """

    contacts: int
    sensors: int
    channels: Channels
    blind_frames: int
    blind_median_mm: float
    blind_median_low_mm: float
    blind_median_high_mm: float
    blind_90_mm: float
    blind_share_within_limit: float
    blind_share_low: float
    blind_share_high: float


@dataclass(frozen=True)
class _Object:
    """An object with its forward model and the presses of single contacts behind it."""

    spec: ObjectSpec
    signals: Signals
    model: ContactModel


def blind_starts(
    spec: ObjectSpec,
    forces: PressForces,
    motions: MagnetMotions,
    sensor_counts: Sequence[int] | None = None,
    contact_counts: Sequence[int] = CONTACT_COUNTS,
    frames: int = FRAMES,
    progress: Callable[[str], None] | None = None,
) -> tuple[BlindStart, ...]:
    """One row for every row of `identifiability`, of frames at the same sets of places.

    Raises
    ------
    InputError
        As `identifiability`.
    """
    places = spread_places(spec)
    rows = []
    for count in sensor_counts or comparable_sensor_counts(spec):
        variant = _frictionless(with_sensor_count(spec, count))
        signals = press_signals(variant, forces, motions)
        built = _Object(variant, signals, contact_model(variant, forces, motions, signals))
        for channels in ("own", "all"):
            for k in contact_counts:
                if progress:
                    progress(f"blind start: {count} sensors per face, {channels} channels, k = {k}")
                distance = _worst_distances_mm(built, places, k, channels, frames)
                rows.append(summary_of(spec, distance, k, count, channels))
    return tuple(rows)


def _frictionless(spec: ObjectSpec) -> ObjectSpec:
    """Return the object with contacts that push straight down only, as those of the bound."""
    return spec.changed(inversion=spec.inversion.changed(tangential_share=0.0))


def _worst_distances_mm(
    built: _Object,
    places: Int[np.ndarray, "place"],
    contacts: int,
    channels: Channels,
    frames: int,
) -> Float[np.ndarray, "frame"]:
    """Distance of each frame's worst contact; the same places, whatever sensors there are."""
    spec = built.spec
    rng = np.random.default_rng([spec.seed, contacts])
    sets = contact_sets(spec, places, contacts)
    face = np.arange(frames) % len(built.signals.faces)
    chosen = places[sets[rng.integers(len(sets), size=frames)]]
    noise = np.random.default_rng([spec.seed, contacts, spec.sensors.count_per_face])
    distance = np.full(frames, np.inf)
    for index in np.unique(face).tolist():
        rows = np.flatnonzero(face == index)
        true = _contacts(built, index, chosen[rows])
        distance[rows] = _face_distances_mm(built, index, true, channels, noise)
    return distance


def _contacts(
    built: _Object, index: int, places: Int[np.ndarray, "frame contact"]
) -> Float[np.ndarray, "frame contact 3"]:
    number = int(built.signals.faces[index])
    force = score_forces_n(built.spec, built.signals, number, places.ravel())
    xy = contact_grid(built.spec).xy_mm[places]
    return np.concatenate([xy, force.reshape(*places.shape, 1)], axis=2)


def _face_distances_mm(
    built: _Object,
    index: int,
    true: Float[np.ndarray, "frame contact 3"],
    channels: Channels,
    rng: np.random.Generator,
) -> Float[np.ndarray, "frame"]:
    """Return distances (mm) of contacts on one face, read from noisy frames."""
    frames, contacts = true.shape[:2]
    model, face = built.model.select_face(index), np.zeros((frames, contacts), int)
    sigma = disturbance_counts(built.spec.sensors, "fresh", model.channels)
    counts = model.singles(face, true)[:, :, 0].sum(axis=1) + model.interaction(face, true)
    counts = counts + sigma * rng.standard_normal(counts.shape)
    nuisances = nuisance_columns(built.spec)
    counts = counts + rng.standard_normal((frames, nuisances.shape[1])) @ nuisances.T
    read = _read_channels(built, index, channels)
    sigmas = np.broadcast_to(np.where(read, sigma, BLIND), counts.shape)
    observations = Observations(counts, sigmas, sigmas, sigmas, nuisances)
    problems = Search(model, known_number(built.spec, model, contacts)).sets_of_number(
        observations, contacts
    )
    distance = np.full(frames, np.inf)
    distance[problems.frame] = worst_mm(problems.contact[..., :2], true[problems.frame, :, :2])
    return distance


def _read_channels(built: _Object, index: int, channels: Channels) -> np.ndarray:
    read = live_channels(built.spec).ravel().copy()
    if channels == "own":
        number = int(built.signals.faces[index])
        face_channels = own_channels(built.signals, built.spec.sensors, number)
        read &= np.isin(np.arange(len(read)), face_channels)
    return read


def known_number(spec: ObjectSpec, model: ContactModel, contacts: int) -> Priors:
    """Return priors of n contacts anywhere on one face, tips apart; 0.1 N to the table's largest force."""
    _, high = model.bounds
    return Priors(
        (*np.zeros(contacts).tolist(), 1.0),
        1,
        model.area_mm2,
        (_LEAST_FORCE_N, float(high[2])),
        2 * spec.indenter.radius_mm,
    )


def worst_mm(
    found_mm: Float[np.ndarray, "frame contact 2"], true_mm: Float[np.ndarray, "frame contact 2"]
) -> Float[np.ndarray, "frame"]:
    """Largest distance of the pairs whose distances add up to the least."""
    orders = [list(order) for order in permutations(range(true_mm.shape[1]))]
    away = np.stack([np.linalg.norm(found_mm[:, order] - true_mm, axis=2) for order in orders])
    best = away.sum(axis=2).argmin(axis=0)
    return away[best, np.arange(len(true_mm))].max(axis=1)


def summary_of(
    spec: ObjectSpec,
    distance_mm: Float[np.ndarray, "frame"],
    contacts: int,
    sensors: int,
    channels: Channels,
) -> BlindStart:
    rng = np.random.default_rng(spec.seed)
    drawn = distance_mm[rng.integers(len(distance_mm), size=(_RESAMPLED, len(distance_mm)))]
    within = drawn <= spec.limits.position_bound_mm
    median = np.quantile(drawn, 0.5, axis=1, method="inverted_cdf")
    low, high = np.quantile(median, (0.05, 0.95), method="inverted_cdf")
    share_low, share_high = np.quantile(within.mean(axis=1), (0.05, 0.95))
    middle, most = np.quantile(distance_mm, (0.5, 0.9), method="inverted_cdf")
    return BlindStart(
        contacts,
        sensors,
        channels,
        len(distance_mm),
        float(middle),
        float(low),
        float(high),
        float(most),
        float(np.mean(distance_mm <= spec.limits.position_bound_mm)),
        float(share_low),
        float(share_high),
    )


def run(spec: ObjectSpec, folder: Path, quick: bool) -> StudyResult:
    """Bounds and blind starts of one to three contacts, for one sensor of a face up to five."""
    if quick:
        spec = changed(spec, QUICK_MESH)
    presses = Run(spec).read(PRESSES)
    bounds = identifiability(spec, *presses)
    blind = blind_starts(spec, *presses, frames=_QUICK_FRAMES if quick else FRAMES)
    draw_blind_starts(spec, bounds, blind, folder / "blind_starts.png")
    return StudyResult(joined_rows(bounds, blind))


STUDIES = (Study("blind-start", "Several contacts found from nowhere, beside their bounds.", run),)


def joined_rows(
    bounds: Sequence[Identifiability], blind: Sequence[BlindStart]
) -> list[dict[str, Any]]:
    """One row for each number of contacts and sensors: what bounds say, and what blind starts find."""
    return [table_row(row) | asdict(start) for row, start in zip(bounds, blind, strict=True)]


def draw_blind_starts(
    spec: ObjectSpec,
    bounds: Sequence[Identifiability],
    blind: Sequence[BlindStart],
    path: Path | str,
) -> None:
    """Medians of bounds (lines) and distances from blind starts (squares) against sensors (PNG)."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(11, 4.8), layout="constrained")
    panels = figure.subplots(1, 2, sharey=True)
    for axes, channels in zip(panels, ("own", "all"), strict=True):
        for contacts, colour in zip(CONTACT_COUNTS, PALETTE, strict=False):
            wanted = (channels, contacts)
            lines = [row for row in bounds if (row.channels, row.contacts) == wanted]
            squares = [row for row in blind if (row.channels, row.contacts) == wanted]
            sensors = [row.sensors for row in lines]
            label = f"{contacts} contacts" if contacts > 1 else "1 contact"
            axes.plot(sensors, [row.bound_median_mm for row in lines], color=colour, label=label)
            far = [row.blind_median_mm for row in squares]
            axes.plot(sensors, far, color=colour, marker="s", mfc="white", ls="")
        draw_limit(axes, spec.limits.position_bound_mm)
        axes.set(yscale="log", xlabel="Hall sensors per face", title=f"{channels} channels")
    panels[0].set_ylabel("worst contact: bound, distance (mm)")
    panels[0].legend(frameon=False)
    save_figure(figure, path)
