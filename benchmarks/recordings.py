"""The estimator on recordings of a real object, presses and places held out, over several seeds.

    python benchmarks/recordings.py RECORDING [--seeds 5] [--quick] [--out FOLDER]

Each press is zeroed from the frames before it; a face's own channels are read. The change over time
that is read (`training.history_frames`) is chosen among 0, 3, 6 and 9 frames by cross-validation
within the training presses of the first seed. Writes `recordings.json`.
"""

from __future__ import annotations

import sys
from dataclasses import asdict
from pathlib import Path

import numpy as np
import torch
from harness import Result, conclude, machine, option_parser

from design.spec.object import TrainingSpec
from estimator.evaluation.evaluation import (
    evaluate_face,
    evaluate_intervals,
    linear_baseline,
    mean_map_baseline,
    rest_offset_baseline,
)
from estimator.frames.dataset import FrameSet
from estimator.frames.heatmap import faces_pressed
from estimator.frames.splits import Split, split_places, split_presses
from estimator.networks.training import FitSettings, fit_estimator
from estimator.recordings.reading import read_recording

HISTORIES = (0, 3, 6, 9)
FORCE_TARGET_PERCENT, QUIET_TARGET = 5.0, 0.98
_COLUMNS = (
    "force_error_percent",
    "total_force_error_percent",
    "non_contact_accuracy",
    "similarity",
    "location_error_px",
)


def training(quick: bool, **changes: object) -> TrainingSpec:
    """The specification's defaults with an ensemble of five; quick: one small network."""
    small = {"ensemble": 1, "epochs": 3, "hidden_units": (16,)} if quick else {"ensemble": 5}
    return TrainingSpec.model_validate(small | changes)


def chosen_history(frames: FrameSet, face: int, seed: int, quick: bool) -> int:
    """Frames of change with the least error of force on inner held-out presses."""
    split = split_presses(frames, seed)
    known = frames.select(split.train | split.validation)
    errors = []
    for history in HISTORIES[:2] if quick else HISTORIES:
        wanted = training(quick, history_frames=history, ensemble=1)
        found = []
        for inner_seed in range(1 if quick else 2):
            inner = split_presses(known, inner_seed)
            model = _fitted(known, inner, face, wanted, seed)
            found.append(evaluate_face(model, known.select(inner.test), known))
        errors.append(np.mean([one.force_error_percent for one in found]))
    return HISTORIES[int(np.argmin(errors))]


def _fitted(frames: FrameSet, split: Split, face: int, wanted: TrainingSpec, seed: int):
    parts = frames.select(split.train), frames.select(split.validation)
    return fit_estimator(*parts, FitSettings(face, wanted, seed))


def one_seed(frames: FrameSet, face: int, seed: int, wanted: TrainingSpec) -> Result:
    """Metrics and intervals on held-out presses."""
    split = split_presses(frames, seed)
    model = _fitted(frames, split, face, wanted, seed)
    test = frames.select(split.test)
    metrics = evaluate_face(model, test, frames).summary()
    return {name: metrics[name] for name in _COLUMNS} | asdict(evaluate_intervals(model, test))


def unseen_place(frames: FrameSet, face: int, seed: int, wanted: TrainingSpec) -> Result:
    """Metrics at whole places held out, with heatmap and with position output."""
    split, found = split_places(frames, seed), {}
    for output in ("heatmap", "position"):
        changes = wanted.model_dump() | {"output": output, "ensemble": 1}
        model = _fitted(frames, split, face, TrainingSpec.model_validate(changes), seed)
        metrics = evaluate_face(model, frames.select(split.test), frames).summary()
        found[output] = {name: metrics[name] for name in _COLUMNS}
    return found


def measured(path: Path, seeds: int, quick: bool) -> Result:
    """All faces that the recording presses."""
    recording = read_recording(path)
    frames = recording.frames
    rest_offset = rest_offset_baseline([recording], seed=1)
    result: Result = {
        "recording": path.name,
        "rest_offset_only": asdict(rest_offset),
        "faces": {},
    }
    for face in faces_pressed(frames):
        history = chosen_history(frames, face, 0, quick)
        wanted = training(quick, history_frames=history)
        split = split_presses(frames, 0)
        result["faces"][str(face)] = {
            "history_frames": history,
            "seeds": [one_seed(frames, face, seed, wanted) for seed in range(seeds)],
            "unseen_places": [unseen_place(frames, face, seed, wanted) for seed in range(seeds)],
            "linear": linear_baseline(frames, face, split).summary(),
            "mean_map": mean_map_baseline(frames, face, split).summary(),
        }
    return result


def report(result: Result) -> str:
    """Means and spreads over the seeds."""
    lines = [f"{result['recording']}, whole presses held out:"]
    for face, found in result["faces"].items():
        percent, quiet, near = (
            np.array([row[name] for row in found["seeds"]], float)
            for name in ("force_error_percent", "non_contact_accuracy", "location_error_px")
        )
        cover = [[row[f"{what}_cover"] for row in found["seeds"]] for what in ("force", "position")]
        lines.append(
            f"  face {face}: E_f {percent.mean():.2f} ± {percent.std():.2f} % (aim "
            f"{FORCE_TARGET_PERCENT:g}), A_non {quiet.mean():.3f}, worst {quiet.min():.3f} (aim "
            f"{QUIET_TARGET:g}), E_loc {near.mean():.3f} px; 90 % intervals cover "
            f"{np.mean(cover[0]):.3f} of forces and {np.mean(cover[1]):.3f} of places; "
            f"change over {found['history_frames']} frames"
        )
        for output in ("heatmap", "position"):
            rows = [row[output] for row in found["unseen_places"]]
            away, total = (
                np.nanmean([np.nan if row[name] is None else row[name] for row in rows])
                for name in ("location_error_px", "total_force_error_percent")
            )
            lines.append(
                f"    places held out, {output}: E_loc {away:.2f} px, total force {total:.1f} %"
            )
        lines.append(
            f"    linear {found['linear']['force_error_percent']:.1f} %, always the mean map "
            f"{found['mean_map']['force_error_percent']:.1f} % and "
            f"{found['mean_map']['location_error_px']:.2f} px"
        )
    offset = result["rest_offset_only"]
    lines.append(
        f"  the case guessed from the resting level alone: {offset['accuracy']:.2f}, chance "
        f"{offset['chance']:.2f}"
    )
    return "\n".join(lines)


def main(arguments: list[str]) -> None:
    """Measure, write, report."""
    parser = option_parser("The estimator on recordings of a real object")
    parser.add_argument("recording", type=Path)
    parser.add_argument("--seeds", type=int, default=5)
    options = parser.parse_args(arguments)
    torch.set_num_threads(1)
    result = {"machine": machine(1, ("torch",))}
    result |= measured(options.recording, options.seeds, options.quick)
    conclude("recordings", options, result, report)


if __name__ == "__main__":
    main(sys.argv[1:])
