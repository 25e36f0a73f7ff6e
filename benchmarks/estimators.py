"""Our estimator against the network and recipe of Knopke et al. (RA-L 2024) at an equal time.

    python benchmarks/estimators.py [--quick] [--minutes 10] [--out FOLDER]

Both are trained on the same simulated presses of one face for the same wall-clock time, one thread,
half of the minutes each, and judged on presses that neither saw. Ours is trained once more, in a
fifth of the minutes (two of ten). Presses are made up and smooth (those of `scores.py`) with the
sensors' measured noise. Finished trainings stand in a folder `estimators_parts_…` until all are:
an interrupted run goes on from them. Writes `estimators.json`.
"""

from __future__ import annotations

import shutil
import sys
import time
from functools import partial
from pathlib import Path

import numpy as np
import torch
from harness import Result, conclude, kept, machine, option_parser, parts_folder
from scores import made_up_presses

from design.spec.object import ObjectSpec, TrainingSpec
from estimator.deploy.export import export_onnx
from estimator.deploy.runtime import DeployedModel, load_deployed, run_model
from estimator.evaluation.evaluation import evaluate_face
from estimator.frames.dataset import FrameSet
from estimator.frames.press_protocol import simulate_presses
from estimator.frames.splits import Split, split_presses
from estimator.networks.defaults import filled
from estimator.networks.training.face import FitSettings, fit_estimator
from estimator.signals.presses import press_signals
from studies.paper.network import fit_paper

FACE, SEED = 3, 1
PAPER_EPOCHS, PAPER_FRAMES = 1000, 85_800
INFERENCE_TARGET_MS, SPEED_TARGET = 0.2, 20.0
SHORT = "compact, a fifth of the time"
SHARES = {"compact": 0.5, "paper": 0.5, SHORT: 0.2}
"""Trainings and their shares of the minutes."""


def made_frames(quick: bool) -> FrameSet:
    """Simulated calibration presses of one face (full: 143 000 frames, as the paper's)."""
    grid = {"count": (4, 4), "pitch_mm": 6.0} if quick else {}
    protocol = (
        {"presses_per_place": 4, "frames_per_press": (4, 12)}
        if quick
        else {"presses_per_place": 26, "frames_per_press": (11, 44)}
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


def trained(name: str, frames: FrameSet, split: Split, budget_s: float, parts: Path) -> Result:
    """One recipe within its budget, with the time of an epoch as measured; the network to `parts`."""
    model_name = name.split(",")[0]
    marks: list[float] = []
    epochs = PAPER_EPOCHS if model_name == "paper" else 60
    training = filled(TrainingSpec(epochs=epochs))
    settings = FitSettings(FACE, training, SEED, budget_s=budget_s, patience_epochs=epochs)
    known = frames.select(split.train), frames.select(split.validation)
    begin = time.perf_counter()
    fit = fit_paper if model_name == "paper" else fit_estimator
    model = fit(*known, settings, progress=lambda *_: marks.append(time.perf_counter() - begin))
    whole = np.diff(marks[:-1]) if len(marks) > 2 else np.array(marks[:1])
    scores = evaluate_face(model, frames.select(split.test), frames)
    export_onnx(model, parts / f"{name}.onnx")
    return {
        "epochs": len(marks),
        "seconds": marks[-1],
        "seconds_an_epoch": float(np.median(whole)),
        "A_sim": scores.similarity,
        "E_loc_px": scores.location_error_px,
        "E_f_percent": scores.force_error_percent,
        "A_non": scores.non_contact_accuracy,
        "weights": sum(p.numel() for p in model.network.parameters()),
    }


def all_trained(frames: FrameSet, split: Split, whole_s: float, parts: Path) -> Result:
    """Every recipe within its share of the time, those that `parts` holds from there."""
    return {
        name: kept(parts, name, partial(trained, name, frames, split, share * whole_s, parts))
        for name, share in SHARES.items()
    }


def inference(parts: Path, quick: bool) -> Result:
    """Milliseconds a frame through onnxruntime, one frame at a time, one thread."""
    repeats = 40 if quick else 400
    found: Result = {
        f"{name}_ms": frame_ms(load_deployed(parts / f"{name}.onnx"), repeats)
        for name in ("compact", "paper")
    }
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


def measured(quick: bool, minutes: float, parts: Path) -> Result:
    """Train, judge, time."""
    frames = made_frames(quick)
    split = split_presses(frames, SEED)
    whole_s = 6.0 if quick else 60.0 * minutes
    recipes = all_trained(frames, split, whole_s, parts)
    share = PAPER_FRAMES / int(split.train.sum())
    epoch_s = recipes["paper"]["seconds_an_epoch"] * share
    return {
        "frames": {"all": len(frames), "train": int(split.train.sum())},
        "budget_s": {name: share * whole_s for name, share in SHARES.items()},
        "recipes": recipes,
        "extrapolated_hours_of_the_papers_whole_recipe": PAPER_EPOCHS * epoch_s / 3600,
        "compact_short_over_long_E_f": recipes[SHORT]["E_f_percent"]
        / recipes["compact"]["E_f_percent"],
        "inference": inference(parts, quick),
    }


def report(result: Result) -> str:
    """The figures in words."""
    processor = result["machine"]["processor"]
    lines = [f"{result['frames']['train']} training frames, held-out presses ({processor}):"]
    for name, row in result["recipes"].items():
        lines.append(
            f"  {name}, {result['budget_s'][name]:g} s: {row['epochs']} epochs of "
            f"{row['seconds_an_epoch']:.3g} s: A_sim "
            f"{row['A_sim']:.3f}, E_loc {row['E_loc_px']:.3f} px, E_f {row['E_f_percent']:.2f} %, "
            f"A_non {row['A_non']:.3f}"
        )
    lines.append(
        f"  the paper's {PAPER_EPOCHS} epochs of {PAPER_FRAMES} frames, extrapolated: "
        f"{result['extrapolated_hours_of_the_papers_whole_recipe']:.1f} h"
    )
    lines.append(
        "  E_f of compact in a fifth of the minutes over that in half of them: "
        f"{result['compact_short_over_long_E_f']:.2f} (aim 1.1 after 120 s)"
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
    parser.add_argument(
        "--minutes", type=float, default=10.0, help="of training of the two compared"
    )
    options = parser.parse_args(arguments)
    torch.set_num_threads(1)
    result = {"machine": machine(1, ("torch", "onnxruntime")), "quick": options.quick}
    form = "quick" if options.quick else f"{options.minutes:g}_min"
    parts = parts_folder("estimators", form, options, result)
    result |= measured(options.quick, options.minutes, parts)
    conclude("estimators", options, result, report)
    shutil.rmtree(parts)


if __name__ == "__main__":
    main(sys.argv[1:])
