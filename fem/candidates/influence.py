"""Influence of magnets on each other, as none of them gives way to the strain round it.

A magnet in strained silicone pulls and pushes it like stresslets, and another one near it moves in what these
add: the first reflection (Kim and Karrila, Microhydrodynamics, 1991, ch. 8), of the five strains that keep
the volume. Taken between a magnet below the middle of every face and others next to it, in four directions as
far as the face has room, and at three depths of the first; means over faces and directions serve everywhere.
Beside all magnets tied at once, with the ties of each place, motions of a face's own magnets under 5 N are
off by 1.4 to 5.3 % (rms) instead of 4.8 to 12.8 % (seven layouts of the paper's cube, one mesh, one face;
a search had found the worst of them). No other body was measured.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from design.layout.body import face_frame
from design.layout.pockets import shell_bodies
from design.spec.object import ObjectSpec
from fem.candidates.motions import FaceCandidates, Influence, middle_of
from fem.candidates.rigid_body import RigidBody, Tied, candidate_rows
from fem.linear.elements import DisplacementSpace

_STEP_MM = 1.0
"""Step of the distances between two magnets, from contact of their rims on."""
_DIRECTIONS = np.deg2rad([0.0, 90.0, 180.0, 270.0])
"""Directions from the middle of a face to the other magnet, along the face's x and y."""
_ALONG, _ACROSS = np.ix_([0, 2, 4], [0, 1, 3]), np.ix_([1, 3, 5], [2, 4])
"""Motions and strains that a mirror through both magnets leaves as they are, and motions and strains that
it turns over."""


@dataclass(frozen=True)
class _Neighbours:
    """Magnets next to the middle of a face in one direction: distances, centres, and axes as columns, of
    which the first points away from the middle; depths of each distance follow each other."""

    distances: int
    centre_mm: Float[np.ndarray, "body 3"]
    axes: Float[np.ndarray, "body 3 3"]
    pair_axes: Float[np.ndarray, "body 3 3"]


def influence(
    spec: ObjectSpec,
    space: DisplacementSpace,
    body: RigidBody,
    tied: Sequence[Tied],
    lattices: Sequence[FaceCandidates],
) -> Influence:
    """Return the influence of tied magnets on magnets like `body`: what they add to the silicone's motion."""
    depth, first = lattices[0].depth_mm, 2 * shell_bodies(spec)[0][0].outline.radius_mm
    tied_depths_mm = sorted({item.depth_mm for item in tied})
    strains_by_lattice = []
    for lattice in lattices:
        for angle in _DIRECTIONS:
            neighbours = _neighbours(spec, lattice, angle, first)
            if not neighbours.distances:
                continue
            rows = candidate_rows(space, neighbours.centre_mm, neighbours.axes, body).motions
            sources = {item.depth_mm: item for item in tied if item.face == lattice.face}
            fields = np.stack(
                [
                    sources[tied_depth_mm].field @ strains_turned(angle)
                    for tied_depth_mm in tied_depths_mm
                ]
            )
            moved = np.stack([rows @ field for field in fields])
            moved = moved.reshape(len(tied_depths_mm), len(neighbours.centre_mm), 2, 3, 5)
            # Into the pair's frame: b body next to, d depth of the tied one, t displacement or
            # rotation,
            # j object coordinate, i axis of the pair's frame, s strain
            local = np.einsum("bji,dbtjs->dbtis", neighbours.pair_axes, moved)
            strains_by_lattice.append(
                local.reshape(len(tied_depths_mm), neighbours.distances, len(depth), 6, 5)
            )
    most = max((item.shape[1] for item in strains_by_lattice), default=1)
    table = np.zeros((len(tied_depths_mm), most + 1, len(depth), 6, 5))
    for distance in range(most):
        table[:, distance] = np.mean(
            [item[:, distance] for item in strains_by_lattice if distance < item.shape[1]] or [0.0],
            axis=0,
        )
    # A mirror through both magnets forbids the other entries: they are noise of the mesh.
    kept = np.zeros((6, 5))
    kept[_ALONG] = kept[_ACROSS] = 1.0
    # From the tied depths d to all depths e by a parabola; r distance, z depth of the body next to,
    # i motion, j strain
    values = np.einsum("ed,drzij->ezrij", _parabolas(np.array(tied_depths_mm), depth), table) * kept
    return Influence(depth, first, _STEP_MM, values.astype(np.float32))


def strains_turned(angle: float) -> Float[np.ndarray, "5 5"]:
    """Shares of `STRAINS` of each of them in a frame turned about z by the angle."""
    shares = np.eye(5)
    shares[1:3, 1:3], shares[3:, 3:] = _turn(angle), _turn(2 * angle)
    return shares


def _turn(angle: float) -> Float[np.ndarray, "2 2"]:
    return np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])


def _neighbours(
    spec: ObjectSpec, lattice: FaceCandidates, angle: float, first_mm: float
) -> _Neighbours:
    frame = face_frame(spec, lattice.face)
    middle = frame.from_plane(middle_of(spec, lattice)[0][None])[0]
    way = np.round([np.cos(angle), np.sin(angle)])
    ends = np.array([[nodes[0], nodes[-1]] for nodes in (lattice.x_mm, lattice.y_mm)])
    axis, side = (int(abs(way[1])), int(way.sum() > 0))
    room = abs(ends[axis, side] - middle[axis])
    away = np.arange(first_mm, room + 1e-9, _STEP_MM)
    plane = frame.to_plane(middle + away[:, None] * way)
    each, depth = np.repeat(plane, len(lattice.depth_mm), axis=0), lattice.depth_mm
    centres = frame.to_object(np.column_stack([each, -np.tile(depth, len(away))]))
    axes = np.broadcast_to(frame.axes, (len(each), 3, 3)) if frame.flat else frame.axes_at(each)
    turn = np.eye(3)
    turn[:2, :2] = _turn(angle)
    return _Neighbours(len(away), centres, axes, axes @ turn)


def _parabolas(
    nodes: Float[np.ndarray, "node"], points: Float[np.ndarray, "place"]
) -> Float[np.ndarray, "place node"]:
    """Weights of the nodes for the polynomial through all of them."""
    return np.stack(
        [
            np.prod(
                [
                    (points - other_node) / (node - other_node)
                    for other_node in nodes
                    if other_node != node
                ],
                axis=0,
            )
            for node in nodes
        ],
        axis=1,
    )
