"""The stages of the chain: what each needs, which parts of the specification it depends on, and
how it makes its files. Heavy imports stay inside the functions."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from design.files import atomic_path
from design.spec import ObjectSpec
from instobj.deformation_stages import correct_table, make_large_strain, make_shapes
from instobj.magnet_free_stages import (
    make_candidates,
    make_compliance,
    make_plain_mesh,
    make_plain_presses,
    make_plain_response,
)

Step = Callable[[str], None]


@dataclass(frozen=True)
class StageContext:
    """What a stage works from: the specification and the folders of the stages it needs."""

    spec: ObjectSpec
    inputs: dict[str, Path]
    key: str
    step: Step


@dataclass(frozen=True)
class Stage:
    """A stage of the chain.

    `depends_on` names parts of the specification (dotted where only one field matters), or
    "shell_bodies", what is cast into the silicone, which follows from several of them (or
    "shell_body_outline", the cross-section of one such body); `version` is raised when the code
    would give another result from the same inputs.
    """

    title: str
    needs: tuple[str, ...]
    depends_on: tuple[str, ...]
    make: Callable[[StageContext, Path], None]
    version: int = 1


def _build(context: StageContext, folder: Path) -> None:
    from design.export import build_object
    from instobj.report.parts_figure import draw_parts

    build_object(context.spec, folder, context.step)
    context.step("drawing the parts")
    draw_parts(folder, folder / "parts.png")


def _mesh(context: StageContext, folder: Path) -> None:
    from fem.mesh_quality import mesh_quality, require_quality
    from fem.tet_mesh import save_mesh, tetrahedralize

    context.step("tetrahedra of the sealed body, magnets resolved")
    mesh = tetrahedralize(context.spec)
    quality = mesh_quality(mesh, context.spec)
    require_quality(quality)
    save_mesh(mesh, folder / "mesh.npz")
    write_json(quality.to_dict(), folder / "mesh_quality.json")


def _response(context: StageContext, folder: Path) -> None:
    from fem.response import LOCKING_WARNING, build_response, save_response
    from fem.tet_mesh import load_mesh

    if context.spec.mechanics.element == "p1":
        context.step(LOCKING_WARNING)
    context.step("assembling, factoring and condensing")
    response = build_response(load_mesh(context.inputs["mesh"] / "mesh.npz"), context.spec)
    save_response(response, folder)
    write_json(
        {
            "unknowns": response.unknowns,
            "condensed_unknowns": len(response.compliance),
            "negative_pivots": response.negative_pivots,
        },
        folder / "response.json",
    )


def _coarse_response(context: StageContext, folder: Path) -> None:
    from fem.discretisation import coarser
    from fem.response import build_response, save_response
    from fem.tet_mesh import tetrahedralize

    context.step("a mesh with edges 1.5 times as long")
    spec = coarser(context.spec)
    mesh = tetrahedralize(spec)
    context.step("assembling, factoring and condensing")
    save_response(build_response(mesh, spec), folder)


def _discretisation(context: StageContext, folder: Path) -> None:
    from fem.discretisation import discretisation_error
    from fem.response import load_response

    context.step("the same presses on both meshes")
    responses = (load_response(context.inputs[name]) for name in ("response", "coarse_response"))
    write_json(
        discretisation_error(context.spec, *responses).to_dict(), folder / "discretisation.json"
    )


def _presses(context: StageContext, folder: Path) -> None:
    from fem.core_slip import resting_shell
    from fem.core_tension import core_tension
    from fem.presses import simulate_lattice
    from fem.response import load_response
    from fem.results import save_presses
    from fem.tet_mesh import load_mesh

    response, rest = load_response(context.inputs["response"]), None
    slip = context.spec.mechanics.slip
    if slip.slipped and slip.model == "fem":
        context.step("the shell at rest on its slipped core")
        rest = resting_shell(load_mesh(context.inputs["mesh"] / "mesh.npz"), context.spec)
    forces, motions = simulate_lattice(context.spec, response, context.step, rest)
    forces, motions = correct_table(context.spec, forces, motions, context.inputs["large_strain"])
    save_presses(forces, motions, folder / "presses.nc")
    if response.core is not None:
        context.step("where the shell would lift off its core")
        tension = core_tension(context.spec, response)
        write_json(tension.to_dict(), folder / "core_tension.json")


def _signals(context: StageContext, folder: Path) -> None:
    from estimator.signals import press_signals, save_grid_signals, save_signals
    from fem.results import load_presses

    forces, motions = load_presses(context.inputs["presses"] / "presses.nc")
    signals = press_signals(context.spec, forces, motions, context.step)
    save_signals(signals, folder / "lattice_signals.nc")
    save_grid_signals(context.spec, signals, folder / "signals.nc", context.spec.seed)


def _scores(context: StageContext, folder: Path) -> None:
    from estimator.cross_face import RELATIONS, cross_face_disturbance
    from estimator.scores import save_scores_csv, score_places
    from instobj.report.maps import draw_cross_face_map, draw_score_maps

    context.step("sensitivity and bounds of every place")
    signals = _stored_signals(context)
    scores = score_places(context.spec, signals, context.step)
    save_scores_csv(scores, folder / "scores.csv")
    draw_score_maps(context.spec, scores, folder / "maps", context.step)
    context.step("presses on other faces")
    cross = cross_face_disturbance(context.spec, signals)
    summaries = {relation: cross.summary(relation) for relation in RELATIONS}
    write_json({"force_n": cross.force_n} | summaries, folder / "cross_face.json")
    draw_cross_face_map(context.spec, cross, folder / "maps")


def _shear(context: StageContext, folder: Path) -> None:
    from fem.response import load_response
    from fem.shear import motions_under_traction, save_shear, simulate_shear
    from fem.tet_mesh import load_mesh

    context.step("magnet motions under tractions on every face")
    mesh = load_mesh(context.inputs["mesh"] / "mesh.npz")
    per_traction = motions_under_traction(mesh, context.spec)
    context.step("tangential forces at every place and depth")
    response = load_response(context.inputs["response"])
    save_shear(simulate_shear(context.spec, response, per_traction), folder / "shear.nc")


def _shear_scores(context: StageContext, folder: Path) -> None:
    from estimator.shear import save_shear_scores_csv, score_shear, shear_signals
    from fem.results import load_presses
    from fem.shear import load_shear
    from instobj.report.maps import draw_shear_maps

    _, motions = load_presses(context.inputs["presses"] / "presses.nc")
    shear = load_shear(context.inputs["shear"] / "shear.nc")
    slopes = shear_signals(context.spec, motions, shear)
    scores = score_shear(context.spec, _stored_signals(context), slopes)
    save_shear_scores_csv(scores, folder / "shear_scores.csv")
    draw_shear_maps(context.spec, scores, folder / "maps")


def _identify(context: StageContext, folder: Path) -> None:
    from estimator.identifiability import identifiability, save_identifiability_csv
    from fem.results import load_presses
    from instobj.report.information_figures import draw_blindest, draw_identifiability

    forces, motions = load_presses(context.inputs["presses"] / "presses.nc")
    rows = identifiability(context.spec, forces, motions, progress=context.step)
    save_identifiability_csv(rows, folder / "identifiability.csv")
    draw_identifiability(context.spec, rows, folder / "identifiability.png")
    draw_blindest(context.spec, rows, folder / "blindest_contacts.png")


def _robustness(context: StageContext, folder: Path) -> None:
    from estimator.robustness import save_robustness
    from estimator.tolerances import robustness
    from fem.results import load_presses
    from instobj.report.robustness_figure import draw_robustness

    presses = load_presses(context.inputs["presses"] / "presses.nc")
    budget = robustness(context.spec, *presses, context.step)
    save_robustness(budget, folder / "robustness.json")
    draw_robustness(context.spec, budget, folder / "robustness.png")


def _frames(context: StageContext, folder: Path) -> None:
    from estimator.dataset import save_frames
    from estimator.press_protocol import nominal_peaks, plan_presses, simulate_presses

    signals = _stored_signals(context)
    frames = simulate_presses(context.spec, signals, context.key, context.step)
    peaks = nominal_peaks(context.spec, signals)
    write_json(
        plan_presses(context.spec, signals).summary()
        | {
            "common_travel_mm": peaks.common_travel_mm,
            "deepest_peak_mm": float(peaks.depth_mm.max()),
            "shallowest_peak_mm": float(peaks.depth_mm.min()),
            "clamped_places": int(peaks.clamped.sum()),
        },
        folder / "protocol.json",
    )
    save_frames(frames, folder / "frames.nc")


def _networks(context: StageContext, folder: Path) -> None:
    from instobj.learning import train_networks

    frames = context.inputs["frames"] / "frames.nc"
    train_networks(frames, context.spec.training, context.spec.seed, folder, context.step)


def _metrics(context: StageContext, folder: Path) -> None:
    from instobj.learning import evaluate_networks

    frames = context.inputs["frames"] / "frames.nc"
    evaluate_networks(frames, context.inputs["networks"], context.spec.seed, folder, context.step)


def _stored_signals(context: StageContext) -> Any:
    from estimator.signals import load_signals

    return load_signals(context.inputs["signals"] / "lattice_signals.nc")


def _report(context: StageContext, folder: Path) -> None:
    from instobj.report.page import write_report

    context.step("writing the report")
    write_report(context.spec, context.inputs, folder / "report.html", context.step)


def write_json(content: dict[str, Any], path: Path) -> None:
    """Write JSON that is complete or absent."""
    with atomic_path(path) as temporary:
        temporary.write_text(json.dumps(content, indent=2) + "\n", encoding="utf-8")


_WHERE_THINGS_ARE = ("body", "shell", "magnets", "arrangement")
_WHAT_IS_MESHED = ("body", "shell.thickness_mm", "shell_bodies", "mesh")
_ELASTIC = (
    "silicone.youngs_modulus_mpa",
    "silicone.poisson_ratio",
    "mechanics.element",
    "mechanics.magnets",
    "mechanics.interface",
    "mechanics.slip.rim",
)
_ELASTIC_WITHOUT_MAGNETS = tuple(name for name in _ELASTIC if name != "mechanics.magnets")

STAGES: dict[str, Stage] = {
    "build": Stage(
        "design: solids, mould and probes",
        (),
        ("name", *_WHERE_THINGS_ARE, "core", "sensors", "indenter"),
        _build,
    ),
    "mesh": Stage("mesh: tetrahedra", (), _WHAT_IS_MESHED, _mesh),
    "response": Stage("mechanics: response operator", ("mesh",), _ELASTIC, _response),
    "large_strain": Stage(
        "mechanics: presses with large deformation",
        (),
        (
            *_WHAT_IS_MESHED,
            *_ELASTIC,
            "magnets.positions_mm",
            "contact_grid",
            "indenter",
            "press",
            "mechanics.correction",
        ),
        make_large_strain,
    ),
    "shapes": Stage(
        "mechanics: shapes of presses",
        ("mesh", "response"),
        ("contact_grid", "indenter", "press"),
        make_shapes,
    ),
    "presses": Stage(
        "mechanics: contact at every place and depth",
        ("mesh", "response", "large_strain"),
        ("contact_grid", "indenter", "press", "mechanics.slip"),
        _presses,
        version=2,
    ),
    "plain_mesh": Stage(
        "mesh: without magnets", (), ("body", "shell.thickness_mm", "mesh"), make_plain_mesh
    ),
    "plain_response": Stage(
        "mechanics: response without magnets",
        ("plain_mesh",),
        _ELASTIC_WITHOUT_MAGNETS,
        make_plain_response,
    ),
    "plain_presses": Stage(
        "mechanics: contact without magnets",
        ("plain_response",),
        ("contact_grid", "indenter", "press"),
        make_plain_presses,
        version=2,
    ),
    "compliance": Stage(
        "mechanics: compliance map",
        ("presses", "plain_presses"),
        ("magnets", "sensors", "arrangement"),
        make_compliance,
    ),
    "candidates": Stage(
        "mechanics: motions of candidate magnets",
        ("plain_mesh", "plain_response"),
        (
            "contact_grid",
            "indenter",
            "press",
            "score.force_n",
            "shell.pocket_diameter_mm",
            "shell_body_outline",
        ),
        make_candidates,
    ),
    "coarse_response": Stage(
        "mechanics: response on a coarser mesh", (), (*_WHAT_IS_MESHED, *_ELASTIC), _coarse_response
    ),
    "discretisation": Stage(
        "mechanics: discretisation error",
        ("response", "coarse_response"),
        ("contact_grid", "indenter", "press"),
        _discretisation,
    ),
    "signals": Stage(
        "signals: Hall sensors",
        ("presses",),
        ("magnets", "sensors", "arrangement", "environment", "as_built", "seed"),
        _signals,
        version=2,
    ),
    "scores": Stage(
        "sensitivity: bounds and maps", ("signals",), ("score", "seed"), _scores, version=4
    ),
    "shear": Stage(
        "mechanics: tangential forces",
        ("mesh", "response"),
        ("contact_grid", "indenter", "press", "mechanics.slip"),
        _shear,
    ),
    "shear_scores": Stage(
        "sensitivity: with tangential forces",
        ("presses", "signals", "shear"),
        ("score",),
        _shear_scores,
    ),
    "identify": Stage(
        "sensitivity: several contacts at once",
        ("presses", "signals"),
        ("score", "limits.position_bound_mm"),
        _identify,
    ),
    "robustness": Stage(
        "robustness: tolerances",
        ("presses",),
        (
            *("magnets", "sensors", "arrangement", "environment", "as_built"),
            *("score.force_n", "score.channels", "tolerances", "seed"),
        ),
        _robustness,
    ),
    "frames": Stage(
        "estimator: simulated presses",
        ("signals",),
        ("protocol", "silicone.prony", "seed"),
        _frames,
        version=3,
    ),
    "networks": Stage(
        "estimator: training", ("frames",), ("training", "seed"), _networks, version=2
    ),
    "metrics": Stage("estimator: held-out presses", ("frames", "networks"), (), _metrics),
    "report": Stage(
        "report",
        (
            "build",
            "mesh",
            "response",
            "presses",
            "large_strain",
            "shapes",
            "discretisation",
            "signals",
            "scores",
            "frames",
            "robustness",
            "metrics",
        ),
        ("name", "limits", "silicone"),
        _report,
        version=7,
    ),
}
"""In the order in which a command works through those that it needs."""


def _shell_bodies(spec: ObjectSpec) -> dict[str, Any]:
    """Place and outline of what is cast into the silicone: all that mechanics knows of it."""
    from design.layouts import shell_body_layout

    layout = shell_body_layout(spec)
    return {
        "centre_mm": layout.centre_mm.tolist(),
        "frame": layout.frame.tolist(),
        "outline": asdict(layout.outline),
        "height_mm": layout.height_mm,
    }


def stage_inputs(
    stage: Stage, spec: ObjectSpec, keys_of_needs: dict[str, str], versions: dict[str, str]
) -> dict[str, Any]:
    """Everything that a stage's result depends on, JSON-able, for its content key."""
    bodies = _shell_bodies(spec)
    content = spec.model_dump(mode="json") | {
        "shell_bodies": bodies,
        "shell_body_outline": bodies["outline"],
    }
    parts: dict[str, Any] = {}
    for name in stage.depends_on:
        value: Any = content
        for part in name.split("."):
            value = value[part]
        parts[name] = value
    return {
        "spec": parts,
        "needs": keys_of_needs,
        "version": stage.version,
        "libraries": versions,
    }
