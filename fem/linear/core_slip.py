"""Core that has slipped against its shell: resting shell and magnets, and where presses land.

The core, its sensors and the plate that it stands on stay; the shell follows its bonded interface,
which moves by the inverse of the slip. The mean of that motion over the shell is rigid and is
taken exactly, for finite rotations; what the shell deviates from it, where its rim is held, is the
small-strain solution for the interface displacement prescribed. With a free outside there is no
deviation. Presses are then superposed: they land where the indenter is in the laboratory, push
along the face as it has turned, and their depth counts from the first touch.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float
from scipy.spatial.transform import Rotation

from design.body.surface_chart import FaceFrame
from design.layout.body import face_frames
from design.layout.places.positions import shell_body_layout
from design.spec.object import ObjectSpec
from fem.linear.core_interface import prescribed_loads, rigid_interface_motions
from fem.linear.factorization import solve_symmetric
from fem.linear.response import ElasticSystem, ResponseOperator, elastic_system, face_facets
from fem.linear.sparse import shape_of
from fem.mesh.tetrahedra import TetMesh


@dataclass(frozen=True)
class RestingShell:
    """The shell at rest on the slipped core, in the core's frame.

    `magnet_motion` (magnet, 6): shift of the centre (mm) and rotation vector (rad) from the layout.
    `deviation` is the part of it that is no rigid motion of the shell. `face_shift_mm` holds, for
    every sensed face, the displacement of its vertices in the object's frame.
    """

    magnet_motion: Float[np.ndarray, "magnet 6"]
    deviation: Float[np.ndarray, "magnet 6"]
    face_shift_mm: tuple[Float[np.ndarray, "_ 3"], ...]


@dataclass(frozen=True)
class InterfaceSolution:
    """Nodal displacements under a rigid motion of the interface, and the core's force and moment.

    `reaction` (6): what the core does to the silicone, N and N·mm about the origin.
    """

    displacement_mm: Float[np.ndarray, "3 node"]
    magnet_motion: Float[np.ndarray, "magnet 6"]
    reaction: Float[np.ndarray, "6"]


def shell_motion(spec: ObjectSpec) -> tuple[Rotation, Float[np.ndarray, "3"]]:
    """The shell's rigid motion x → R x + c seen from the core: the inverse of the core's slip."""
    slip = spec.mechanics.slip
    back = Rotation.from_rotvec(np.deg2rad(slip.rotation_deg)).inv()
    return back, -back.apply(np.asarray(slip.shift_mm, float))


def resting_shell(mesh: TetMesh, spec: ObjectSpec) -> RestingShell:
    """Solve for the shell on its slipped core (one factorization).

    Raises
    ------
    SingularSystemError
        The matrix could not be factored.
    """
    turn, shift = shell_motion(spec)
    amplitudes = np.concatenate([shift, turn.as_rotvec()])
    system = elastic_system(mesh, spec)
    solution = move_interface(system, mesh, spec, amplitudes)
    centre = shell_body_layout(spec).centre_mm
    linear = np.hstack(
        [_linear_rigid(amplitudes, centre), np.tile(turn.as_rotvec(), (len(centre), 1))]
    )
    deviation = solution.magnet_motion - linear
    finite = np.hstack([turn.apply(np.array(centre)) + shift - centre, linear[:, 3:]])
    nodes = system.space.nodes_mm
    moved = solution.displacement_mm.T - _linear_rigid(amplitudes, nodes)
    moved += turn.apply(np.array(nodes)) + shift - nodes
    return RestingShell(finite + deviation, deviation, deviation_at_faces(system, spec, moved))


def move_interface(
    system: ElasticSystem,
    mesh: TetMesh,
    spec: ObjectSpec,
    amplitudes: Float[np.ndarray, "6"],
) -> InterfaceSolution:
    """Displace the bonded interface by u = c + ω × r, amplitudes (c, ω) in mm and rad."""
    space, operators, basis = system.space, system.operators, system.motion_basis
    lifting = rigid_interface_motions(space.nodes_mm, spec)
    prescribed = prescribed_loads(operators, basis, space.pressure_nodes, lifting) @ amplitudes
    unknowns = solve_symmetric(system.matrix, prescribed[:, None])[:, 0]
    motions = shape_of(basis)[1]
    u = basis @ unknowns[:motions] + lifting @ amplitudes
    pressure = unknowns[motions:]
    internal = operators.stiffness @ u + operators.divergence[space.pressure_nodes].T @ pressure
    magnets = unknowns[motions - 6 * mesh.magnets : motions]
    return InterfaceSolution(u.reshape(3, -1), magnets.reshape(-1, 6), lifting.T @ internal)


def slipped_response(
    spec: ObjectSpec, response: ResponseOperator, rest: RestingShell
) -> ResponseOperator:
    """The same compliance with every face's vertices where the slip has put them."""
    surfaces = []
    for surface, frame, shift in zip(
        response.surfaces, face_frames(spec), rest.face_shift_mm, strict=True
    ):
        local = shift @ frame.axes
        beside, above = local[:, :2], local[:, 2]
        xy = surface.xy_mm + beside
        surfaces.append(replace(surface, xy_mm=xy, height_mm=above, slip_mm=beside))
    return replace(response, surfaces=tuple(surfaces))


def superposed(
    rest: Float[np.ndarray, "magnet 6"], motion: Float[np.ndarray, "*press magnet 6"]
) -> Float[np.ndarray, "*press magnet 6"]:
    """Motions from the layout of magnets that rest displaced, pressed as if they did not.

    The press turns with the magnet's surroundings: its displacement by the magnet's rotation at
    rest, its rotation before that one.
    """
    turn = Rotation.from_rotvec(rest[:, 3:])
    # R u of each magnet: m magnet, j and i coordinates, … presses
    shift = rest[:, :3] + np.einsum("mij,...mj->...mi", turn.as_matrix(), motion[..., :3])
    pressed = motion[..., 3:].reshape(-1, len(rest), 3)
    both = np.empty_like(pressed)
    for magnet in range(len(rest)):
        both[:, magnet] = (turn[magnet] * Rotation.from_rotvec(pressed[:, magnet])).as_rotvec()
    return np.concatenate([shift, both.reshape(motion[..., 3:].shape)], axis=-1)


def _linear_rigid(amplitudes: np.ndarray, points_mm: np.ndarray) -> np.ndarray:
    return amplitudes[:3] + np.cross(amplitudes[3:], points_mm)


def deviation_at_faces(
    system: ElasticSystem, spec: ObjectSpec, moved_mm: np.ndarray
) -> tuple[np.ndarray, ...]:
    """Displacement (vertex, 3) at the vertices of every sensed face, in the order of its surface."""
    return tuple(moved_mm[_face_vertices(system, spec, frame)] for frame in face_frames(spec))


def _face_vertices(system: ElasticSystem, spec: ObjectSpec, frame: FaceFrame) -> np.ndarray:
    facets = face_facets(system.mesh, spec, frame)
    return np.unique(np.asarray(system.mesh.facets)[:, facets])
