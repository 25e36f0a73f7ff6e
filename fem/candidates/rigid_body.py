"""Motion of one rigid magnet with the silicone round it, as weights on displacements at its skin.

The motion of a magnet tied by the functionals Φ of `tied_magnets`, in a field of displacements u that
the silicone has without it, is (Rᵀ F⁻¹ R)⁻¹ Rᵀ F⁻¹ Φᵀ u, with R the functionals of its rigid motions
and F = Φᵀ A⁻¹ Φ their flexibility: u weighted with the tractions that the magnet exerts when it is
moved, as Faxén's laws say of a sphere in a fluid (Kim and Karrila, Microhydrodynamics, 1991, ch. 3).
F is taken below the middle of every face, at three depths, and the mean serves everywhere. How wrong
that is was measured on the paper's cube alone, one mesh, 5 N, 24 random places of one face, with F from
other places of that face (rms over presses): a magnet tied at its own place moves otherwise by 4 % along
the normal, 6 to 9 % along the face, 8 % in its tilt and 24 % in its spin, which does not change a disk's
field; a fit of its mid-plane was off by 31, 22, 37 and 24 %. On elements of 3 mm it is 8, 13, 23 and
93 % (tests). Left out: the other magnets (5 %), and how magnets change the pressures of a press (4 %).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp
from jaxtyping import Float

from design.layout.body import face_frame
from design.layout.pockets import shell_bodies
from design.spec.object import ObjectSpec
from fem.candidates.motions import FaceCandidates, known_places, stands_out_mm
from fem.candidates.point_motions import interpolate_at
from fem.candidates.quadrature import skin_quadrature
from fem.candidates.tied_magnets import (
    DEGREE,
    INSET,
    MOST_INSET,
    edge_mm,
    polynomials,
    rigid_motions,
)
from fem.linear.elements import DisplacementSpace
from fem.linear.factorization import Factorization
from fem.linear.response import ElasticSystem, displacements

_CIRCLES, _AROUND = 2, 8
_OF_THE_COVER = 0.8
"""Share of the silicone over the uppermost candidates that their upper half may take."""
_TOLD_APART = 1e-4
"""Of the largest flexibility: means that yield less are told apart by a few elements alone, those that
the magnet lies in, and would get weights that suit no other place."""


@dataclass(frozen=True)
class RigidBody:
    """Points on a magnet's skin about its centre, in its own frame, mm, and the weights (1, and 1/mm for
    ω) of displacements there in its motion (c, ω), components in that frame too."""

    points_mm: Float[np.ndarray, "point 3"]
    weights: Float[np.ndarray, "6 3 point"]

    @property
    def turns_with_plane(self) -> float:
        """Share λ of strain E in how it turns, ½ curl u − λ n × E n with n its axis (Jeffery, Proc. R. Soc.
        A 102 (1922) 161): 1 for a thin disk, which turns with the plane it lies in, 0 for a sphere. In a
        shell of 8 mm a disk of 6 × 1 mm has 0.64."""
        x, y, z = self.points_mm.T
        about_x, about_y = self.weights[3], self.weights[4]
        return float(about_x[1] @ z + about_x[2] @ y - about_y[0] @ z - about_y[2] @ x) / 2


def rigid_body(
    spec: ObjectSpec,
    system: ElasticSystem,
    factor: Factorization,
    lattices: Sequence[FaceCandidates],
) -> RigidBody:
    """The magnet of a specification, in the silicone that `system` is, with its matrix factored.

    One higher than twice the silicone over the uppermost candidates counts as if it fitted there.
    """
    body = shell_bodies(spec)[0][0]
    cover = min(-stands_out_mm(spec, lattice) for lattice in lattices)
    height = min(body.height_mm, 2 * _OF_THE_COVER * cover)
    places = [place for lattice in lattices for place in _middle_places(spec, lattice)]
    whole, _ = skin_quadrature(body.outline, height)
    around = np.concatenate([centre + whole @ axes.T for centre, axes in places])
    inset = min(INSET * edge_mm(system.space, around), MOST_INSET * height)
    outline, between = body.outline.inset(inset), height - 2 * inset
    points, weights = skin_quadrature(outline, between, _CIRCLES, _AROUND)
    psi = polynomials(points, weights, DEGREE) * weights[:, None]
    rigid = np.concatenate([psi.T @ part for part in rigid_motions(points)])
    moved = np.zeros((6, len(rigid)))
    for centre, axes in places:
        moved += _weights(system, factor, centre + points @ axes.T, axes, psi, rigid) / len(places)
    return RigidBody(points, moved.reshape(6, 3, -1) @ psi.T)


def candidate_rows(
    space: DisplacementSpace,
    centres_mm: Float[np.ndarray, "body 3"],
    axes: Float[np.ndarray, "3 3"] | Float[np.ndarray, "body 3 3"],
    body: RigidBody,
) -> sp.csr_matrix:
    """Motions (c, ω) of rigid bodies at these places under nodal displacements; (6·body, 3·node).

    `axes` are the body's x, y and axis as columns, one frame of all places or of each; motions are
    told in the object's frame.
    """
    count, points = len(centres_mm), len(body.points_mm)
    each = np.broadcast_to(axes, (count, 3, 3))
    at = centres_mm[:, None] + body.points_mm @ np.swapaxes(each, 1, 2)
    values = interpolate_at(space, at.reshape(-1, 3))
    local = body.weights.reshape(2, 3, 3, points)
    turned = np.einsum("bik,tkmp,bjm->btijp", each, local, each, optimize=True)
    ends, every = np.arange(0, count * points + 1, points), np.arange(count * points)

    def mean(weights: Float[np.ndarray, "body point"]) -> sp.csr_matrix:
        rows = sp.csr_matrix((weights.ravel(), every, ends), shape=(count, count * points))
        return sp.csr_matrix(rows @ values)

    blocks = [
        sp.hstack([mean(turned[:, part, axis, component]) for component in range(3)])
        for part in range(2)
        for axis in range(3)
    ]
    order = np.arange(6 * count).reshape(6, count).T.ravel()
    return sp.csr_matrix(sp.vstack(blocks))[order]


def _middle_places(
    spec: ObjectSpec, lattice: FaceCandidates
) -> list[tuple[Float[np.ndarray, "3"], Float[np.ndarray, "3 3"]]]:
    """Centre and axes below the candidate nearest to the middle of a face: least, middle and largest
    depth."""
    frame, known = face_frame(spec, lattice.face), known_places(spec, lattice)
    away = np.hypot(*np.meshgrid(lattice.x_mm, lattice.y_mm, indexing="ij"))
    ix, iy = np.unravel_index(int(np.where(known, away, np.inf).argmin()), known.shape)
    plane = frame.to_plane(np.array([[lattice.x_mm[ix], lattice.y_mm[iy]]]))
    axes = frame.axes if frame.flat else frame.axes_at(plane)[0]
    depths = lattice.depth_mm[[0, len(lattice.depth_mm) // 2, -1]]
    return [(frame.to_object(np.append(plane[0], -depth)), axes) for depth in depths]


def _weights(
    system: ElasticSystem,
    factor: Factorization,
    points_mm: Float[np.ndarray, "point 3"],
    axes: Float[np.ndarray, "3 3"],
    psi: Float[np.ndarray, "point k"],
    rigid: Float[np.ndarray, "functional 6"],
) -> Float[np.ndarray, "6 functional"]:
    """Of the functionals in a magnet's motion, at one place."""
    means = sp.csr_matrix(psi.T) @ interpolate_at(system.space, points_mm)
    functionals = sp.csr_matrix(sp.kron(axes.T, means))
    flexibility = functionals @ displacements(system, factor, functionals.T.toarray())
    size, mode = np.linalg.eigh((flexibility + flexibility.T) / 2)
    kept = size > _TOLD_APART * size[-1]
    held = (mode[:, kept] / size[kept]) @ (mode[:, kept].T @ rigid)
    return np.linalg.solve(rigid.T @ held, held.T)
