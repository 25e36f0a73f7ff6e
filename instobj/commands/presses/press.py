"""One press with large deformation next to small strain: mesh, press, table, figure and files."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import asdict
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.errors import InputError
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from instobj.commands.presses.places import Place
from instobj.figures.saving import save_figure
from instobj.store.content import StoredResult, store_root, stored
from instobj.store.progress import ProgressLine
from instobj.store.publish import object_row, publish_to, require_writable, run_folder
from instobj.store.readers import PRESS, PRESS_CURVE, PRESS_FIELDS, PRESS_MESH, PRESS_SECTION
from instobj.store.stage import Step, write_json

if TYPE_CHECKING:
    from fem.large_strain.hyperelastic import Hyperelastic
    from fem.large_strain.results import LargeStrainPress
    from fem.mesh.tetrahedra import TetMesh

MATERIALS = ("neo-hookean", "yeoh", "ogden")
_STEP_MM = 0.25
"""Depth of a step of the press, at most."""
_VERSION = 4
"""Version of the stored press; raised when its code gives another result."""
_SHAPE_OF_BODY = ("arrangement", "body", "shell", "magnets", "sensors", "mesh")


def press_specification(
    path: Path, place: Place, material_text: str, out: Path, overrides: list[str]
) -> dict[str, Any]:
    """Press one place; results go to `runs/<name>/press_<face>_<x>_<y>_<material>/`.

    Raises
    ------
    InputError
        A bad specification, an unknown face or material, wrong constants, or a tip that hangs over
        the face's border or is pressed too deep.
    """
    from fem.large_strain.single_press import require_modulus, require_press

    spec = load_spec(path, overrides, table=False)
    material = material_of(spec, material_text)
    depths, xy_mm = _depths_mm(place.depth_mm), (place.x_mm, place.y_mm)
    require_press(spec, place.face, *xy_mm, depths)
    require_modulus(spec, material)
    require_writable(out)
    mesh, press = _stored_press(spec, place.face, xy_mm, depths, material)
    folder = f"press_{place.face}_{place.x_mm:g}_{place.y_mm:g}_{material.name}"
    files = publish_to(run_folder(out, spec.name) / folder, press)
    return _document(spec, [mesh, press], files)


def material_of(spec: ObjectSpec, text: str) -> Hyperelastic:
    """Return the material `NAME[:CONSTANTS]`: neo-Hookean from the specification, others in MPa.

    Yeoh's constants are C1, C2, C3 (one to three), Ogden's are pairs μ1, α1, μ2, α2 and so on.

    Raises
    ------
    InputError
        An unknown name, or constants that do not fit it.
    """
    from fem.large_strain.hyperelastic import neo_hookean, ogden, yeoh

    name, _, constants = text.partition(":")
    values = _numbers(constants)
    if name == "neo-hookean":
        if values:
            raise InputError(
                f"neo-hookean takes its modulus from the specification; got constants {constants!r}. "
                "Leave them out, or --set silicone.youngs_modulus_mpa"
            )
        return neo_hookean(spec.silicone.youngs_modulus_mpa, spec.silicone.poisson_ratio)
    if name == "yeoh" and 1 <= len(values) <= 3:
        return yeoh(*values)
    if name == "ogden" and values and len(values) % 2 == 0:
        return ogden(tuple(values[::2]), tuple(values[1::2]))
    if name in MATERIALS:
        raise InputError(
            f"--material {text!r} does not make a {name} material. Give yeoh:C1,C2,C3 in MPa "
            "(one to three constants), or ogden:μ1,α1,μ2,α2,…"
        )
    raise InputError(f"no material is called {name!r}. Choose linear, {', '.join(MATERIALS)}")


def _numbers(text: str) -> list[float]:
    try:
        values = [float(part) for part in text.replace(",", " ").split()]
    except ValueError:
        raise InputError(
            f"constants of a material must be numbers; got {text!r}. "
            "Example: --material yeoh:0.07,-0.002,0.0001"
        ) from None
    if not all(map(math.isfinite, values)):
        raise InputError(f"constants of a material must be finite; got {text!r}. Fix them")
    return values


def _depths_mm(depth_mm: float) -> list[float]:
    """Equal steps of at most 0.25 mm down to the depth."""
    if not (math.isfinite(depth_mm) and depth_mm > 0):
        raise InputError(f"the depth must be positive; got {depth_mm:g}. Give it in mm")
    count = math.ceil(depth_mm / _STEP_MM - 1e-9)
    return [round(depth_mm * step / count, 6) for step in range(1, count + 1)]


def _stored_press(
    spec: ObjectSpec,
    face: int,
    xy_mm: tuple[float, float],
    depths_mm: list[float],
    material: Hyperelastic,
) -> tuple[StoredResult, StoredResult]:
    """The press's own mesh, then the press: found in the store, or made and kept."""
    from fem.mesh.tetrahedra import tetrahedralize_for_press

    content, progress = spec.model_dump(mode="json"), ProgressLine()
    mesh = stored_press_mesh(
        spec, face, xy_mm, lambda: tetrahedralize_for_press(spec, face, *xy_mm), progress
    )
    where, versions = _stored_keys(spec, face, xy_mm)
    how = {"silicone": content["silicone"], "mechanics": content["mechanics"]}
    how |= {"depths_mm": depths_mm, "material": asdict(material), "mesh": mesh.origin}
    with progress.stage("press with large deformation"):
        press = stored(
            store_root(),
            "press",
            where | how | versions,
            lambda folder: _make_press(
                spec, mesh.folder, face, xy_mm, depths_mm, material, folder, progress.step
            ),
            progress.say,
        )
    return mesh, press


def stored_press_mesh(
    spec: ObjectSpec,
    face: int,
    xy_mm: tuple[float, float],
    tetrahedra: Callable[[], TetMesh],
    progress: ProgressLine,
) -> StoredResult:
    """A mesh that is fine at one press: found in the store, or made and kept."""
    from fem.mesh.quality import mesh_quality, require_quality
    from fem.mesh.tetrahedra import save_mesh

    def make(folder: Path) -> None:
        progress.step("tetrahedra, fine at the press")
        mesh = tetrahedra()
        require_quality(mesh_quality(mesh, spec))
        save_mesh(mesh, PRESS_MESH.path(folder))

    content = spec.model_dump(mode="json")
    body = {name: content[name] for name in _SHAPE_OF_BODY}
    where, versions = _stored_keys(spec, face, xy_mm)
    with progress.stage("mesh of the press"):
        return stored(store_root(), "press_mesh", where | body | versions, make, progress.say)


def _stored_keys(
    spec: ObjectSpec, face: int, xy_mm: tuple[float, float]
) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return the place and indenter of a stored press, and the versions that made it."""
    indenter = spec.model_dump(mode="json")["indenter"]
    where = {"face": face, "xy_mm": xy_mm, "indenter": indenter}
    return where, {"version": _VERSION, "libraries": {"instobj": version("instobj")}}


def _make_press(
    spec: ObjectSpec,
    mesh_folder: Path,
    face: int,
    xy_mm: tuple[float, float],
    depths_mm: list[float],
    material: Hyperelastic,
    folder: Path,
    step: Step,
) -> None:
    from fem.large_strain.press import press_large_strain
    from fem.large_strain.results import save_large_strain_press
    from fem.presses.shape import save_deformed_shape
    from instobj.figures.section import draw_press_sections

    mesh = PRESS_MESH.read(mesh_folder)
    press = press_large_strain(spec, mesh, face, *xy_mm, depths_mm, material, step)
    write_json(_summary(press), PRESS.path(folder))
    save_large_strain_press(press, PRESS_FIELDS.path(folder))
    save_deformed_shape(press.shape, folder / "deformed.vtu", press.motion[-1])
    save_deformed_shape(press.linear_shape, folder / "small_strain.vtu", press.linear_motion[-1])
    draw_force_travel(press, PRESS_CURVE.path(folder))
    step("section")
    draw_press_sections(spec, press, PRESS_SECTION.path(folder))


def _summary(press: LargeStrainPress) -> dict[str, Any]:
    """Return what the command shows, as JSON."""
    from fem.large_strain.results import linearity_limits

    limits = linearity_limits(press)
    steps = []
    for index, depth in enumerate(press.depth_mm):
        linear, large = float(press.linear_force_n[index]), float(press.force_n[index])
        steps.append(
            {
                "depth mm": float(depth),
                "linear N": linear,
                "nonlinear N": large,
                "linear off %": 100 * (linear / large - 1) if large > 0 else None,
                "contact mm²": float(press.contact_area_mm2[index]),
                "magnet mm": _largest_shift_mm(press.motion[index]),
                "linear": _largest_shift_mm(press.linear_motion[index]),
            }
        )
    return {
        "face": press.face,
        "x_mm": press.x_mm,
        "y_mm": press.y_mm,
        "material": press.material.name,
        "status": press.status,
        "converged_depth_mm": press.converged_depth_mm,
        "linear_5_percent_off_at_mm": limits.five_percent_mm,
        "linear_20_percent_off_at_mm": limits.twenty_percent_mm,
        "nodes": len(press.shape.nodes_mm),
        "steps": steps,
    }


def _largest_shift_mm(motion: np.ndarray) -> float:
    return float(np.linalg.norm(motion[:, :3], axis=1).max())


def draw_force_travel(press: LargeStrainPress, path: Path) -> None:
    """Force against depth of both models (PNG)."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(5.2, 3.6), layout="constrained")
    axes = figure.subplots()
    travel = np.append(0, press.depth_mm)
    axes.plot(
        travel,
        np.append(0, press.force_n),
        "o-",
        ms=3,
        color="#c8553d",
        label=f"{press.material.name}, large deformation",
    )
    axes.plot(
        travel,
        np.append(0, press.linear_force_n),
        "s--",
        ms=3,
        color="#1b6ca8",
        label="linear, small strain",
    )
    axes.set(
        xlabel="indentation depth (mm)",
        ylabel="force (N)",
        title=f"Face {press.face}, ({press.x_mm:g}, {press.y_mm:g}) mm",
    )
    axes.grid(alpha=0.3)
    axes.set_xlim(0)
    axes.set_ylim(0)
    axes.legend(frameon=False)
    save_figure(figure, path)


def _document(spec: ObjectSpec, stages: list[StoredResult], files: list[Path]) -> dict[str, Any]:
    content = PRESS.read(stages[-1].folder)
    steps = content.pop("steps")
    return {
        "command": "press",
        "objects": [object_row(spec, stages, {"press": content, "force and travel": steps}, files)],
        "status": content["status"],
    }
