"""Makers of the stages from signals to metrics. Heavy imports stay inside."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path

from instobj.store.readers import (
    BLINDEST_PICTURE,
    CROSS_FACE,
    FRAMES,
    GRID_SIGNALS,
    IDENTIFIABILITY,
    IDENTIFIABILITY_PICTURE,
    MODELS,
    NUISANCE_COSTS,
    PRESSES,
    PROTOCOL,
    ROBUSTNESS,
    ROBUSTNESS_PICTURE,
    SCORES,
    SHEAR,
    SHEAR_SCORES,
    SIGNALS,
    WEAK_AREAS,
    WEAK_AREAS_PICTURE,
    WEAK_PLACES,
)
from instobj.store.stage import StageContext, write_json


def make_signals(context: StageContext, folder: Path) -> None:
    """Expected counts of every press."""
    from estimator.signals.presses import press_signals, save_grid_signals, save_signals

    forces, motions = context.read(PRESSES)
    signals = press_signals(context.spec, forces, motions, context.step)
    save_signals(signals, SIGNALS.path(folder))
    save_grid_signals(context.spec, signals, GRID_SIGNALS.path(folder), context.spec.seed)


def make_scores(context: StageContext, folder: Path) -> None:
    """Sensitivity, bounds, maps and cross-face disturbance."""
    from estimator.information.cross_face import RELATIONS, cross_face_disturbance
    from estimator.information.nuisance_cost import nuisance_costs
    from estimator.information.scores import save_scores_csv, score_places
    from instobj.figures.maps.files import draw_cross_face_map, draw_score_maps

    context.step("sensitivity and bounds of every location")
    signals = context.read(SIGNALS)
    scores = score_places(context.spec, signals, context.step)
    save_scores_csv(scores, SCORES.path(folder))
    draw_score_maps(context.spec, scores, folder / "maps", context.step)
    context.step("cost of what changes after the zero")
    costs = nuisance_costs(context.spec, signals, scores)
    write_json({"costs": [asdict(cost) for cost in costs]}, NUISANCE_COSTS.path(folder))
    context.step("presses on other faces")
    cross = cross_face_disturbance(context.spec, signals)
    summaries = {relation: cross.summary(relation) for relation in RELATIONS}
    write_json({"force_n": cross.force_n} | summaries, CROSS_FACE.path(folder))
    draw_cross_face_map(context.spec, cross, folder / "maps")


def make_weak_areas(context: StageContext, folder: Path) -> None:
    """Make the table of what weak locations have in common: their places on the body."""
    from estimator.information.weak_areas import save_weak_areas_csv, weak_areas
    from instobj.figures.maps.files import draw_measure_maps
    from instobj.figures.weak_areas import draw_weak_areas

    spec, scores = context.spec, context.read(SCORES)
    areas = weak_areas(spec, scores)
    save_weak_areas_csv(areas, scores, WEAK_PLACES.path(folder))
    content = {
        "told_by": areas.told_by,
        "edge_ratio": areas.edge_ratio,
        "edge_paths_mm": areas.edge_paths_mm,
        "beyond_rule": areas.exceeds_rule,
        "rank_correlation": areas.rank_correlation,
        "weakest_tenth": areas.weakest_tenth,
        "thirds": [asdict(third) for third in areas.thirds],
    }
    write_json(content, WEAK_AREAS.path(folder))
    limit = spec.limits.position_bound_mm
    draw_weak_areas(scores, areas, limit, WEAK_AREAS_PICTURE.path(folder))
    draw_measure_maps(spec, scores, areas, folder / "maps", context.step)


def make_shear_scores(context: StageContext, folder: Path) -> None:
    """Bounds with tangential forces unknown."""
    from estimator.information.shear import save_shear_scores_csv, score_shear, shear_signals
    from instobj.figures.maps.files import draw_shear_maps

    _, motions = context.read(PRESSES)
    shear = context.read(SHEAR)
    slopes = shear_signals(context.spec, motions, shear)
    scores = score_shear(context.spec, context.read(SIGNALS), slopes)
    save_shear_scores_csv(scores, SHEAR_SCORES.path(folder))
    draw_shear_maps(context.spec, scores, folder / "maps")


def make_identify(context: StageContext, folder: Path) -> None:
    """Information of several simultaneous contacts."""
    from estimator.information.identifiability import identifiability, save_identifiability
    from instobj.figures.information import draw_blindest, draw_identifiability

    presses = context.read(PRESSES)
    rows = identifiability(context.spec, *presses, progress=context.step)
    save_identifiability(rows, IDENTIFIABILITY.path(folder))
    draw_identifiability(context.spec, rows, IDENTIFIABILITY_PICTURE.path(folder))
    draw_blindest(context.spec, rows, BLINDEST_PICTURE.path(folder))


def make_robustness(context: StageContext, folder: Path) -> None:
    """Budget of tolerances."""
    from estimator.tolerances.budget import robustness
    from estimator.tolerances.result import save_robustness
    from instobj.figures.robustness import draw_robustness

    presses = context.read(PRESSES)
    budget = robustness(context.spec, *presses, context.step)
    save_robustness(budget, ROBUSTNESS.path(folder))
    draw_robustness(context.spec, budget, ROBUSTNESS_PICTURE.path(folder))


def make_frames(context: StageContext, folder: Path) -> None:
    """Simulated calibration presses."""
    from design.layout.places.contact_places import contact_places
    from estimator.frames.dataset import save_frames
    from estimator.frames.press_protocol import nominal_peaks, plan_presses, simulate_presses

    signals = context.read(SIGNALS)
    frames = simulate_presses(context.spec, signals, context.key, context.step)
    peaks = nominal_peaks(context.spec, signals)
    depth = peaks.depth_mm[contact_places(context.spec)]
    write_json(
        plan_presses(context.spec, signals).summary()
        | {
            "common_travel_mm": peaks.common_travel_mm,
            "deepest_peak_mm": float(depth.max()),
            "shallowest_peak_mm": float(depth.min()),
            "clamped_places": int(peaks.clamped.sum()),
        },
        PROTOCOL.path(folder),
    )
    save_frames(frames, FRAMES.path(folder))


def make_networks(context: StageContext, folder: Path) -> None:
    """A network per face."""
    from estimator.frames.splits import split_presses
    from instobj.stages.makers.learning import Fitting, train_networks, unfinished_folder

    spec, frames = context.spec, context.read(FRAMES)
    unfinished = unfinished_folder(context.key)
    how = Fitting(spec.training, spec.seed, context.step, unfinished, spec=spec)
    train_networks(frames, split_presses(frames, spec.seed), how, folder)


def make_metrics(context: StageContext, folder: Path) -> None:
    """Held-out presses."""
    from estimator.frames.splits import split_presses
    from instobj.stages.makers.learning import evaluate_networks

    frames = context.read(FRAMES)
    split = split_presses(frames, context.spec.seed)
    evaluate_networks(frames, split, context.read(MODELS), folder, context.step)
