"""The estimator on recordings of a real object: presses, places and a recording held out.

    python benchmarks/recordings.py RECORDING [--other RECORDING] [--seeds 5] [--quick] [--out FOLDER]

Each press is zeroed from the frames before it; a face's own channels are read. The change over time
that is read (`training.history_frames`) is chosen among 0, 3, 6 and 9 frames by cross-validation
within the training presses of the first seed; ensemble, trees and process are the defaults for so
few presses. Beside it stand the simple regressions of `estimator.evaluation.baselines`, and the
coverage of intervals: at held-out presses, places and, with `--other`, the other recording. Writes
`recordings.json`.
"""

from __future__ import annotations

import sys
from dataclasses import asdict
from pathlib import Path

import numpy as np
import torch
from harness import Result, conclude, machine, option_parser

from design.spec.object import TrainingSpec
from estimator.evaluation.baselines import baseline_reports, held_out_answers
from estimator.evaluation.evaluation import (
    evaluate_face,
    evaluate_intervals,
)
from estimator.frames.collection import joined
from estimator.frames.dataset import FrameSet
from estimator.frames.heatmap import faces_pressed
from estimator.frames.splits import Split, split_places, split_presses
from estimator.networks.face_model import FaceModel
from estimator.networks.training.face import FitSettings, fit_estimator
from estimator.recordings.reading import read_recording
from studies.paper.heatmap_baselines import linear_baseline, mean_map_baseline
from studies.recorded.rest_offset import rest_offset_baseline

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
    """The specification's defaults; quick: one small network."""
    small = (
        {"ensemble": 1, "trees": 5, "process": True, "epochs": 3, "hidden_units": (16,)}
        if quick
        else {}
    )
    return TrainingSpec.model_validate(small | changes)


def chosen_history(frames: FrameSet, face: int, seed: int, quick: bool) -> int:
    """Frames of change with the least error of force on inner held-out presses."""
    split = split_presses(frames, seed)
    known = frames.select(split.train | split.validation)
    errors = []
    for history in HISTORIES[:2] if quick else HISTORIES:
        wanted = training(quick, history_frames=history, ensemble=1, trees=0, process=False)
        found = []
        for inner_seed in range(1 if quick else 2):
            inner = split_presses(known, inner_seed)
            model = _fitted(known, inner, face, wanted, seed)
            found.append(evaluate_face(model, known.select(inner.test), known))
        errors.append(np.mean([one.force_error_percent for one in found]))
    return HISTORIES[int(np.argmin(errors))]


def _fitted(
    frames: FrameSet,
    split: Split,
    face: int,
    wanted: TrainingSpec,
    seed: int,
    continuous: bool = False,
):
    parts = frames.select(split.train), frames.select(split.validation)
    return fit_estimator(*parts, FitSettings(face, wanted, seed, continuous=continuous))


def one_seed(frames: FrameSet, face: int, seed: int, wanted: TrainingSpec) -> Result:
    """Metrics and intervals on held-out presses."""
    split = split_presses(frames, seed)
    model = _fitted(frames, split, face, wanted, seed)
    test = frames.select(split.test)
    metrics = evaluate_face(model, test, frames).summary()
    return (
        {name: metrics[name] for name in _COLUMNS}
        | asdict(evaluate_intervals(model, test))
        | {"baselines": _baselines(model, frames, split)}
    )


def _baselines(model: FaceModel, frames: FrameSet, split: Split) -> list[Result]:
    return [row.summary() for row in baseline_reports(held_out_answers(model, frames, split))]


def unseen_place(frames: FrameSet, face: int, seed: int, wanted: TrainingSpec) -> Result:
    """Metrics at whole places held out, with heatmap and with position output."""
    split, found = split_places(frames, seed), {}
    for output in ("heatmap", "position"):
        model = _fitted(frames, split, face, wanted, seed, output == "position")
        test = frames.select(split.test)
        metrics = evaluate_face(model, test, frames).summary()
        found[output] = {name: metrics[name] for name in _COLUMNS}
        found[output] |= asdict(evaluate_intervals(model, test))
        found[output]["baselines"] = _baselines(model, frames, split)
    return found


def other_recording(frames: FrameSet, other: FrameSet, face: int, wanted: TrainingSpec) -> Result:
    """Metrics and intervals on a recording of the same object that gave no training press."""
    split = split_presses(frames, 0)
    known = Split(split.train | split.test, split.validation, np.zeros(len(frames), dtype=bool))
    model = _fitted(frames, known, face, wanted, 0)
    metrics = evaluate_face(model, other, other).summary()
    test = np.arange(len(frames) + len(other)) >= len(frames)
    apart = Split(~test, np.zeros_like(test), test)
    return (
        {name: metrics[name] for name in _COLUMNS}
        | asdict(evaluate_intervals(model, other))
        | {"baselines": _baselines(model, joined([frames, other]), apart)}
    )


def measured(path: Path, other: Path | None, seeds: int, quick: bool) -> Result:
    """All faces that the recording presses."""
    recording = read_recording(path)
    elsewhere = None if other is None else read_recording(other).frames
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
            "other_recording": None
            if elsewhere is None
            else other_recording(frames, elsewhere, face, wanted),
            "linear": linear_baseline(frames, face, split).summary(),
            "mean_map": mean_map_baseline(frames, face, split).summary(),
        }
    return result


def _covers(rows: list[Result]) -> str:
    force, place = (
        np.mean([row[f"{what}_cover"] for row in rows]) for what in ("force", "position")
    )
    return f"cover {force:.3f} of forces and {place:.3f} of places"


def _baseline_lines(seeds: list[Result]) -> list[str]:
    """Means over the seeds."""
    lines = []
    for rows in zip(*(seed["baselines"] for seed in seeds), strict=True):
        percent, away = (
            np.array([row[name] for row in rows], float).mean()
            for name in ("total_force_percent", "place_mm")
        )
        lines.append(f"      {rows[0]['name']}: total force {percent:.2f} %, place {away:.2f} mm")
    return lines


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
                f"    places held out, {output}: E_loc {away:.2f} px, total force {total:.1f} %; 90 % "
                f"intervals {_covers(rows)}"
            )
            lines += _baseline_lines(rows)
        if found["other_recording"]:
            rows = [found["other_recording"]]
            lines.append(f"    other recording: 90 % intervals {_covers(rows)}")
            lines += _baseline_lines(rows)
        lines.append("    whole presses:")
        lines += _baseline_lines(found["seeds"])
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
    parser.add_argument("--other", type=Path, help="recording of the same object to test on")
    parser.add_argument("--seeds", type=int, default=5)
    options = parser.parse_args(arguments)
    torch.set_num_threads(1)
    result = {"machine": machine(1, ("torch",))}
    result |= measured(options.recording, options.other, options.seeds, options.quick)
    conclude("recordings", options, result, report)


if __name__ == "__main__":
    main(sys.argv[1:])
