"""Makers of the stages that stand on the shell without magnets: compliance map and candidates."""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from instobj.store.stage import StageContext


def make_plain_mesh(context: StageContext, folder: Path) -> None:
    """Tetrahedra of the sealed body without magnets."""
    from fem.mesh.quality import mesh_quality, require_quality
    from fem.mesh.tetrahedra import magnet_free_mesh, save_mesh

    context.step("tetrahedra of the sealed body as silicone throughout")
    mesh = magnet_free_mesh(context.spec, context.step)
    require_quality(mesh_quality(mesh, context.spec))
    save_mesh(mesh, folder / "mesh.npz")


def make_plain_response(context: StageContext, folder: Path) -> None:
    """Surface compliance of the shell without magnets."""
    from fem.linear.response import build_response, save_response
    from fem.mesh.tetrahedra import load_mesh, without_magnets

    context.step("assembling, factoring and condensing")
    mesh = load_mesh(context.inputs["plain_mesh"] / "mesh.npz")
    save_response(build_response(mesh, without_magnets(context.spec)), folder)


def make_plain_presses(context: StageContext, folder: Path) -> None:
    """Contact without magnets at the depth of the compliance map."""
    from fem.linear.response import load_response
    from fem.presses.compliance_map import presses_without_magnets, save_forces

    response = load_response(context.inputs["plain_response"])
    forces = presses_without_magnets(context.spec, response, context.step)
    save_forces(forces, folder / "forces.npz")


def make_compliance(context: StageContext, folder: Path) -> None:
    """Table and maps of compliance, with magnets and without."""
    from fem.presses.compliance_map import compliance_map, load_forces, save_compliance_csv
    from fem.presses.results import load_presses
    from instobj.figures.compliance import draw_compliance

    forces, _ = load_presses(context.inputs["presses"] / "presses.nc")
    tied = compliance_map(forces)
    free = compliance_map(load_forces(context.inputs["plain_presses"] / "forces.npz"))
    save_compliance_csv(tied, free, folder / "compliance.csv")
    context.step("maps of compliance")
    draw_compliance(context.spec, tied, folder / "maps", free)


def make_candidates(context: StageContext, folder: Path) -> None:
    """Motions of every place where a magnet could sit."""
    from fem.candidates.motions import candidate_lattices
    from fem.candidates.presses import simulate_candidates
    from fem.linear.response import load_response
    from fem.mesh.tetrahedra import load_mesh

    mesh = load_mesh(context.inputs["plain_mesh"] / "mesh.npz")
    response = load_response(context.inputs["plain_response"])
    lattices = candidate_lattices(context.spec)
    context.step("contact at every place, then one factorization for all presses")
    motions = simulate_candidates(
        context.spec, mesh, response, lattices, folder, progress=context.step
    )
    report = json.dumps(asdict(motions.error), indent=2) + "\n"
    (folder / "interpolation_error.json").write_text(report, encoding="utf-8")
