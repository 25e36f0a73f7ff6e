"""Presses with small strain, all together: any indenter to depths or to a force, grasps."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from design.layout.places.positions import sensor_layout
from design.spec.object import ObjectSpec
from design.spec_io import load_spec, spec_hash
from instobj.commands.presses.places import CheckedPlaces, Place, check_places, lies_over_edge
from instobj.commands.presses.press import stored_press_mesh
from instobj.figures.loads import Pressed, draw_loads
from instobj.stages.run import Run
from instobj.store.progress import ProgressLine
from instobj.store.publish import object_row, require_writable, run_folder
from instobj.store.readers import MESH, PRESS_MESH, RESPONSE
from instobj.store.stage import write_json

if TYPE_CHECKING:
    from fem.presses.joint import JointPress, Tip

_CURVE_STEPS = 16
"""Shares of the load at which the curve is computed."""


def press_loads(
    path: Path,
    places: list[Place],
    force_n: float | None,
    out: Path,
    overrides: list[str],
) -> dict[str, Any]:
    """Press all places together, to their depths or each to one force.

    Places that cannot be pressed are reported under "refused"; the others are kept. Results go to
    `runs/<name>/press_<place>_linear/`.

    Raises
    ------
    InputError
        A bad specification, or no place that can be pressed.
    """
    spec = load_spec(path, overrides, table=False)
    require_no_slip(spec)
    alone = len(places) == 1
    checked = check_places(spec, places, to_depth=force_n is None, over_edges=alone)
    require_writable(out)
    run = Run(spec)
    if alone and lies_over_edge(spec, checked.good[0]):
        pressed = _press_over_edge(spec, checked.good[0], force_n)
    elif spec.indenter.friction == "sticking":
        pressed = _sticking(run, checked.good, force_n)
    else:
        if force_n is not None:
            checked = _reachable(run, checked, force_n)
        _, pressed = joint_pressed(run, [[place] for place in checked.good], force_n)
    label = _label(checked.good, (force_n, spec_hash(spec)))
    return loads_document(
        "press", run, pressed, checked.refused, run_folder(out, spec.name) / label
    )


def joint_pressed(
    run: Run, jaws: Sequence[Sequence[Place]], force_n: float | None
) -> tuple[JointPress, Pressed]:
    """Press without friction: all places to their depths, or each jaw, whose tips share a travel, to one
    force."""
    from fem.presses.joint import press_tips
    from fem.presses.to_force import press_to_force

    spec, response = run.spec, run.read(RESPONSE)

    def press(tips: Sequence[Tip], depths: np.ndarray) -> JointPress:
        return press_tips(spec, response, tips, depths)

    if force_n is None:
        places = [place for jaw in jaws for place in jaw]
        final = press([place.tip for place in places], np.array([p.depth_mm for p in places]))
    else:
        tips_of_jaws = [[place.tip for place in jaw] for jaw in jaws]
        final = press_to_force(spec, response, tips_of_jaws, force_n)
    return final, _with_the_way(final, press)


def _with_the_way(
    final: JointPress, press: Callable[[Sequence[Tip], np.ndarray], JointPress]
) -> Pressed:
    """A press with the way to it, and each of its indenters alone."""
    shares = np.arange(1, _CURVE_STEPS) / _CURVE_STEPS
    curve = [*(press(final.tips, share * final.depth_mm) for share in shares), final]
    alone = []
    if len(final.tips) > 1:
        for tip, depth in zip(final.tips, final.depth_mm, strict=True):
            alone.append(press([tip], np.array([depth])))
    return Pressed(_rows(final, alone), final.motion, curve, alone)


def loads_document(
    command: str, run: Run, pressed: Pressed, refused: Sequence[dict[str, Any]], target: Path
) -> dict[str, Any]:
    """Write `loads.json` and `loads.png` into a folder, and tell what a command prints."""

    spec = run.spec
    motions = [pressed.motion, *(press.motion for press in pressed.alone)]
    changes = signal_changes(spec, np.stack(motions))
    summary: dict[str, Any] = {"presses": pressed.rows}
    if pressed.alone:
        summary["superposition of single presses"] = superposition_row(pressed, changes)
    if core := pressed.curve[-1].core:
        summary["shell lifted off its core"] = {
            "largest opening mm": float(core.opening_mm.max()),
            "share of the core's vertices": float((core.opening_mm > 0).mean()),
        }
    summary["signal changes, counts"] = sensor_rows(spec, changes[0])
    if refused:
        summary["refused"] = list(refused)
    target.mkdir(parents=True, exist_ok=True)
    write_json({"command": command, **summary}, target / "loads.json")
    draw_loads(spec, pressed, changes[0], target / "loads.png")
    files = [target / "loads.json", target / "loads.png"]
    return {
        "command": command,
        "objects": [object_row(spec, run.results.values(), summary, files)],
        "status": "refused" if refused else "converged",
    }


def signal_changes(
    spec: ObjectSpec, motion: Float[np.ndarray, "load magnet 6"]
) -> Float[np.ndarray, "load sensor 3"]:
    """Expected changes against rest, counts, for the magnets' motions under some loads."""
    from estimator.information.jaws import signals_of_motions

    return signals_of_motions(spec, motion).delta_counts[0, 0]


def sensor_rows(spec: ObjectSpec, change: Float[np.ndarray, "sensor 3"]) -> list[dict[str, Any]]:
    """Change of every sensor's three channels, and its size in sigmas of a fresh zero."""
    sigma = np.hypot(np.asarray(spec.sensors.noise_counts), spec.sensors.zeroing_counts)
    faces = sensor_layout(spec).face.tolist()
    rows, number = [], 0
    for index, (face, counts) in enumerate(zip(faces, change, strict=True)):
        number = number + 1 if index and face == faces[index - 1] else 1
        row = {"face": face, "sensor": number}
        row |= {f"Δ{axis}": round(float(c), 1) for axis, c in zip("XYZ", counts, strict=True)}
        rows.append(row | {"σ": round(float(np.linalg.norm(counts / sigma)), 1)})
    return rows


def superposition_row(
    pressed: Pressed, changes: Float[np.ndarray, "load sensor 3"]
) -> dict[str, float]:
    """Return how far single presses to the same depths, summed, are from the joint one, in per cent.

    Force: of the total. Signals: root mean square over all channels against that of the joint
    press; the first of `changes` is the joint press.
    """
    total = float(pressed.curve[-1].force_n.sum())
    alone = sum(float(press.force_n.sum()) for press in pressed.alone)
    off = changes[1:].sum(axis=0) - changes[0]
    return {
        "force off %": 100 * (alone / total - 1),
        "signals off %": 100 * float(np.linalg.norm(off) / np.linalg.norm(changes[0])),
        "largest channel off, counts": float(abs(off).max()),
    }


def require_no_slip(spec: ObjectSpec) -> None:
    """Raise InputError for a slipped core, which these presses do not know."""
    if spec.mechanics.slip.slipped:
        raise InputError(
            "these presses know no slip of the core. Leave mechanics.slip out, or use `instobj run --to slip`"
        )


def _press_over_edge(spec: ObjectSpec, place: Place, force_n: float | None) -> Pressed:
    """One press over an edge, on a mesh that is fine there."""
    from fem.presses.over_edge import edge_mesh, edge_place, edge_presser
    from fem.presses.to_force import press_to_depths

    rolled = edge_place(spec, place.tip)
    assert rolled is not None
    where = (place.x_mm, place.y_mm)
    kept = stored_press_mesh(
        spec, place.face, where, lambda: edge_mesh(spec, rolled), ProgressLine()
    )
    step = edge_presser(spec, PRESS_MESH.read(kept.folder), rolled)
    if force_n is None:
        final = step(np.array([place.depth_mm]))
    else:
        final = press_to_depths(spec, step, [[place.tip]], force_n)
    return _with_the_way(final, lambda _, depths: step(depths))


def _sticking(run: Run, places: Sequence[Place], force_n: float | None) -> Pressed:
    from fem.presses.sticking import press_sticking, press_sticking_to_force, sticking_setting

    mesh = run.read(MESH)
    setting = sticking_setting(run.spec, mesh, [place.tip for place in places])
    if force_n is None:
        curve = press_sticking(setting, np.array([place.depth_mm for place in places]))
    else:
        curve = press_sticking_to_force(setting, force_n)
    return Pressed(_rows(curve[-1], []), curve[-1].motion, curve, [])


def _rows(press: JointPress, alone: Sequence[JointPress]) -> list[dict[str, Any]]:
    rows = []
    for index, tip in enumerate(press.tips):
        row = {
            "face": tip.face,
            "x mm": tip.x_mm,
            "y mm": tip.y_mm,
            "travel mm": float(press.depth_mm[index]),
            "N": float(press.force_n[index]),
            "shear N": float(np.hypot(*press.shear_n[index])),
            "contact mm²": float(press.contact_area_mm2[index]),
        }
        if press.centre_mm is not None:
            centre = press.centre_mm[index] + [tip.x_mm, tip.y_mm]
            row |= {"centre x mm": float(centre[0]), "centre y mm": float(centre[1])}
        if alone:
            row["alone N"] = float(alone[index].force_n[0])
        rows.append(row)
    return rows


def _reachable(run: Run, checked: CheckedPlaces, force_n: float) -> CheckedPlaces:
    """Without the places that do not reach the force by themselves."""
    from fem.presses.to_force import press_to_force

    good, refused = [], list(checked.refused)
    for place in checked.good:
        try:
            press_to_force(run.spec, run.read(RESPONSE), [[place.tip]], force_n)
        except InputError as error:
            refused.append({"press": str(place), "error": str(error)})
        else:
            good.append(place)
    if not good:
        raise InputError(refused[-1]["error"])
    return CheckedPlaces(tuple(good), tuple(refused))


def _label(places: Sequence[Place], how: tuple[Any, ...]) -> str:
    if len(places) == 1:
        return f"press_{places[0].face}_{places[0].x_mm:g}_{places[0].y_mm:g}_linear"
    return f"presses_{hashlib.sha256(repr((places, how)).encode()).hexdigest()[:8]}_linear"
