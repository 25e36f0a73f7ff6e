"""Motion of one rigid magnet with the silicone round it, as weights on displacements at its skin.

A magnet is tied by the functionals Φ of `tied_magnets`, in a field of displacements u that the silicone
has without it. With R the functionals of its rigid motions and F = Φᵀ A⁻¹ Φ their flexibility, it moves by
(Rᵀ F⁻¹ R)⁻¹ Rᵀ F⁻¹ Φᵀ u. That is u weighted with the tractions that the magnet exerts when it is moved,
as Faxén's laws say of a sphere in a fluid (Kim and Karrila, Microhydrodynamics, 1991, ch. 3).

F is taken below the middle of every face, at three depths, and the mean serves everywhere. How wrong
that is was measured on the paper's cube alone, one mesh, 5 N, 24 random places of one face, with F from
other places of that face. A magnet tied at its own place moves otherwise (rms over presses) by 4 % along
the normal, 6 to 9 % along the face and 8 % in its tilt. In its spin, which does not change a disk's
field, it is 24 %. A fit of its mid-plane was off by 31, 22, 37 and 24 %. On elements of 3 mm it is 8, 13,
23 and 93 % (tests). Left out here: the other magnets (5 %; `fem.candidates.influence`), and how magnets
change the pressures of a press (4 %).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp
from jaxtyping import Float, Int

from design.layout.body import face_frame
from design.layout.pockets import shell_bodies
from design.spec.object import ObjectSpec
from fem.candidates.motions import FaceCandidates, middle_of, stands_out_mm
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
from fem.linear.sparse import shape_of

CIRCLES, AROUND = 2, 8
"""Circles on a magnet's flat sides, and points on each: exact for polynomials of degree 3 (`quadrature`).

8 and 24 move magnets otherwise by 3.6 % at most (tests); rows would have nine times as many points.
"""
_OF_THE_COVER = 0.8
"""Share of the silicone over the uppermost candidates that their upper half may take.

Below 1, so that all points of a magnet's skin stay inside the silicone.
"""
_TOGETHER = 256
"""Bodies whose displacements are gathered at once: it bounds the memory."""
_TOLD_APART = 1e-4
"""Share of the largest flexibility below which a mean gets no weight.

Such means differ only in the few elements that the magnet lies in: their weights would suit no other place.
"""


STRAINS = np.array(
    [
        np.diag([-0.5, -0.5, 1.0]),
        [[0, 0, 1], [0, 0, 0], [1, 0, 0]],
        [[0, 0, 0], [0, 0, 1], [0, 1, 0]],
        np.diag([1.0, -1.0, 0.0]),
        [[0, 1, 0], [1, 0, 0], [0, 0, 0]],
    ]
)
"""The five strains of a material that keeps its volume (trace 0), as symmetric matrices (strain, 3, 3).

Along the axis z with the plane shrinking; shears xz and yz; stretch and shear in the plane.
"""


@dataclass(frozen=True)
class RigidBody:
    """Points on a magnet's skin about its centre, mm, and weights of displacements there, in its own frame.

    `weights` give its motion (c, ω), 1 and 1/mm; `strain_weights` the strain round it as shares of `STRAINS`,
    1/mm.
    """

    points_mm: Float[np.ndarray, "point 3"]
    weights: Float[np.ndarray, "6 3 point"]
    strain_weights: Float[np.ndarray, "5 3 point"]

    @property
    def jeffery_parameter(self) -> float:
        """Share λ of strain E in how it turns, ½ curl u − λ n × E n with n its axis (Jeffery, Proc. R. Soc.
        A 102 (1922) 161): 1 for a thin disk, which turns with the plane it lies in, 0 for a sphere. In a
        shell of 8 mm a disk of 6 × 1 mm has 0.64."""
        # Displace the skin by u = E r, E = e_y e_zᵀ + e_z e_yᵀ, n = e_z: ω = −λ n × E n has ω_x = λ.
        # The same E with x for y has ω_y = −λ. The mean of both serves a body that is not round.
        x, y, z = self.points_mm.T
        about_x, about_y = self.weights[3], self.weights[4]
        return float(about_x[1] @ z + about_x[2] @ y - about_y[0] @ z - about_y[2] @ x) / 2


@dataclass(frozen=True)
class Tied:
    """A magnet tied below the middle of a face: its place and axes, weights of its functionals in its motion
    and in the strain round it, and nodal displacements by which it resists each of `STRAINS`."""

    face: int
    depth_mm: float
    centre_mm: Float[np.ndarray, "3"]
    axes: Float[np.ndarray, "3 3"]
    motion: Float[np.ndarray, "6 functional"]
    strain: Float[np.ndarray, "5 functional"]
    field: Float[np.ndarray, "degree 5"]


def tied_magnets(
    spec: ObjectSpec,
    system: ElasticSystem,
    factor: Factorization,
    lattices: Sequence[FaceCandidates],
) -> tuple[RigidBody, list[Tied]]:
    """The magnet of a specification, in the silicone that `system` is, with its matrix factored, and it tied
    at three depths of every face.

    One higher than twice the silicone over the uppermost candidates counts as if it fitted there.
    """
    body = shell_bodies(spec)[0][0]
    cover = min(-stands_out_mm(spec, lattice) for lattice in lattices)
    height = min(body.height_mm, 2 * _OF_THE_COVER * cover)
    places = [place for lattice in lattices for place in _middle_places(spec, lattice)]
    whole, _ = skin_quadrature(body.outline, height)
    around = np.concatenate([centre + whole @ axes.T for *_, centre, axes in places])
    # Ties lie a little inside the skin (why: `fem.candidates.tied_magnets`).
    inset = min(INSET * edge_mm(system.space, around), MOST_INSET * height)
    outline, between = body.outline.inset(inset), height - 2 * inset
    points, weights = skin_quadrature(outline, between, CIRCLES, AROUND)
    # Functionals ∫ ψ_k u_c dS, component by component: psi (point, k) holds ψ_k times the quadrature's
    # weights; `rigid` and `strained` are their values for rigid motions and for u = E r.
    psi = polynomials(points, weights, DEGREE) * weights[:, None]
    rigid = np.concatenate([psi.T @ part for part in rigid_motions(points)])
    strained = np.stack([(psi.T @ (points @ strain.T)).T.ravel() for strain in STRAINS], axis=1)
    tied = []
    for face, depth, centre, axes in places:
        means = sp.csr_matrix(psi.T) @ interpolate_at(system.space, centre + points @ axes.T)
        # axesᵀ takes displacements from the object's frame to the magnet's own.
        functionals = sp.csr_matrix(sp.kron(axes.T, means))
        tied.append(
            Tied(
                face, depth, centre, axes, *_resisting(system, factor, functionals, rigid, strained)
            )
        )
    # One mean of all faces and depths serves everywhere (how wrong that is: the module's docstring).
    motion, strain = (
        np.mean([getattr(magnet, of) for magnet in tied], axis=0) for of in ("motion", "strain")
    )
    of_points = (part.reshape(len(part), 3, -1) @ psi.T for part in (motion, strain))
    return RigidBody(points, *of_points), tied


@dataclass(frozen=True)
class BodyRows:
    """Figures of rigid bodies under nodal displacements: weights of the degrees of freedom round each body,
    of 0 where it has fewer than others.

    `rows @ displacements` gives (body, figure, k).
    """

    columns: Int[np.ndarray, "body column"]
    weights: Float[np.ndarray, "body figure column"]

    def __matmul__(self, displacements: Float[np.ndarray, "degree *k"]) -> np.ndarray:
        fields = displacements.reshape(len(displacements), -1)
        parts = [
            self.weights[first : first + _TOGETHER]
            @ fields[self.columns[first : first + _TOGETHER]]
            for first in range(0, len(self.weights), _TOGETHER)
        ]
        return np.concatenate(parts).reshape(*self.weights.shape[:2], *displacements.shape[1:])

    @property
    def motions(self) -> BodyRows:
        """The first six figures."""
        return BodyRows(self.columns, self.weights[:, :6])


def candidate_rows(
    space: DisplacementSpace,
    centres_mm: Float[np.ndarray, "body 3"],
    axes: Float[np.ndarray, "3 3"] | Float[np.ndarray, "body 3 3"],
    body: RigidBody,
) -> BodyRows:
    """Motions (c, ω) of rigid bodies at these places, in the object's frame, then strains round them.

    The silicone would have these strains without the bodies; they are shares of `STRAINS` in a body's frame.
    `axes` are its x, y and axis as columns, one frame of all places or of each.
    """
    count, points = len(centres_mm), len(body.points_mm)
    each = np.broadcast_to(axes, (count, 3, 3))
    local = body.weights.reshape(2, 3, 3, -1)
    # b body, t displacement or rotation, k own axis of the motion, m own axis of u, p point;
    # i and j axes of the object's frame
    moved = np.einsum("bik,tkmp,bjm->btijp", each, local, each, optimize=True)
    # s strain, which stays in the body's own frame; m own axis of u, j that of the object's frame
    strained = np.einsum("smp,bjm->bsjp", body.strain_weights, each, optimize=True)
    weights = np.concatenate([moved.reshape(count, 6, 3, -1), strained], axis=1)
    skin_mm = centres_mm[:, None] + body.points_mm @ np.swapaxes(each, 1, 2)
    values = interpolate_at(space, skin_mm.reshape(-1, 3))
    nodes = values.indices.reshape(count, -1)
    # number a body's nodes: the rank of each entry among the different ones
    order = nodes.argsort(axis=1)
    ranked = np.take_along_axis(nodes, order, 1)
    rank = (np.diff(ranked, axis=1, prepend=ranked[:, :1]) > 0).cumsum(axis=1)
    number = np.empty_like(rank)
    np.put_along_axis(number, order, rank, 1)
    of_body = np.zeros((count, rank.max() + 1), int)
    np.put_along_axis(of_body, number, nodes, 1)
    shares = np.zeros((count, points, of_body.shape[1]))
    point = np.repeat(np.arange(points), nodes.shape[1] // points)
    shares[np.arange(count)[:, None], point, number] = values.data.reshape(count, -1)
    # the three components of a node lie a whole space apart
    columns = of_body[:, None] + shape_of(values)[1] * np.arange(3)[:, None]
    of_nodes = (weights.reshape(count, -1, points) @ shares).reshape(count, weights.shape[1], -1)
    return BodyRows(columns.reshape(count, -1), of_nodes)


def _middle_places(
    spec: ObjectSpec, lattice: FaceCandidates
) -> list[tuple[int, float, Float[np.ndarray, "3"], Float[np.ndarray, "3 3"]]]:
    """Face, depth, centre and axes below the candidate nearest to the middle of a face: least, middle and
    largest depth."""
    plane, axes = middle_of(spec, lattice)
    frame = face_frame(spec, lattice.face)
    depths = lattice.depth_mm[[0, len(lattice.depth_mm) // 2, -1]]
    return [
        (lattice.face, float(depth), frame.to_object(np.append(plane, -depth)), axes)
        for depth in depths
    ]


def _resisting(
    system: ElasticSystem,
    factor: Factorization,
    functionals: sp.csr_matrix,
    rigid: Float[np.ndarray, "functional 6"],
    strained: Float[np.ndarray, "functional 5"],
) -> tuple[
    Float[np.ndarray, "6 functional"],
    Float[np.ndarray, "5 functional"],
    Float[np.ndarray, "degree 5"],
]:
    """Weights of the functionals in a magnet's motion and in the strain round it, at one place, and the
    displacements that it adds where the silicone round it would be strained."""
    # F = Φᵀ A⁻¹ Φ, and its inverse K without modes that the mesh cannot tell apart. The mean with the
    # transpose removes rounding, as `eigh` reads one triangle alone.
    field = displacements(system, factor, functionals.T.toarray())
    flexibility = functionals @ field
    size, mode = np.linalg.eigh((flexibility + flexibility.T) / 2)
    kept = size > _TOLD_APART * size[-1]
    stiffness = (mode[:, kept] / size[kept]) @ mode[:, kept].T
    # Motion in a field u: (Rᵀ K R)⁻¹ Rᵀ K Φᵀ u, without force or torque on the magnet.
    held = stiffness @ rigid
    motion = np.linalg.solve(rigid.T @ held, held.T)
    # A strain less the motion that the magnet follows is what it resists, with the tractions T = K (…).
    # The strain round it is (Eᵀ T)⁻¹ Tᵀ Φᵀ u: 1 for its own field E, 0 for rigid motions.
    without_motion = strained - rigid @ (motion @ strained)
    resisted = stiffness @ without_motion  # tractions without force or torque
    strain = np.linalg.solve(strained.T @ resisted, resisted.T)
    return motion, strain, -field @ resisted  # what it adds to u is −A⁻¹ Φ T
