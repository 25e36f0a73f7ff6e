"""Proofs on the object itself: balance, reciprocity, the shell's compliance, mirrored presses."""

from functools import cache

import numpy as np
import scipy.sparse as sp

from design.layout.places.contact_grid import press_lattice
from design.layout.places.positions import shell_body_layout
from fem.linear import response
from fem.linear.response import build_response, elastic_system, face_pressure_loads
from fem.presses import table as presses
from fem.presses.table import press_face
from tests.support.mechanics.fem_cases import (
    SHELL_COMPLIANCE_MM_PER_N,
    all_silicone,
    paper_cube,
    patch_compliances,
    relative_mirror_difference,
    solve_loads,
    with_poisson_ratio,
)
from tests.support.objects.small_object import small_mesh, small_spec
from tests.support.shared import shared_mesh, shared_response
from tests.support.verification.proof import Check, Curve, Fault, Measured

EDGES_MM = 1.7, 5.0
"""At the faces and inside."""
_EDGES = "edges of {:g} mm at the faces and {:g} mm inside".format(*EDGES_MM)
MOST_NODES = 55_000
LOADS = (7, 23, 41)


@cache
def cube_mesh():
    return shared_mesh(paper_cube(EDGES_MM))


@cache
def cube_system():
    return elastic_system(all_silicone(cube_mesh()), paper_cube(EDGES_MM))


@cache
def cube_response():
    return shared_response(cube_mesh(), paper_cube(EDGES_MM))


@cache
def other_cube_response():
    """The same cube on another mesh of nearly the same edges."""
    spec = paper_cube(tuple(1.01 * edge for edge in EDGES_MM))
    return shared_response(shared_mesh(spec), spec)


def force_balance():
    """Resultant of the core's reactions and of the pressure at one vertex of every face."""
    spec, mesh = small_spec(), small_mesh()
    system = elastic_system(mesh, spec)
    nodes = system.space.nodes_mm
    surfaces, tractions = face_pressure_loads(system.space, spec)
    first = np.cumsum([0] + [len(surface.xy_mm) for surface in surfaces[:-1]])
    forces = tractions[:, first + LOADS[0]].toarray()
    solution = solve_loads(system, forces)
    motions = system.motion_basis.shape[1]
    inner = system.operators.stiffness @ (system.motion_basis @ solution[:motions])
    pressed = system.space.pressure_nodes
    inner += system.operators.divergence[pressed].T @ solution[motions:]
    core = (abs(nodes) < 13.1).all(axis=1)
    off = []
    for face in range(5):
        applied, reaction = (x[:, face].reshape(3, -1).T for x in (forces, inner))
        reaction = (reaction - applied) * core[:, None]
        size = np.linalg.norm(applied.sum(axis=0))
        moment = np.cross(nodes, applied + reaction).sum(axis=0)
        off.append(
            [
                np.linalg.norm((applied + reaction).sum(axis=0)) / size,
                np.linalg.norm(moment) / (21 * size),
            ]
        )
    force, moment = np.array(off).T
    faces = np.arange(1, 6)
    words = "Cube with two tilted rigid magnets per face, pressed at one vertex of every face, one at a time."
    curves = (Curve("force", faces, force), Curve("moment over 21 mm", faces, moment))
    return Measured(float(max(force.max(), moment.max())), words, curves)


def reciprocity():
    """Magnets' motions by the response operator against direct solutions of the same loads."""
    spec, mesh = small_spec(), small_mesh()
    system, operator = elastic_system(mesh, spec), build_response(mesh, spec)
    tractions = face_pressure_loads(system.space, spec)[1]
    count = 6 * len(shell_body_layout(spec).face)
    motions = system.motion_basis.shape[1]
    curves = []
    for load in LOADS:
        direct = solve_loads(system, tractions[:, [load]].toarray())[motions - count : motions, 0]
        found = operator.compliance[operator.magnet_loads, load]
        error = abs(found - direct) / abs(direct).max()
        curves.append(Curve(f"pressure at vertex {load}", np.arange(count), error))
    worst = max(curve.measured.max() for curve in curves)
    words = "Shifts and turns of ten tilted rigid magnets under pressures at three vertices."
    return Measured(float(worst), words, tuple(curves))


def shell_compliance():
    """Compliance of the patch load at the five faces' centres."""
    system, spec = cube_system(), paper_cube(EDGES_MM)
    nodes = int(system.space.elastic_nodes.sum())
    if nodes > MOST_NODES:
        raise ValueError(f"the mesh has {nodes} nodes, more than {MOST_NODES}")
    compliance, _ = patch_compliances(system, spec)
    exact = np.full(5, SHELL_COMPLIANCE_MM_PER_N[0.4999])
    words = f"{_EDGES.capitalize()}, {nodes} nodes, no magnets, ν 0.4999."
    curve = Curve("patch load at the face's centre", np.arange(1, 6), compliance, exact)
    return Measured(float(abs(compliance / exact - 1).max()), words, (curve,))


def mirrored_presses():
    """Force of each press of face 1 against that of its mirror image under x → −x.

    As a multiple of what another mesh of the same object changes: the mesh's own error.
    """
    spec = paper_cube(EDGES_MM)
    depths, xy = np.asarray(spec.press.depths_mm), press_lattice(spec).xy_mm
    force, other = (
        press_face(spec, given, 0, xy, depths).force_n
        for given in (cube_response(), other_cube_response())
    )
    off = relative_mirror_difference(force, spec)
    own = np.sqrt(np.mean((2 * (force - other) / (force + other)) ** 2, axis=0))
    words = (
        f"Face 1, 441 places, rigid magnets, {_EDGES}. The mesh's own error, {100 * own.min():.1f} to "
        f"{100 * own.max():.1f} % rms, is what a mesh of edges 1 % longer changes."
    )
    curve = Curve("rms difference of mirrored forces", depths, off / own)
    return Measured(float((off / own).max()), words, (curve,))


def _turned_backwards(patch):
    """u_x = c_x − ω_y r_z − ω_z r_y in the tie."""
    right = response.rigid_motion_basis

    def backwards(nodes_mm, free, owner, centres_mm):
        basis = right(nodes_mm, free, owner, centres_mm).tocoo()
        motion = basis.col - (basis.shape[1] - 6 * len(centres_mm))
        wrong = (basis.row < len(nodes_mm)) & (motion >= 0) & (motion % 6 == 4)
        return sp.csr_matrix(
            (np.where(wrong, -1, 1) * basis.data, (basis.row, basis.col)), basis.shape
        )

    patch.setattr(response, "rigid_motion_basis", backwards)


def _columns_reversed(patch):
    right = response.last_columns
    patch.setattr(response, "last_columns", lambda size, count: right(size, count)[:, ::-1])


def _softer_poisson(patch):
    soft = with_poisson_ratio(cube_system(), 0.4999, 0.49)
    patch.setitem(globals(), "cube_system", lambda: soft)


def _tip_beside(patch):
    right = presses.moved
    patch.setattr(presses, "moved", lambda p, by: right(p, np.add(by, [0.7, 0.0])))


CHECKS = (
    Check(
        "force_balance",
        "The core's reactions balance the pressure, in force and moment",
        "zero, to rounding",
        1e-10,
        force_balance,
        Fault("one component of a magnet's rotation with the wrong sign", _turned_backwards),
        "errors",
        ("face pressed", "resultant over the applied force"),
    ),
    Check(
        "reciprocity",
        "The response operator moves magnets as a direct solution does",
        "direct solutions of the same loads (adjoint = direct)",
        1e-12,
        reciprocity,
        Fault("magnets' motions in reverse order", _columns_reversed),
        "errors",
        ("motion: 6 for every magnet", "difference over the largest motion"),
    ),
    Check(
        "shell_compliance",
        "Compliance of the paper's shell",
        "0.22621 mm/N, a converged Taylor–Hood solution",
        0.01,
        shell_compliance,
        Fault("Poisson's ratio 0.49 in place of 0.4999", _softer_poisson),
        "values",
        ("face", "compliance, mm/N"),
    ),
    Check(
        "mirror_symmetry",
        "Mirrored presses of a symmetric object agree",
        "the mirrored press, in multiples of the mesh's own error",
        1.5,
        mirrored_presses,
        Fault("tip 0.7 mm beside its place", _tip_beside),
        "errors",
        ("depth, mm", "difference over the mesh's own error"),
    ),
)
