"""Contact cases: which tips press where, and on which load cells.

A case is what a machine repeats: a probe of one to three tips on a face, two probes on opposite
faces, or nothing. Probes are those of Knopke et al. (RA-L 2024).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import combinations

import numpy as np
from jaxtyping import Float, Int

from design.errors import InputError
from design.layout.body import face_frames
from design.layout.places.contact_grid import contact_grid
from design.layout.places.contact_places import contact_places
from design.layout.tips import footprint_mm, tip_positions_mm, tips_overlap
from design.spec.learning import CollectionSpec, ProbePose
from design.spec.object import ObjectSpec
from estimator.signals.interpolation import among_pressed

DUAL_CASES, TRIPLE_CASES, GRASP_CASES = 100_000, 200_000, 300_000
"""Added to `place_id` = 1000 · face + number, so that every case has its own."""
GRASP_POSES: tuple[tuple[ProbePose, ...], ...] = (
    ((0.0, 0.0, 0.0), *((x, y, 0.0) for y in (-7.5, 7.5) for x in (-7.5, 7.5))),
    ((0.0, 0.0, 0.0), (0.0, -9.0, 0.0), (9.0, 0.0, 90.0)),
    ((0.0, -3.0, 0.0), (0.0, 3.0, 180.0)),
)
"""Places of the paper's grasps, known in words only: evenly over both faces."""
_FINGER_POSES: tuple[ProbePose, ...] = (
    *((0.0, y, 0.0) for y in (-6.0, 0.0, 6.0)),
    *((x, 0.0, 90.0) for x in (-6.0, 6.0)),
)
"""Middles and turns of two fingers against a thumb: as far apart as the paper's probe of two tips."""

_BORDER_MM = 0.01
"""Length by which a tip may reach off a flat face."""


@dataclass(frozen=True)
class ContactCase:
    """Tips that press together.

    `face` (tip,), `xy_mm` (tip, 2) in the face's frame, `cell` (tip,): tips of one number share a
    load cell, whose force is labelled in equal parts. `squeezed`: jaws of equal force, else
    indenters whose travels are `share` (tip,) of the largest. `place_id` names the case in a
    `FrameSet`.
    """

    face: Int[np.ndarray, "tip"]
    xy_mm: Float[np.ndarray, "tip 2"]
    cell: Int[np.ndarray, "tip"]
    share: Float[np.ndarray, "tip"]
    place_id: int
    squeezed: bool = False


def contact_groups(spec: ObjectSpec) -> list[list[ContactCase]]:
    """Cases of a collection that are recorded together; none of presses anywhere, drawn one by one.

    Raises
    ------
    InputError
        As `recorded_faces` and `grasp_cases`; a probe's pose with a tip off its face.
    """
    if spec.collection.kind in ("grasp", "handling"):
        return [grasp_cases(spec)]
    faces = recorded_faces(spec)
    if spec.collection.kind == "continuous":
        return []
    groups = [paper_cases(spec, face) for face in faces]
    for case in (case for group in groups for case in group if len(case.face) > 1):
        _require_on_face(spec, case)
    return groups


def recorded_faces(spec: ObjectSpec) -> list[int]:
    """Those of `collection.faces` that are sensed; each that is named must be, but for the default.

    Raises
    ------
    InputError
        None of them is sensed, or not all that are named.
    """
    named_faces, sensed = spec.collection.faces, spec.body.sensed
    recorded = [face for face in named_faces if face in sensed]
    named = named_faces != CollectionSpec().faces
    if not recorded or (named and len(recorded) < len(named_faces)):
        raise InputError(
            f"collection.faces = {list(named_faces)} names faces without sensors; sensed are {list(sensed)}. "
            "Name only those"
        )
    return recorded


def _require_on_face(spec: ObjectSpec, case: ContactCase) -> None:
    frames = {frame.number: frame for frame in face_frames(spec)}
    face = int(case.face[0])
    beside = abs(footprint_mm(spec.indenter)).max(axis=0) - _BORDER_MM
    reach = abs(frames[face].to_plane(case.xy_mm)) + (beside if frames[face].flat else 0.0)
    if frames[face].covers(reach).all():
        return
    half, tips = frames[face].half_lengths_mm, len(case.face)
    x, y = case.xy_mm.mean(axis=0)
    raise InputError(
        f"collection.poses: the probe of {tips} tips about ({x:.3g}, {y:.3g}) mm reaches beside face "
        f"{face} (±{half[0]:.4g}, ±{half[1]:.4g} mm). Give poses that fit this object, or none: [[], []]"
    )


def paper_cases(spec: ObjectSpec, face: int) -> list[ContactCase]:
    """Every contact location on its own, then the poses of the probes of two and three tips."""
    ids = 1000 * face
    has_place = contact_places(spec)[spec.body.sensed.index(face)]
    cases = [
        _probe(face, contact_grid(spec).xy_mm[[place]], ids + place)
        for place in np.flatnonzero(has_place).tolist()
    ]
    groups = zip((2, 3), spec.collection.poses, (DUAL_CASES, TRIPLE_CASES), strict=True)
    for tips, poses, first in groups:
        for number, pose in enumerate(poses):
            cases.append(_probe(face, probe_tips_mm(spec, tips, pose), first + ids + number))
    return cases


def grasp_cases(spec: ObjectSpec) -> list[ContactCase]:
    """Five places of one tip, three of two and two of three, each opposite its like; or
    `collection.random_grasps` of each, anywhere within the contact grid and turned at random. Of a thumb and
    two fingers as many places of these. In handling `collection.poses` may place each jaw by itself.

    Raises
    ------
    InputError
        `collection.grasp_faces` are not opposite each other, no room for a probe, or poses that are no pairs.
    """
    if spec.collection.kind == "handling" and spec.collection.poses != CollectionSpec().poses:
        return _misplaced(spec)
    wanted, rng = spec.collection.random_grasps, np.random.default_rng((spec.seed, 6))
    if wanted and len(spec.collection.grasp_faces) == 3:
        raise InputError(
            f"collection.random_grasps = {wanted} draws places of jaws; a thumb and two fingers have places "
            "of their own. Set it to 0"
        )
    if wanted:
        return opposed(
            spec, [_random_tips_mm(spec, rng, tips) for tips in (1, 2, 3) for _ in range(wanted)]
        )
    if len(spec.collection.grasp_faces) == 3:
        return opposed(spec, [np.array([pose[:2]]) for pose in _FINGER_POSES])
    places = [
        probe_tips_mm(spec, tips, pose)
        for tips, poses in enumerate(GRASP_POSES, start=1)
        for pose in poses
    ]
    return opposed(spec, places)


def _misplaced(spec: ObjectSpec) -> list[ContactCase]:
    """Return grasps whose jaws stand where `collection.poses` says, each in the frame of its own face."""
    first, second = (np.array(poses, float).reshape(-1, 3) for poses in spec.collection.poses)
    faces, wanted = spec.collection.grasp_faces, spec.collection.random_grasps
    turned = np.any(first[:, 2]) or np.any(second[:, 2])
    if len(faces) != 2 or wanted or turned or not len(first) or len(first) != len(second):
        raise InputError(
            "collection.poses with kind = 'handling' are places (x, y, 0) of the first jaw and as many of "
            f"the second, for two grasp_faces and random_grasps = 0; got {len(first)} and {len(second)} "
            f"places{', turned ones' * bool(turned)}, grasp_faces = {list(faces)} and random_grasps = "
            f"{wanted}. "
            "Give such pairs, turn jaws by indenter.turn_deg, or leave poses out"
        )
    return [
        replace(case, xy_mm=np.vstack([case.xy_mm[:1], place[None, :2]]))
        for case, place in zip(opposed(spec, list(first[:, None, :2])), second, strict=True)
    ]


def _random_tips_mm(
    spec: ObjectSpec, rng: np.random.Generator, tips: int
) -> Float[np.ndarray, "tip 2"]:
    grid, first = contact_grid(spec).xy_mm, spec.collection.grasp_faces[0]
    low, high = grid.min(axis=0), grid.max(axis=0)
    for _ in range(1000):
        x, y, turn = rng.uniform([*low, 0.0], [*high, 360.0])
        places = probe_tips_mm(spec, tips, (x, y, turn))
        if np.all((places >= low) & (places <= high)) and _lie_among_places(spec, first, places):
            return places
    raise InputError(
        f"a probe of {tips} tips does not find room within the contact grid, {low} to {high} mm. "
        "Widen contact_grid, or set collection.random_grasps = 0"
    )


def opposed(spec: ObjectSpec, places_mm: Sequence[Float[np.ndarray, "_ 2"]]) -> list[ContactCase]:
    """Grasps with tips at these places of the first of `collection.grasp_faces`, each opposite its
    like, or opposite two fingers, or alone; raises as `grasp_cases`."""
    first, *fingers = spec.collection.grasp_faces
    second = fingers[0] if fingers else first
    frames = {frame.number: frame for frame in face_frames(spec)}
    if not {first, second} <= set(frames):
        raise InputError(
            f"collection.grasp_faces = {list(spec.collection.grasp_faces)} are not both sensed; sensed are "
            f"{list(spec.body.sensed)}. Name two opposite ones of these"
        )
    if not fingers:
        pads = [_probe(first, tips_mm, GRASP_CASES + 1000 * first) for tips_mm in places_mm]
        return [replace(pad, place_id=pad.place_id + number) for number, pad in enumerate(pads)]
    if frames[first].normal @ frames[second].normal > -0.5:
        raise InputError(
            f"faces {first} and {second} are not opposite each other: jaws cannot squeeze them. Set "
            "collection.grasp_faces to [3, 5] or [2, 4]"
        )
    cases = []
    for tips_mm in places_mm:
        tips = len(tips_mm)
        touched = frames[first].to_plane(tips_mm)
        through = frames[first].to_object(np.column_stack([touched, np.zeros(tips)]))
        opposite_mm = frames[second].from_plane(frames[second].plane_coordinates(through)[:, :2])
        if len(fingers) == 2:
            turn = _FINGER_POSES[len(cases) % len(_FINGER_POSES)][2]
            opposite_mm = probe_tips_mm(spec, 2, (*opposite_mm[0].tolist(), turn))
        jaws = [tips, len(opposite_mm)]
        cell = np.repeat([0, 1], jaws)
        number = GRASP_CASES + 1000 * first + len(cases)
        face, xy = np.repeat([first, second], jaws), np.vstack([tips_mm, opposite_mm])
        cases.append(ContactCase(face, xy, cell, np.ones(sum(jaws)), number, squeezed=True))
    return cases


def probe_tips_mm(spec: ObjectSpec, tips: int, pose: ProbePose) -> Float[np.ndarray, "tip 2"]:
    """Return where the tips of a probe land."""
    x, y, turn = pose
    c, s = np.cos(np.deg2rad(turn)), np.sin(np.deg2rad(turn))
    places = tip_positions_mm(tips, spec.indenter.radius_mm)
    return places @ np.array([[c, s], [-s, c]]) + np.array([x, y], float)


class NoRoom(InputError):
    """Faces on which as many tips as wanted do not fit at once."""


def random_case(
    spec: ObjectSpec, rng: np.random.Generator, place_id: int, contacts: int
) -> ContactCase:
    """Tips anywhere on `collection.faces` within the contact grid, none overlapping another.

    The first goes deepest, the others between a half and all of its travel.
    """
    grid, faces = contact_grid(spec), np.asarray(recorded_faces(spec))
    low, high = grid.xy_mm.min(axis=0), grid.xy_mm.max(axis=0)
    for _ in range(1000):
        face, xy = rng.choice(faces, contacts), rng.uniform(low, high, (contacts, 2))
        if _apart(spec, face, xy) and all(
            map(partial(_lie_among_places, spec), face.tolist(), xy[:, None])
        ):
            share = np.concatenate([[1.0], rng.uniform(0.5, 1.0, contacts - 1)])
            return ContactCase(face, xy, np.arange(contacts), share, place_id)
    raise NoRoom(
        f"{contacts} tips of this indenter do not find room on faces "
        f"{faces.tolist()}. Lower collection.contacts or name more faces"
    )


def _lie_among_places(spec: ObjectSpec, face: int, xy_mm: Float[np.ndarray, "tip 2"]) -> bool:
    """Return whether tips land between contact locations that the face has."""
    has_place = contact_places(spec)[spec.body.sensed.index(face)]
    return bool(among_pressed(contact_grid(spec), has_place, *xy_mm.T).all())


def _apart(spec: ObjectSpec, face: np.ndarray, xy_mm: np.ndarray) -> bool:
    return not any(
        face[a] == face[b] and tips_overlap(spec.indenter, xy_mm[b] - xy_mm[a])
        for a, b in combinations(range(len(face)), 2)
    )


def _probe(face: int, xy_mm: np.ndarray, place_id: int) -> ContactCase:
    tips = len(xy_mm)
    return ContactCase(np.full(tips, face), xy_mm, np.zeros(tips, int), np.ones(tips), place_id)
