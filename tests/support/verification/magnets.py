"""Proof of magnets tied to a mesh that does not know them, against a mesh that resolves them."""

from functools import cache

import numpy as np

from design.layout.places.positions import shell_body_layout
from design.spec.object import MagnetSpec
from fem.candidates import tied_magnets
from fem.linear.response import elastic_system, face_pressure_loads
from fem.mesh.tetrahedra import tetrahedralize
from fem.presses.table import surface_weights_mm2
from tests.support.mechanics.fem_cases import paper_cube, solve_loads
from tests.support.verification.proof import Check, Curve, Fault, Measured

MAGNET_MM = (3.0, 2.0)
TIED_EDGES_MM = 0.99, 1.0, 1.01
PLACES_MM = np.array([[3.0, 2.0], [0.0, 0.0], [6.0, -1.0], [7.0, 4.0]])


def cube():
    spec = paper_cube((1.2, 4.0))
    return spec.model_copy(update={"magnets": MagnetSpec(positions_mm=(MAGNET_MM,))})


def fine_at_the_magnet(edge_mm):
    """Edges of `edge_mm` at the magnet of face 1, growing to 7 mm."""

    def edge_length(points_mm):
        distance = np.linalg.norm(points_mm - [*MAGNET_MM, 18.5], axis=1)
        return np.interp(distance, [4.2, 12, 26], [edge_mm, 1.3, 7.0])

    return edge_length


def patch_loads(system, spec):
    """1 N spread as (1 − r²/25)² about each place of face 1; (3·node, place)."""
    surfaces, tractions = face_pressure_loads(system.space, spec)
    face = surfaces[0]
    distance = np.linalg.norm(face.xy_mm - PLACES_MM[:, None], axis=2)
    pressure = np.clip(1 - distance**2 / 25, 0, None) ** 2
    pressure /= (pressure @ surface_weights_mm2(face))[:, None]
    return tractions[:, : len(face.xy_mm)] @ pressure.T


@cache
def resolved():
    """Compliance (mm/N) of every patch, and face 1's magnet per newton (6, place)."""
    spec = cube()
    system = elastic_system(tetrahedralize(spec, fine_at_the_magnet(0.5)), spec)
    loads = patch_loads(system, spec)
    motions = system.motion_basis.shape[1]
    solved = solve_loads(system, loads)[:motions]
    magnets = solved[-6 * len(shell_body_layout(spec).face) :]
    return np.einsum("ij,ij->j", system.motion_basis.T @ loads, solved), magnets[:6]


@cache
def magnet_free():
    """On three meshes: what one differs by is as large as what ties cost."""
    spec = cube()
    meshes = (
        tetrahedralize(spec, fine_at_the_magnet(edge), magnets=False) for edge in TIED_EDGES_MM
    )
    return [elastic_system(mesh, spec) for mesh in meshes]


def tied():
    """The same of tied magnets, means over the meshes."""
    found, moved = zip(*map(tied_on, magnet_free()), strict=True)
    return np.mean(found, axis=0), np.mean(moved, axis=0)


def tied_on(system):
    """On one mesh, from direct solutions of patches and functionals together."""
    spec = cube()
    loads = patch_loads(system, spec)
    functionals, rigid = tied_magnets.tie_functionals(spec, system.space, tied_magnets.DEGREE)
    both = np.hstack([loads, functionals.T.toarray()])
    moved = system.motion_basis @ solve_loads(system, both)[: system.motion_basis.shape[1]]
    places = loads.shape[1]
    inverse = np.linalg.inv(functionals @ moved[:, places:])
    meant = functionals @ moved[:, :places]
    motion = np.linalg.solve(rigid.T @ inverse @ rigid, rigid.T @ inverse @ meant)
    tractions = inverse @ (rigid @ motion - meant)
    compliance = np.einsum("ij,ij->j", loads, moved[:, :places])
    return compliance + np.einsum("ij,ij->j", meant, tractions), motion[:6]


def tied_against_resolved():
    """Compliance, displacement and rotation of tied magnets, as shares of the largest resolved."""
    (exact, motion), (found, moved) = resolved(), tied()
    stiff = abs(found / exact - 1)
    size = np.linalg.norm(motion.reshape(2, 3, -1), axis=1)
    miss = np.linalg.norm((moved - motion).reshape(2, 3, -1), axis=1)
    shift, turn = miss / size.max(axis=1, keepdims=True)
    places = np.arange(1, len(PLACES_MM) + 1)
    curves = (
        Curve("compliance", places, stiff),
        Curve("displacement of the magnet", places, shift),
        Curve("rotation of the magnet", places, turn),
    )
    words = (
        "One magnet per face; patches of 1 N over it and 3.6 to 4.5 mm beside it. Edges of 1 mm at "
        "the magnet that is tied (means over three meshes), of 0.5 mm at the one that is resolved."
    )
    return Measured(float(max(stiff.max(), shift.max(), turn.max())), words, curves)


CHECKS = (
    Check(
        "tied_magnets",
        "Rigid magnets tied to a mesh that does not know them",
        "a mesh that resolves them",
        0.02,
        tied_against_resolved,
        Fault("ties on the very skin", lambda patch: patch.setattr(tied_magnets, "INSET", 0.0)),
        "errors",
        ("place pressed", "difference, relative"),
    ),
)
