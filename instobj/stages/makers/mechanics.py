"""Makers of the stages from solids to presses. Heavy imports stay inside."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path

from instobj.stages.makers.deformation import correct_table
from instobj.store.readers import (
    CORE_TENSION,
    DISCRETISATION,
    MESH,
    MESH_QUALITY,
    PARTS_PICTURE,
    PRESSES,
    RESPONSE,
    RESPONSE_SIZE,
    SHEAR,
)
from instobj.store.stage import StageContext, write_json


def make_build(context: StageContext, folder: Path) -> None:
    """Solids, mould and probes, with a picture."""
    from design.build.export import build_object
    from instobj.render.parts import draw_parts

    build_object(context.spec, folder, context.step)
    context.step("drawing the parts")
    draw_parts(folder, PARTS_PICTURE.path(folder))


def make_mesh(context: StageContext, folder: Path) -> None:
    """Tetrahedra of the sealed body and their quality."""
    from fem.mesh.quality import mesh_quality, require_quality
    from fem.mesh.tetrahedra import mesh_sha256, save_mesh, tetrahedralize

    context.step("tetrahedra of the sealed body, magnets resolved")
    mesh = tetrahedralize(context.spec)
    quality = mesh_quality(mesh, context.spec)
    require_quality(quality)
    save_mesh(mesh, MESH.path(folder))
    content = {**asdict(quality), "mesh_sha256": mesh_sha256(mesh)}
    write_json(content, MESH_QUALITY.path(folder))


def make_response(context: StageContext, folder: Path) -> None:
    """The response operator."""
    from fem.linear.factorization import quicker_by
    from fem.linear.response import build_and_keep_factor, build_response, save_response

    context.step(f"assembling, factoring and condensing{quicker_by()}")
    given = context.read(MESH), context.spec
    if "shapes" in context.call.asks_for:
        response, context.call.factored = build_and_keep_factor(*given)
    else:
        response = build_response(*given)
    save_response(response, folder)
    write_json(
        {
            "unknowns": response.unknowns,
            "condensed_unknowns": len(response.compliance),
            "negative_pivots": response.negative_pivots,
        },
        RESPONSE_SIZE.path(folder),
    )


def make_coarse_response(context: StageContext, folder: Path) -> None:
    """The response operator on a mesh with edges 1.5 times as long."""
    from fem.linear.factorization import quicker_by
    from fem.linear.response import build_response, save_response
    from fem.mesh.tetrahedra import tetrahedralize
    from fem.presses.discretisation import coarser

    context.step("a mesh with edges 1.5 times as long")
    spec = coarser(context.spec)
    mesh = tetrahedralize(spec)
    context.step(f"assembling, factoring and condensing{quicker_by()}")
    save_response(build_response(mesh, spec), folder)


def make_discretisation(context: StageContext, folder: Path) -> None:
    """Error of the table of presses, from both meshes."""
    from fem.linear.response import load_response
    from fem.presses.discretisation import discretisation_error

    context.step("the same presses on both meshes")
    responses = (load_response(context.inputs[name]) for name in ("response", "coarse_response"))
    write_json(asdict(discretisation_error(context.spec, *responses)), DISCRETISATION.path(folder))


def make_presses(context: StageContext, folder: Path) -> None:
    """Every press of the table: forces and motions, at rest and pressed."""
    from fem.linear.core_slip import resting_shell
    from fem.presses.core_tension import core_tension
    from fem.presses.results import save_presses
    from fem.presses.table import simulate_lattice

    response, rest = context.read(RESPONSE), None
    slip = context.spec.mechanics.slip
    if slip.slipped:
        context.step("the shell at rest on its slipped core")
        rest = resting_shell(context.read(MESH), context.spec)
    forces, motions = simulate_lattice(context.spec, response, context.step, rest)
    forces, motions = correct_table(context.spec, forces, motions, context.inputs["large_strain"])
    save_presses(forces, motions, PRESSES.path(folder))
    if response.core is not None:
        context.step("where the shell would lift off its core")
        tension = core_tension(context.spec, response)
        write_json(tension.to_dict(), CORE_TENSION.path(folder))


def make_shear(context: StageContext, folder: Path) -> None:
    """Motions under tangential forces of the tip."""
    from fem.presses.shear import motions_under_traction, save_shear, simulate_shear

    context.step("magnet motions under tractions on every face")
    mesh = context.read(MESH)
    per_traction = motions_under_traction(mesh, context.spec)
    context.step("tangential forces at every location and depth")
    response = context.read(RESPONSE)
    save_shear(simulate_shear(context.spec, response, per_traction), SHEAR.path(folder))
