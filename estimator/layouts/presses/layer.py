"""Presses of one face by the closed form of a layer: the lowest fidelity level before there is a mesh.

Magnets of other faces rest: they count in what sensors read at rest, not in what a press changes. On a
curved face lengths along its surface take the place of those in a plane.
"""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

import numpy as np
import torch
from jaxtyping import Float

from design.body.surface_chart import FaceFrame
from design.layout.body import body_of, face_frames
from design.layout.places.contact_grid import contact_grid
from design.layout.places.contact_places import contact_places
from design.layout.pockets import shell_bodies
from design.spec.cached_geometry import SpecAlike
from design.spec.object import ObjectSpec
from estimator.field.device import one_thread
from estimator.layouts.presses.basis import (
    PressBasis,
    RowTable,
    StrainCoupling,
    ends_and_steps,
    faces_differ,
    patches_of,
)
from estimator.layouts.presses.compression import compressed, rms, with_ghosts
from fem.candidates.layer import Layer
from fem.candidates.motions import FaceCandidates, candidate_lattices

_PITCH, _DEPTHS = 3.0, 6.0
"""Steps of candidates along the surface and in depth, as shares of the shell's thickness: an eighth of what a
press moves is between two of them."""
_KEPT_OFF = 1.2
"""Thicknesses of the shell from a face's border, nearer to which bounds of presses count as at that
distance; what moves in them is shown where they are.

A layer knows no border and moves nothing beyond it. A real shell gives way there by up to twice as much, and
its neighbours' magnets move too: at 0.5 to 1 thicknesses from the border whole chains of three boxes had 0.2
to 0.4 times a layer's bounds, beyond 1.5 thicknesses 0.9 to 1.3 times."""


def layer_of(spec: ObjectSpec) -> Layer:
    """Return the shell as a layer, with the specification's tip as a ball."""
    return Layer(spec.shell.thickness_mm, spec.silicone.youngs_modulus_mpa, spec.indenter.radius_mm)


@one_thread()
def layer_basis(spec: ObjectSpec, face: int) -> PressBasis:
    """Return presses of one face to `score.force_n`, of the sensed faces' own contact locations.

    All that the presses tell is kept.

    Raises
    ------
    InputError
        A shell or a face without room for candidates.
    """
    # Specifications that differ in magnets' places, sensors or mould alone share all but the surfaces.
    parts = (
        *(spec.body, spec.shell, spec.core, spec.silicone),
        *(spec.indenter, spec.contact_grid, spec.press, spec.score),
    )
    outline = shell_bodies(spec)[0][0].outline
    basis, lattices = _layer_basis(SpecAlike(spec, (face, *parts, outline, body_of(spec).digest)))
    if not faces_differ(spec):
        return basis
    return replace(basis, patches=patches_of(spec, lattices, torch.float32))


@lru_cache(maxsize=16)
def _layer_basis(alike: SpecAlike) -> tuple[PressBasis, list[FaceCandidates]]:
    """Return the basis of the face that the key begins with, without surfaces, and candidates of all faces,
    of that one first."""
    spec, face = alike.spec, alike.key[0]
    frames = {frame.number: frame for frame in face_frames(spec)}
    here, order = frames[face], [face, *(number for number in frames if number != face)]
    thickness, layer = spec.shell.thickness_mm, layer_of(spec)
    lattices = {
        lattice.face: lattice
        for lattice in candidate_lattices(spec, thickness / _PITCH, thickness / _DEPTHS)
    }
    has_place, lattice = contact_places(spec)[spec.body.sensed.index(face)], lattices[face]
    places = contact_grid(spec).xy_mm[has_place]
    motion = _motions(spec, here, lattice, places)
    # No press lies beyond the middle of a face that is smaller than twice that.
    most = np.maximum(np.array(here.half_extents_mm) - _KEPT_OFF * thickness, 0.0)
    farther_in = _motions(spec, here, lattice, np.clip(places, -most, most))
    derivatives = 3 * len(places)
    motion[..., :derivatives] = farther_in[..., :derivatives]
    # Every quantity of every place is a mode of its own.
    modes = np.eye(motion.shape[2]).reshape(-1, 4, len(places))
    (rows,), vectors = compressed([motion], modes, rms(motion, modes), len(modes))

    def tensor(values: object) -> torch.Tensor:
        return torch.as_tensor(np.asarray(values), dtype=torch.float32)

    others, alone = [frames[number] for number in order[1:]], len(places)
    first, step = (tensor(part) for part in ends_and_steps(lattice))
    force, deepest = spec.score.force_n, layer.force_at(max(spec.press.depths_mm))
    basis = PressBasis(
        face,
        (),
        force,
        contact_grid(spec),
        has_place,
        first,
        step,
        lattice.shape,
        RowTable(tensor(with_ghosts(rows, lattice.shape)), tensor(vectors)),
        RowTable(torch.zeros(0, 0), torch.zeros(0, 4 * alone)),
        tensor([here.axes.T @ frame.axes for frame in others]).reshape(-1, 3, 3),
        tensor([here.plane_coordinates(frame.centre_mm) for frame in others]).reshape(-1, 3),
        torch.full((alone,), deepest),
        np.full(alone, layer.contact(force)[1] / force),
        _nothing_held(lattice),
        (),
    )
    return basis, [lattices[number] for number in order]


def _motions(
    spec: ObjectSpec, frame: FaceFrame, lattice: FaceCandidates, places: np.ndarray
) -> Float[np.ndarray, "candidate 6 quantity"]:
    """Motions of candidates in the face's frame: ∂/∂x, ∂/∂y, ∂/∂F and as they are, each at all places."""
    nx, ny, _ = lattice.shape
    xy = np.stack(np.meshgrid(lattice.x_mm, lattice.y_mm, indexing="ij"), axis=-1).reshape(-1, 2)
    away = xy[:, None] - places
    moved = layer_of(spec).motions(away, lattice.depth_mm, spec.score.force_n)
    if not frame.flat:
        # From the magnet's own axes to the face's: a candidate, p place, d depth, q quantity, b of 2 vectors
        turn = np.nan_to_num(frame.axes.T @ frame.axes_at(frame.to_plane(xy)))
        split = moved.reshape(*moved.shape[:-1], 2, 3)
        moved = np.einsum("aij,apdqbj->apdqbi", turn, split).reshape(moved.shape)
    # (candidate along the face, depth; motion; quantity, place)
    return moved.transpose(0, 2, 4, 3, 1).reshape(nx * ny * len(lattice.depth_mm), 6, -1)


def _nothing_held(lattice: FaceCandidates) -> StrainCoupling:
    """Magnets that move each other nothing."""
    nodes = int(np.prod([count + 2 for count in lattice.shape]))
    return StrainCoupling(
        torch.zeros(nodes, 5),
        torch.zeros(30, 2, 2, 2),
        torch.zeros(3),
        torch.ones(3),
    )
