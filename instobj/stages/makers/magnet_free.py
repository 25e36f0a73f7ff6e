"""Makers of the stages on the shell without magnets: compliance map, candidates, layouts of a search."""

from __future__ import annotations

from contextlib import ExitStack
from dataclasses import asdict, dataclass, field
from pathlib import Path
from shutil import rmtree
from typing import TYPE_CHECKING

from instobj.stages.makers.learning import unfinished_folder
from instobj.store.readers import (
    COMPLIANCE,
    PLAIN_FORCES,
    PLAIN_MESH,
    PLAIN_RESPONSE,
    PRESSES,
    SECOND_FIDELITY,
)
from instobj.store.stage import write_json

if TYPE_CHECKING:
    from fem.linear.factorization import Factorization
    from fem.linear.response import ElasticSystem, ResponseOperator
    from instobj.store.stage import StageContext


@dataclass
class _Shell:
    """The last shell that layouts were scored on, factored: 1 GB. Layouts of a search mostly share it."""

    folder: Path | None = None
    parts: tuple[ElasticSystem, Factorization, ResponseOperator] | None = None
    held: ExitStack = field(default_factory=ExitStack)


_shell = _Shell()


def make_plain_mesh(context: StageContext, folder: Path) -> None:
    """Tetrahedra of the sealed body without magnets."""
    from fem.mesh.quality import mesh_quality, require_quality
    from fem.mesh.tetrahedra import magnet_free_mesh, save_mesh

    context.step("tetrahedra of the sealed body as silicone throughout")
    mesh = magnet_free_mesh(context.spec)
    require_quality(mesh_quality(mesh, context.spec))
    save_mesh(mesh, PLAIN_MESH.path(folder))


def make_plain_response(context: StageContext, folder: Path) -> None:
    """Surface compliance of the shell without magnets."""
    from fem.linear.factorization import quicker_by
    from fem.linear.response import build_response, save_response

    context.step(f"assembling, factoring and condensing{quicker_by()}")
    save_response(build_response(context.read(PLAIN_MESH), context.spec), folder)


def make_plain_presses(context: StageContext, folder: Path) -> None:
    """Contact without magnets at the depth of the compliance map."""
    from fem.presses.compliance_map import presses_without_magnets
    from fem.presses.results import save_presses

    response = context.read(PLAIN_RESPONSE)
    forces = presses_without_magnets(context.spec, response, context.step)
    save_presses(forces, None, PLAIN_FORCES.path(folder))


def make_compliance(context: StageContext, folder: Path) -> None:
    """Table and maps of compliance, with magnets and without."""
    from fem.presses.compliance_map import compliance_map, save_compliance_csv
    from instobj.figures.maps.compliance import draw_compliance

    forces, _ = context.read(PRESSES)
    tied = compliance_map(forces)
    free = compliance_map(context.read(PLAIN_FORCES))
    save_compliance_csv(tied, free, COMPLIANCE.path(folder))
    context.step("maps of compliance")
    draw_compliance(context.spec, tied, folder / "maps", free)


def make_candidates(context: StageContext, folder: Path) -> None:
    """Motions of every place where a magnet could sit."""
    from fem.candidates.motions import candidate_lattices
    from fem.candidates.presses import simulate_candidates

    mesh = context.read(PLAIN_MESH)
    response = context.read(PLAIN_RESPONSE)
    lattices = candidate_lattices(context.spec)
    context.step("contact at every location, then one factorization for all presses")
    unfinished = unfinished_folder(context.key)
    simulate_candidates(
        context.spec,
        mesh,
        response,
        lattices,
        folder,
        progress=context.step,
        unfinished=unfinished,
    )
    rmtree(unfinished, ignore_errors=True)


def make_second_fidelity(context: StageContext, folder: Path) -> None:
    """Scores of a layout with rigid magnets tied to the shell without magnets."""
    from estimator.layouts.fidelity import second_fidelity_score

    context.step("rigid magnets on the shell without magnets, contact and fields in full")
    score = second_fidelity_score(context.spec, *_factored(context))
    write_json(asdict(score), SECOND_FIDELITY.path(folder))


def _factored(
    context: StageContext,
) -> tuple[ElasticSystem, Factorization, ResponseOperator]:
    from fem.linear.factorization import Factorization
    from fem.linear.response import elastic_system

    folder = context.inputs[PLAIN_RESPONSE.stage]
    if _shell.parts is None or _shell.folder != folder:
        forget_shell()
        response = context.read(PLAIN_RESPONSE)
        system = elastic_system(context.read(PLAIN_MESH), context.spec)
        factor = _shell.held.enter_context(Factorization(system.matrix))
        _shell.folder, _shell.parts = folder, (system, factor, response)
    return _shell.parts


def forget_shell() -> None:
    """Give back the memory of the last factored shell; the next layout factors one again."""
    _shell.folder = _shell.parts = None
    _shell.held.close()
