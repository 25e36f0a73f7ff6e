"""Our estimator against the network and recipe of Knopke et al. (RA-L 2024) at an equal time.

    python benchmarks/estimators.py [--quick] [--minutes 10] [--out FOLDER]

Both are trained on the same simulated presses of one face for the same wall-clock time, one thread,
half of the minutes each, and judged on presses that neither saw. Presses are made up and smooth
(those of `scores.py`) with the sensors' measured noise.
Writes `estimators.json`.
"""

from __future__ import annotations

import sys
import tempfile
import time
from pathlib import Path

import numpy as np
import torch
from harness import Result, conclude, machine, option_parser
from scores import made_up_presses

from design.spec import ObjectSpec, TrainingSpec
from estimator.dataset import FrameSet
from estimator.deploy import export_onnx
from estimator.deployed import DeployedModel, load_deployed, run_model
from estimator.evaluation import evaluate_face
from estimator.face_model import FaceModel
from estimator.press_protocol import simulate_presses
from estimator.signals import press_signals
from estimator.splits import Split, split_presses
from estimator.training import FitSettings, fit_estimator

FACE, SEED = 3, 1
PAPER_EPOCHS, PAPER_FRAMES = 1000, 85_800
INFERENCE_TARGET_MS, SPEED_TARGET = 0.2, 20.0
NAMES = ("compact", "paper")


def made_frames(quick: bool) -> FrameSet:
    """Simulated calibration presses of one face (full: 143 000 frames, as the paper's)."""
    grid = {"count": (4, 4), "pitch_mm": 6.0} if quick else {}
    protocol = (
        {"presses_per_place": 4, "frames_per_press": 12, "rest_frames_per_press": 4}
        if quick
        else {"presses_per_place": 26, "frames_per_press": 44, "rest_frames_per_press": 11}
    )
    protocol["peak_force_n"] = (6.0, 13.0)
    spec = ObjectSpec.model_validate(
        {"name": "benchmark", "contact_grid": grid, "protocol": protocol}
    )
    forces, motions = made_up_presses(spec)
    rows = np.flatnonzero(forces.faces == FACE)
    one = type(forces)(
        forces.faces[rows], forces.lattice, forces.depth_mm, forces.force_n[rows],
        forces.contact_area_mm2[rows],
    )  # fmt: skip
    moved = type(motions)(
        motions.faces[rows], motions.lattice, motions.depth_mm, motions.motion[rows]
    )
    return simulate_presses(spec, press_signals(spec, one, moved), "benchmark")


def trained(name: str, frames: FrameSet, split: Split, budget_s: float) -> tuple[FaceModel, Result]:
    """One recipe within its budget, with the time of an epoch as measured."""
    marks: list[float] = []
    epochs = PAPER_EPOCHS if name == "paper" else 60
    training = TrainingSpec(model=name, epochs=epochs, patience_epochs=epochs)
    settings = FitSettings(FACE, training, SEED, budget_s=budget_s)
    parts = frames.select(split.train), frames.select(split.validation)
    begin = time.perf_counter()
    model = fit_estimator(
        *parts, settings, progress=lambda *_: marks.append(time.perf_counter() - begin)
    )
    whole = np.diff(marks[:-1]) if len(marks) > 2 else np.array(marks[:1])
    result = evaluate_face(model, frames.select(split.test), frames)
    return model, {
        "epochs": len(marks),
        "seconds": marks[-1],
        "seconds_an_epoch": float(np.median(whole)),
        "A_sim": result.similarity,
        "E_loc_px": result.location_error_px,
        "E_f_percent": result.force_error_percent,
        "A_non": result.non_contact_accuracy,
        "weights": sum(p.numel() for p in model.network.parameters()),
    }


def inference(models: dict[str, FaceModel], quick: bool) -> Result:
    """Milliseconds a frame through onnxruntime, one frame at a time, one thread."""
    found: Result = {}
    with tempfile.TemporaryDirectory() as folder:
        for name, model in models.items():
            path = Path(folder) / f"{name}.onnx"
            export_onnx(model, path)
            found[f"{name}_ms"] = frame_ms(load_deployed(path), 40 if quick else 400)
    found["times_faster"] = found["paper_ms"] / found["compact_ms"]
    return found


def frame_ms(model: DeployedModel, repeats: int) -> float:
    """Least of five medians."""
    counts = np.random.default_rng(0).normal(0, 300, (1, len(model.channels)))
    medians = []
    for _ in range(5):
        times = []
        for _ in range(repeats):
            begin = time.perf_counter()
            run_model(model, counts)
            times.append(time.perf_counter() - begin)
        medians.append(np.median(times))
    return 1e3 * float(min(medians))


def seconds_to_within(frames: FrameSet, split: Split, final_percent: float) -> float:
    """Wall-clock seconds of the compact recipe whose schedule ends within 10 % of `final_percent`;
    NaN if none of the schedules tried does."""
    parts = frames.select(split.train), frames.select(split.validation)
    for tried in (5, 10, 20, 40):
        begin = time.perf_counter()
        model = fit_estimator(*parts, FitSettings(FACE, TrainingSpec(epochs=tried), SEED))
        seconds = time.perf_counter() - begin
        error = evaluate_face(model, frames.select(split.test), frames).force_error_percent
        if error <= 1.1 * final_percent:
            return seconds
    return float("nan")


def measured(quick: bool, minutes: float) -> Result:
    """Train, judge, time."""
    frames = made_frames(quick)
    split = split_presses(frames, SEED)
    budget_s = 3.0 if quick else 30.0 * minutes
    models, recipes = {}, {}
    for name in NAMES:
        models[name], recipes[name] = trained(name, frames, split, budget_s)
    share = PAPER_FRAMES / int(split.train.sum())
    epoch_s = recipes["paper"]["seconds_an_epoch"] * share
    found = {
        "frames": {"all": len(frames), "train": int(split.train.sum())},
        "budget_s_each": budget_s,
        "recipes": recipes,
        "extrapolated_hours_of_the_papers_whole_recipe": PAPER_EPOCHS * epoch_s / 3600,
        "inference": inference(models, quick),
    }
    if not quick:
        final = recipes["compact"]["E_f_percent"]
        found["compact_seconds_to_within_10_percent"] = seconds_to_within(frames, split, final)
    return found


def report(result: Result) -> str:
    """The figures in words."""
    lines = [
        f"{result['budget_s_each']:g} s each, {result['frames']['train']} training frames, "
        f"held-out presses ({result['machine']['processor']}):"
    ]
    for name, row in result["recipes"].items():
        lines.append(
            f"  {name:8} {row['epochs']:4d} epochs of {row['seconds_an_epoch']:.3g} s: A_sim "
            f"{row['A_sim']:.3f}, E_loc {row['E_loc_px']:.3f} px, E_f {row['E_f_percent']:.2f} %, "
            f"A_non {row['A_non']:.3f}"
        )
    lines.append(
        f"  the paper's {PAPER_EPOCHS} epochs of {PAPER_FRAMES} frames, extrapolated: "
        f"{result['extrapolated_hours_of_the_papers_whole_recipe']:.1f} h"
    )
    if "compact_seconds_to_within_10_percent" in result:
        lines.append(
            "  compact, to within 10 % of its final E_f: "
            f"{result['compact_seconds_to_within_10_percent']:.0f} s (aim 120 s)"
        )
    times = result["inference"]
    lines.append(
        f"  one frame by onnxruntime: compact {times['compact_ms']:.3f} ms (aim "
        f"{INFERENCE_TARGET_MS:g}), paper {times['paper_ms']:.2f} ms: {times['times_faster']:.0f} "
        f"times faster (aim {SPEED_TARGET:g})"
    )
    return "\n".join(lines)


def main(arguments: list[str]) -> None:
    """Measure, write, report."""
    parser = option_parser("Our estimator against the paper's at an equal time")
    parser.add_argument("--minutes", type=float, default=10.0, help="of training in all")
    options = parser.parse_args(arguments)
    torch.set_num_threads(1)
    result = {"machine": machine(1, ("torch", "onnxruntime"))}
    result |= measured(options.quick, options.minutes)
    conclude("estimators", options, result, report)


if __name__ == "__main__":
    main(sys.argv[1:])
