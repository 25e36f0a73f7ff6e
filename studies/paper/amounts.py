"""Amount of training data, and its distribution over contact locations."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from estimator.frames.splits import split_paper_random_frames
from studies.paper.figures import draw_bars, draw_lines, headline
from studies.paper.object import (
    SIMULATED,
    SimulatedObject,
    fitted,
    metric_row,
    predict_face,
    simulated_object,
)
from studies.paper.published import LEAST_TRAINING_FRAMES, TABLE_I
from studies.paper.unseen import seen_places
from studies.registry import Study, StudyResult

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec
    from estimator.frames.dataset import FrameSet
    from estimator.networks.face_model import FaceModel

_HALVINGS = 10
_LEAST_FRAMES = 40


def run_data_amount(spec: ObjectSpec, folder: Path, quick: bool) -> StudyResult:
    """The paper's training part halved ten times; the same test part throughout."""
    from estimator.frames.face_data import face_data
    from estimator.metrics.heatmaps import face_metrics, force_reference

    recorded = simulated_object(spec, quick)
    face = recorded.spec.collection.faces[0]
    frames = recorded.collect(faces=[face])
    span = force_reference(face_data(frames, face).heatmap_n)
    split = split_paper_random_frames(frames, recorded.spec.seed)
    train, validation = np.flatnonzero(split.train), np.flatnonzero(split.validation)
    test, rng = frames.select(split.test), np.random.default_rng(recorded.spec.seed)
    train, validation = rng.permutation(train), rng.permutation(validation)
    rows = []
    for halvings in range(0, _HALVINGS + 1, 2 if quick else 1):
        if len(train) >> halvings < _LEAST_FRAMES:
            break
        parts = tuple(
            frames.select(np.sort(part[: max(_LEAST_FRAMES, len(part) >> halvings)]))
            for part in (train, validation)
        )
        label = {"collection": "paper", "faces": [face], "halvings": halvings}
        model = fitted(recorded, (parts[0], parts[1]), face, label)
        predicted, true, rest = predict_face(model, test)
        found = face_metrics(face, predicted, true, span, rest)
        rows.append(
            {"data": f"1/{2**halvings}", "training frames": len(parts[0])} | metric_row(found)
        )
    amount = np.array([row["training frames"] for row in rows])
    shown = {
        "A_sim": "similarity A_sim",
        "E_loc px": "location error E_loc (px)",
        "E_f %": "force error E_f (%)",
        "A_non": "accuracy at rest, A_non",
    }
    draw_lines(
        amount,
        {label: np.array([row[name] for row in rows]) for name, label in shown.items()},
        "training frames",
        headline(f"face {face}, frames split at random", quick),
        folder / "data-amount.png",
        {label: TABLE_I[face][name] for name, label in shown.items() if face in TABLE_I},
        (float(LEAST_TRAINING_FRAMES), "the paper's held down to here"),
    )
    texts = [
        SIMULATED,
        f"The paper's performance held down to {LEAST_TRAINING_FRAMES} training frames, 1/32 of all.",
    ]
    return StudyResult(rows, texts)


def run_places(spec: ObjectSpec, folder: Path, quick: bool) -> StudyResult:
    """One budget of frames spent on few places or on many, tested anywhere on the face."""
    recorded = simulated_object(spec, quick)
    face, protocol = recorded.spec.collection.faces[0], recorded.spec.protocol
    score_presses = sum(protocol.frames_per_press)
    budget = 60 * score_presses if quick else 600 * score_presses
    tested = recorded.collect(
        seed=1, kind="continuous", faces=[face], presses=60 if quick else 1000
    )
    grid = recorded.collect(faces=[face], poses=[[], []])
    anywhere = recorded.collect(
        seed=2, kind="continuous", faces=[face], presses=budget // score_presses
    )
    recordings = {
        "every second place": grid.select(seen_places(grid)),
        "every place": grid,
        "anywhere": anywhere,
    }
    budget = min(len(frames) for frames in recordings.values())
    rows = []
    for name, frames in recordings.items():
        chosen = _thinned(frames, budget, recorded.spec.seed)
        split = split_paper_random_frames(chosen, recorded.spec.seed)
        label = {"places": name, "budget": budget}
        parts = (chosen.select(split.train | split.test), chosen.select(split.validation))
        model = fitted(recorded, parts, face, label, continuous=True)
        rows.append(
            {"labelled": name, "places": _places(chosen), "frames": len(chosen)}
            | _anywhere_row(model, tested, recorded)
        )
    draw_bars(
        rows,
        "labelled",
        {
            "localisation error (mm)": {"mean distance mm": "mean"},
            "total force error (% of the mean force)": {"total force %": "mean"},
        },
        headline(f"contacts anywhere on face {face}, {budget} labelled frames each", quick),
        folder / "places-against-frames.png",
    )
    return StudyResult(rows, [SIMULATED, "The paper labels 100 locations with 1000 frames each."])


def _thinned(frames: FrameSet, count: int, seed: int) -> FrameSet:
    chosen = np.random.default_rng(seed).permutation(len(frames))[:count]
    return frames.select(np.sort(chosen))


def _places(frames: FrameSet) -> int:
    pressed = frames.contact_face[:, 0] > 0
    return len(np.unique(frames.contact_xy_mm[pressed, 0], axis=0))


def _anywhere_row(
    model: FaceModel, tested: FrameSet, recorded: SimulatedObject
) -> dict[str, float]:
    from estimator.frames.face_data import face_data
    from estimator.networks.face_model import predict

    data = face_data(tested, model.face)
    data = data.select(data.contact)
    found, force = predict(model, data.frames), data.heatmap_n.sum(axis=(1, 2))
    away = np.linalg.norm(found.xy_mm - data.centre_mm, axis=1)
    return {
        "mean distance mm": round(float(away.mean()), 4),
        "90th percentile mm": round(float(np.quantile(away, 0.9)), 4),
        "total force N": round(float(abs(found.force_n - force).mean()), 4),
        "total force %": round(100 * float(abs(found.force_n - force).mean() / force.mean()), 3),
    }


STUDIES: Sequence[Study] = (
    Study("data-amount", "Training frames halved ten times.", run_data_amount),
    Study(
        "places-against-frames", "The same number of frames at few locations or many.", run_places
    ),
)
