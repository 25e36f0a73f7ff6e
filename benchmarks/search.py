"""Scoring layouts in batches against scoring each the plain way, and how far both agree.

    python benchmarks/search.py [--quick] [--out FOLDER]

Layouts of five magnets and three sensors per face are random; all are scored for presses of one face,
Fisher information included, the other faces' magnets too. The plain way meshes a layout's magnets,
solves, presses every place and sums exact fields by magpylib; its mechanics is timed for few
layouts, and what many would take is extrapolated. Agreement is with exact fields of all magnets at
the same stored motions: as they are, and scaled down, where signals are linear in them. Times are
processor time on one thread. Writes `search.json`.
"""

from __future__ import annotations

import tempfile
import time
from dataclasses import replace
from pathlib import Path
from typing import Any

import magpylib
import numpy as np
import torch
from harness import best_seconds, machine, run
from scipy.interpolate import make_interp_spline
from scipy.spatial.distance import pdist
from scipy.spatial.transform import Rotation
from scipy.stats import spearmanr

from design.layout.body import core_frames, face_frames
from design.layout.places.contact_grid import contact_grid, grid_places_in_lattice
from design.layout.places.positions import chip_on_board
from design.layout.pockets import board_frame, tilted_frame
from design.spec.object import ObjectSpec
from estimator.field.sources import magnet_source
from estimator.information.fisher import cramer_rao_bounds, disturbance_counts
from estimator.layouts.batch import Layouts
from estimator.layouts.batch_scores import batch_scores
from estimator.layouts.presses.basis import press_basis
from estimator.layouts.scorer import LayoutScorer, layout_scorer
from fem.candidates.motions import CandidateMotions, candidate_lattices
from fem.candidates.presses import presses_at_forces, simulate_candidates
from fem.linear.response import build_response
from fem.mesh.tetrahedra import magnet_free_mesh, tetrahedralize
from tests.support.mechanics.candidate_cases import motions_at

FACE = 3
RATE_TARGET, RATIO_TARGET, ERROR_TARGET, RANK_TARGET = 1e4, 1e3, 0.05, 0.95
_SPACING_MM = 7.0
_LINEAR = 1e-3
_CHUNK = 512
"""Layouts that are scored at once."""
_SCORES = ("worst_position_bound_mm", "median_position_bound_mm", "worst_force_bound_n")


def specification(quick: bool) -> ObjectSpec:
    """The paper's cube on a mesh somewhat coarser than the default, or a very coarse one."""
    edges = {"surface_edge_mm": 3.0, "edge_mm": 7.0} if quick else {}
    mesh = {"surface_edge_mm": 1.7, "edge_mm": 5.0, **edges}
    grid = {"count": (5, 4), "pitch_mm": 6.0} if quick else {}
    score = {"force_n": 2.0} if quick else {}
    press = {"depths_mm": (1.0, 2.0)} if quick else {}
    parts: dict[str, Any] = {"mesh": mesh, "contact_grid": grid, "score": score, "press": press}
    return ObjectSpec(name="cube", **parts)


def stored_motions(spec: ObjectSpec, folder: Path, quick: bool) -> tuple[CandidateMotions, float]:
    """Candidate motions on a magnet-free mesh, and the processor time that they took."""
    start = time.process_time()
    mesh = magnet_free_mesh(spec)
    response = build_response(mesh, spec)
    lattices = candidate_lattices(spec, pitch_mm=3.0 if quick else 2.0)
    motions = simulate_candidates(spec, mesh, response, lattices, folder)
    return motions, time.process_time() - start


def random_layouts(count: int, seed: int) -> Layouts:
    """Magnets at least 7 mm apart, depths 2 to 4 mm, tilts of 6° rms, both polarities."""
    rng, magnets = np.random.default_rng(seed), []
    while len(magnets) < count:
        xy = rng.uniform(-15, 15, (5, 2))
        if pdist(xy).min() >= _SPACING_MM:
            magnets.append(np.column_stack([xy, rng.uniform(2, 4, 5)]))
    azimuth = np.deg2rad(rng.uniform(0, 120, (count, 1)) + 120 * np.arange(3))
    radius = rng.uniform(6, 11, (count, 3, 1))
    parts = (
        np.stack(magnets),
        rng.normal(0, 0.1, (count, 5, 2)),
        rng.choice([-1.0, 1.0], (count, 5)),
        radius * np.stack([np.cos(azimuth), np.sin(azimuth)], axis=-1),
    )
    return Layouts(*(torch.as_tensor(part, dtype=torch.float32) for part in parts))


def plain_scores(
    spec: ObjectSpec, motions: CandidateMotions, layouts: Layouts, row: int, scale: float = 1.0
) -> tuple[float, float, float]:
    """One layout's scores with magpylib's exact fields of all 25 magnets at the two stored forces that
    belong to the score's."""
    steps = motions.steps_around(spec.score.force_n)
    signals = _signals(spec, motions, layouts, row, scale)[:, steps] / scale
    force = motions.force_n[FACE - 1][:, steps, None]
    per_n = (signals[:, 1] - signals[:, 0]) / (force[:, 1] - force[:, 0])
    value = signals[:, 0] + per_n * (spec.score.force_n - force[:, 0])
    value = value.reshape(*motions.places.shape, -1)
    along_x, along_y = (
        make_interp_spline(nodes, np.eye(len(nodes)), k=3)(nodes, nu=1)
        for nodes in (motions.places.x_mm, motions.places.y_mm)
    )
    by_x = np.einsum("ip,pqc->iqc", along_x, value).reshape(len(per_n), -1)
    by_y = np.einsum("jq,pqc->pjc", along_y, value).reshape(len(per_n), -1)
    sigma = disturbance_counts(spec.sensors, "fresh", by_x.shape[1])
    located = grid_places_in_lattice(spec)
    bounds = cramer_rao_bounds(np.stack([by_x, by_y, per_n], axis=-1)[located], sigma)
    position = bounds.position_mm
    return float(position.max()), float(np.median(position)), float(bounds.force_n.max())


def _signals(
    spec: ObjectSpec, motions: CandidateMotions, layouts: Layouts, row: int, scale: float
) -> np.ndarray:
    """Changes of counts (place, step, channel) of the pressed face's own sensors."""
    magnet_mm, turn, polarity, sensor_mm = (
        getattr(layouts, name)[row].double().numpy()
        for name in ("magnet_mm", "turn_rad", "polarity", "sensor_mm")
    )
    core, disk = core_frames(spec)[FACE - 1], spec.magnets
    polarization_t = magnet_source(disk).polarization_t
    depth = np.full((len(sensor_mm), 1), -spec.sensors.depth_below_core_face_mm)
    points = core.to_object(np.concatenate([sensor_mm, depth], axis=1)) / 1e3
    field = np.zeros(())
    for frame in face_frames(spec):
        motion = motions_at(motions, frame.number, magnet_mm[:, :2], magnet_mm[:, 2])[FACE - 1]
        motion = scale * motion.reshape(-1, len(magnet_mm), 6)
        motion = np.concatenate([motion, 0 * motion[:1]])  # rest is the last state
        centres = frame.to_object(magnet_mm * [1, 1, -1])
        for k, tilt in enumerate(np.rad2deg(turn)):
            still = Rotation.from_matrix(frame.axes @ tilted_frame(*tilt))
            magnet = magpylib.magnet.Cylinder(
                polarization=(0, 0, polarity[k] * polarization_t),
                dimension=(disk.diameter_mm / 1e3, disk.height_mm / 1e3),
                position=(centres[k] + motion[:, k, :3]) / 1e3,
                orientation=Rotation.from_rotvec(motion[:, k, 3:]) * still,
            )
            field = field + magnet.getB(points)
    change = 1e3 * spec.sensors.counts_per_mt * (field[:-1] - field[-1])
    boards = [core.axes @ board_frame(np.arctan2(y, x)) for x, y in sensor_mm]
    chips = np.stack([(board @ chip_on_board(spec.sensors)).T for board in boards])
    found = np.einsum("sac,psc->psa", chips, change)
    return found.reshape(len(motions.places), -1, 3 * len(sensor_mm))


def solve_seconds(spec: ObjectSpec, layouts: int) -> float:
    """Mesh with magnets, response and presses of one face: mean processor time of a layout."""
    start = time.process_time()
    for _ in range(layouts):
        response = build_response(tetrahedralize(spec), spec)
        presses_at_forces(spec, response, FACE - 1, (0.8, 1.2))
    return (time.process_time() - start) / layouts


def score_chunks(scorer: LayoutScorer, layouts: Layouts) -> None:
    """Score all layouts, in parts that fit the memory."""
    for first in range(0, len(layouts), _CHUNK):
        batch_scores([scorer], [layouts[first : first + _CHUNK]], ())


def agreement(
    spec: ObjectSpec, motions: CandidateMotions, scorer: LayoutScorer, count: int, scale: float
) -> dict[str, Any]:
    """Median relative error and rank correlation of three scores over random layouts."""
    layouts = random_layouts(count, seed=3)
    # upright, as the plain reference turns no magnet with the plane that its tilt lies in
    layouts = replace(layouts, turn_rad=0 * layouts.turn_rad)
    plain = np.array([plain_scores(spec, motions, layouts, row, scale) for row in range(count)])
    with torch.no_grad():
        score = batch_scores([scorer], [layouts], ())
    result: dict[str, Any] = {"layouts": count, "motions_scaled_by": scale}
    for name, exact in zip(_SCORES, plain.T, strict=True):
        batched = score[name].numpy()
        result[name] = {
            "median_error": float(np.median(abs(batched / exact - 1))),
            "rank_correlation": float(spearmanr(batched, exact).statistic),  # pyright: ignore[reportAttributeAccessIssue],
        }
    return result


def measure(quick: bool) -> dict[str, Any]:
    """All figures of one run."""
    spec = specification(quick)
    with tempfile.TemporaryDirectory() as folder:
        motions, candidates_s = stored_motions(spec, Path(folder), quick)
        basis_s = time.process_time()
        scorer = layout_scorer(spec, press_basis(spec, motions, FACE))
        basis_s = time.process_time() - basis_s
        layouts = random_layouts(256 if quick else 4096, seed=1)
        with torch.no_grad():
            batch_s = best_seconds(lambda: score_chunks(scorer, layouts), 1 if quick else 7)
        fields_s = best_seconds(lambda: plain_scores(spec, motions, layouts, 0), 1)
        solved = 1 if quick else 2
        solve_s, rate = solve_seconds(spec, solved), len(layouts) / batch_s
        compared = 4 if quick else 40
        alone = replace(motions, strain=0 * motions.strain)  # as the plain reference's magnets are
        scorer = layout_scorer(spec, press_basis(spec, alone, FACE))
        return {
            "places": len(contact_grid(spec)),
            "candidates_once_s": candidates_s,
            "basis_once_s": basis_s,
            "layouts": len(layouts),
            "layouts_per_s": rate,
            "layouts_per_s_target": RATE_TARGET,
            "plain_mechanics_s": solve_s,
            "plain_mechanics_layouts_timed": solved,
            "plain_fields_s": fields_s,
            "extrapolated_ratio": rate * (solve_s + fields_s),
            "extrapolated_ratio_target": RATIO_TARGET,
            "ratio_to_fields_alone": rate * fields_s,
            "error_target": ERROR_TARGET,
            "rank_target": RANK_TARGET,
            "as_pressed": agreement(spec, motions, scorer, compared, 1.0),
            "linear": agreement(spec, motions, scorer, compared, _LINEAR),
        }


def report(result: dict[str, Any]) -> str:
    """The result as lines for people."""
    found = result["figures"]
    lines = [
        f"batched: {found['layouts_per_s']:.0f} layouts/s, {found['places']} places of one face"
        f" (target {RATE_TARGET:g}); once before: motions {found['candidates_once_s']:.0f} s,"
        f" basis {found['basis_once_s']:.1f} s",
        f"plain: mechanics {found['plain_mechanics_s']:.1f} s per layout (mean of"
        f" {found['plain_mechanics_layouts_timed']}), magpylib {found['plain_fields_s']:.2f} s",
        f"ratio, extrapolated from these: {found['extrapolated_ratio']:.0f} (target"
        f" {RATIO_TARGET:g}); to the fields alone: {found['ratio_to_fields_alone']:.0f}",
    ]
    for label in ("linear", "as_pressed"):
        for name in _SCORES:
            row = found[label][name]
            lines.append(
                f"{label:10} {name:26} median error {row['median_error']:.1%}, rank correlation"
                f" {row['rank_correlation']:.3f}"
            )
    return "\n".join(lines)


def whole(quick: bool) -> dict[str, Any]:
    """Figures, and what they were measured on."""
    torch.set_num_threads(1)
    here = machine(1, ("torch", "numpy", "magpylib"))
    return {"machine": here, "quick": quick, "figures": measure(quick)}


if __name__ == "__main__":
    run(whole, report)
