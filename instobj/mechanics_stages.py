"""Makers of the stages from solids to presses. Heavy imports stay inside."""

from __future__ import annotations

from pathlib import Path

from instobj.deformation_stages import correct_table
from instobj.stage import StageContext, write_json


def make_build(context: StageContext, folder: Path) -> None:
    """Solids, mould and probes, with a picture."""
    from design.export import build_object
    from instobj.report.parts_figure import draw_parts

    build_object(context.spec, folder, context.step)
    context.step("drawing the parts")
    draw_parts(folder, folder / "parts.png")


def make_mesh(context: StageContext, folder: Path) -> None:
    """Tetrahedra of the sealed body and their quality."""
    from fem.mesh_quality import mesh_quality, require_quality
    from fem.tet_mesh import save_mesh, tetrahedralize

    context.step("tetrahedra of the sealed body, magnets resolved")
    mesh = tetrahedralize(context.spec)
    quality = mesh_quality(mesh, context.spec)
    require_quality(quality)
    save_mesh(mesh, folder / "mesh.npz")
    write_json(quality.to_dict(), folder / "mesh_quality.json")


def make_response(context: StageContext, folder: Path) -> None:
    """The response operator."""
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


def make_coarse_response(context: StageContext, folder: Path) -> None:
    """The response operator on a mesh with edges 1.5 times as long."""
    from fem.discretisation import coarser
    from fem.response import build_response, save_response
    from fem.tet_mesh import tetrahedralize

    context.step("a mesh with edges 1.5 times as long")
    spec = coarser(context.spec)
    mesh = tetrahedralize(spec)
    context.step("assembling, factoring and condensing")
    save_response(build_response(mesh, spec), folder)


def make_discretisation(context: StageContext, folder: Path) -> None:
    """Error of the table of presses, from both meshes."""
    from fem.discretisation import discretisation_error
    from fem.response import load_response

    context.step("the same presses on both meshes")
    responses = (load_response(context.inputs[name]) for name in ("response", "coarse_response"))
    write_json(
        discretisation_error(context.spec, *responses).to_dict(), folder / "discretisation.json"
    )


def make_presses(context: StageContext, folder: Path) -> None:
    """Every press of the table: forces and motions, at rest and pressed."""
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


def make_shear(context: StageContext, folder: Path) -> None:
    """Motions under tangential forces of the tip."""
    from fem.response import load_response
    from fem.shear import motions_under_traction, save_shear, simulate_shear
    from fem.tet_mesh import load_mesh

    context.step("magnet motions under tractions on every face")
    mesh = load_mesh(context.inputs["mesh"] / "mesh.npz")
    per_traction = motions_under_traction(mesh, context.spec)
    context.step("tangential forces at every place and depth")
    response = load_response(context.inputs["response"])
    save_shear(simulate_shear(context.spec, response, per_traction), folder / "shear.nc")
