"""The bound of each metric: what Bayes' optimum reaches on the same frames, and Cramér–Rao.

The optimum knows the object's own table of signals, all contact cases and their prior, and judges
frames one by one (`studies.paper.bayes_optimum`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from studies.paper.object import SIMULATED, SimulatedObject, simulated_object
from studies.registry import Study, StudyResult

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec
    from estimator.frames.contact_cases import ContactCase
    from estimator.frames.contact_traces import ContactTraces
    from estimator.frames.dataset import FrameSet
    from estimator.frames.face_data import FaceData
    from estimator.metrics.heatmaps import ForceReference
    from estimator.networks.face_model import FaceModel
    from studies.paper.bayes_optimum import Hypotheses

_MOST_FRAMES = 4000


@dataclass(frozen=True)
class KnownCases:
    """Contact cases that a bound knows, with what the object shows in each and the travel's peak."""

    cases: Sequence[ContactCase]
    traces: ContactTraces
    peak_mm: Float[np.ndarray, "case"]


@dataclass(frozen=True)
class Judged:
    """Frames of one face on which estimator and bound are compared, and what the bound knows.

    `centre_mm` is the centre of force of each hypothesis' case.
    """

    data: FaceData
    hypotheses: Hypotheses
    centre_mm: Float[np.ndarray, "case 2"]
    seen_counts: Float[np.ndarray, "frame channel"]
    sigma_counts: Float[np.ndarray, "channel"]


def judged_frames(
    recorded: SimulatedObject,
    face: int,
    frames: FrameSet,
    known: KnownCases | None = None,
    every_face: bool = False,
) -> Judged:
    """At most 4000 of the frames, and contact cases as the object shows them.

    Known are all cases of the face's collection unless others are given, and the share of rest; seen
    are the face's own channels, or those of every face.
    """
    from dataclasses import replace

    from estimator.frames.collection_recipe import drift_rms_counts
    from estimator.frames.face_data import channel_counts, face_data, live_channels
    from studies.paper.bayes_optimum import disturbance_sigma, press_hypotheses

    data = face_data(frames, face)
    if len(data) > _MOST_FRAMES:
        chosen = np.random.default_rng(0).choice(len(data), _MOST_FRAMES, replace=False)
        data = data.select(np.sort(chosen))
    channels = live_channels(data, every_face)
    flat = flat_channels(recorded.spec, channels)
    known = known or known_cases(recorded, face)
    cases, rest_share = known.cases, float(data.rest.mean())
    hypotheses = press_hypotheses(
        recorded.spec, cases, known.traces, known.peak_mm, face, rest_share
    )
    return Judged(
        data,
        replace(hypotheses, counts=hypotheses.counts[..., flat]),
        np.array([case.xy_mm[case.face == face].mean(axis=0) for case in cases]),
        channel_counts(data.frames, channels),
        disturbance_sigma(recorded.spec, flat, drift_rms_counts(recorded.spec)),
    )


def known_cases(
    recorded: SimulatedObject, face: int, cases: Sequence[ContactCase] | None = None
) -> KnownCases:
    """Contact cases (by default all of a face's collection) pressed on the object itself."""
    from estimator.frames.collection_recipe import peak_travel_mm
    from estimator.frames.contact_cases import paper_cases
    from estimator.frames.contact_traces import contact_traces

    spec = recorded.spec
    cases = paper_cases(spec, face) if cases is None else cases
    traces = contact_traces(spec, recorded.signals, cases, recorded.mechanics)
    return KnownCases(cases, traces, peak_travel_mm(spec, recorded.signals, cases, traces))


def reference_row(judged: Judged, span: ForceReference) -> dict[str, float]:
    """Metrics of the best possible answers."""
    from estimator.metrics.heatmaps import contact_errors
    from studies.paper.bayes_optimum import best_answers

    found = best_answers(judged.hypotheses, judged.seen_counts, judged.sigma_counts)
    true, contact = judged.data.heatmap_n, judged.data.contact
    medians, exact, means = (
        contact_errors(maps[contact], true[contact], span)
        for maps in (found.median_map_n, found.case_map_n, found.mean_map_n)
    )
    spans = medians.total_n / medians.total_percent
    total = abs(found.total_n - true.sum(axis=(1, 2)))[contact]
    return {
        "best A_sim": round(float(max(exact.similarity.mean(), means.similarity.mean())), 4),
        "best E_loc px": round(
            float(min(np.nanmean(exact.distance_px), np.nanmean(means.distance_px))), 4
        ),
        "best E_f %": round(float(np.nanmean(medians.force_percent)), 3),
        "best E_f N": round(float(medians.force_n.mean()), 4),
        "best total force %": round(float(np.nanmean(total / spans)), 3),
    }


def interval_row(judged: Judged, model: FaceModel, label_noise_n: float) -> dict[str, float]:
    """Cover and median width of a model's intervals beside the posterior's, in the same frames."""
    from estimator.evaluation.evaluation import interval_errors
    from studies.paper.narrowest_intervals import best_intervals

    contact = judged.data.contact
    found, missed_n, away_mm = interval_errors(model, judged.data.select(contact))
    best = best_intervals(
        judged.hypotheses, judged.centre_mm, judged.seen_counts[contact], judged.sigma_counts,
        model.interval_cover, label_noise_n,
    )  # fmt: skip
    widths = [
        float(np.median(values))
        for values in (
            found.force_halfwidth_n, best.force_halfwidth_n,
            found.position_radius_mm, best.position_radius_mm,
        )
    ]  # fmt: skip
    return {
        "force in interval %": round(100 * float(np.mean(missed_n <= found.force_halfwidth_n)), 2),
        "interval ± N": round(widths[0], 4),
        "best interval ± N": round(widths[1], 4),
        "interval over bound": round(widths[0] / widths[1], 3),
        "place in radius %": round(100 * float(np.mean(away_mm <= found.position_radius_mm)), 2),
        "radius mm": round(widths[2], 3),
        "best radius mm": round(widths[3], 3),
    }


def flat_channels(spec: ObjectSpec, channels: tuple[tuple[int, int, int], ...]) -> np.ndarray:
    """Numbers of (face, sensor, axis) among all channels of an object."""
    face, sensor, axis = np.array(channels).T
    row = np.searchsorted(spec.body.sensed, face)
    return (row * spec.sensors.count_per_face + sensor) * 3 + axis


def cramer_rao_row(recorded: SimulatedObject, face: int) -> dict[str, float]:
    """Mean absolute errors that go with the Cramér–Rao bounds at `score.force_n`, single contacts.

    An unbiased normal error of standard deviation σ is √(2/π) σ in the mean, a planar one with
    √(σx² + σy²) = σ about √(π)/2 σ.
    """
    from design.layout.places.contact_grid import contact_grid
    from estimator.information.fisher import cramer_rao_bounds, disturbance_counts
    from estimator.information.sensitivity import own_channels
    from estimator.signals.interpolation import press_traces
    from estimator.signals.live import live_jacobian

    spec, signals = recorded.spec, recorded.signals
    xy = contact_grid(spec).xy_mm
    where = (np.full(len(xy), face), xy[:, 0], xy[:, 1])
    force = np.minimum(spec.score.force_n, press_traces(signals, *where).force_n[:, -1])
    own = own_channels(signals, spec.sensors, face)
    sigma = disturbance_counts(spec.sensors, "fresh", signals.baseline_counts.size)[own]
    bounds = cramer_rao_bounds(live_jacobian(spec, signals, *where, force)[:, own], sigma)
    return {
        "Cramér–Rao mean |F error| N": round(float(np.sqrt(2 / np.pi) * bounds.force_n.mean()), 4),
        "Cramér–Rao mean place error px": round(
            float(np.sqrt(np.pi) / 2 * bounds.position_mm.mean() / spec.contact_grid.pitch_mm), 4
        ),
    }


def run_reference(spec: ObjectSpec, folder: Path, quick: bool) -> StudyResult:
    """Bounds of every face on a fresh recording of the paper's collection."""
    from estimator.frames.face_data import face_data
    from estimator.metrics.heatmaps import force_reference

    recorded = simulated_object(spec, quick)
    rows = []
    for face in recorded.spec.collection.faces:
        frames = recorded.collect(faces=[face])
        span = force_reference(face_data(frames, face).heatmap_n)
        judged = judged_frames(recorded, face, frames)
        row = reference_row(judged, span) | cramer_rao_row(recorded, face)
        rows.append({"face": face} | row)
    return StudyResult(rows, [SIMULATED, __doc__ or ""])


STUDIES = (
    Study("reference-bounds", "Bayes' optimum for single frames, metric by metric.", run_reference),
)
