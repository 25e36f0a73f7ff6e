"""Checks of tools on the finished object: jig, probes next to it, templates of magnets."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from design.body.meshes import manifold_of
from design.body.surface_chart import FaceFrame
from design.fabrication.assembly import Named, largest_common
from design.fabrication.finding import Finding, place_of
from design.layout.template_marks import pockets_by_face
from design.solids.curved_template import curved_template_faces
from design.solids.magnet_template import template_faces
from design.solids.probes import TIP_COUNTS, lowest_presses
from design.spec.object import ObjectSpec

if TYPE_CHECKING:
    import trimesh
    from manifold3d import Manifold

STANDS_MM, RESTING_MM3, MOST_LIFTED_MM = 0.2, 0.02, 10.0
"""Height by which an object may stand above its place on the jig, common volume at which it rests, and
how far it is lifted to find out."""


def check_tools(spec: ObjectSpec, meshes: dict[str, trimesh.Trimesh]) -> list[Finding]:
    """The object on its jig, and templates on the faces that they serve, as far as these were built."""
    body = [(name, meshes[name]) for name in ("core", "shell") if name in meshes]
    findings = list[Finding]()
    if "jig" in meshes and body:
        findings += [_seat_on_jig(meshes["jig"], body), *_probes_beside_jig(spec, meshes)]
    frames = {frame.number: frame for frame, _ in pockets_by_face(spec)}
    flat = all(frame.flat for frame in frames.values())
    groups = template_faces(spec) if flat else curved_template_faces(spec)
    if spec.arrangement == "sensors-in-shell":  # the magnets are set before the shell is cast
        body = [(name, mesh) for name, mesh in body if name == "core"]
    text = (
        "largest common volume of a template and what it lies on. Above the limit it does not lie: set "
        "magnets without it, or move them"
    )
    for first, numbers in groups.items():
        name = "magnet_template" if len(groups) == 1 else f"magnet_template_face_{first}"
        if name in meshes and body:
            placed = [(name, _move_to_face(meshes[name], frames[number])) for number in numbers]
            pairs = [(template, body_part) for template in placed for body_part in body]
            findings.append(largest_common("template on its face", name, pairs, text))
    return findings


def _seat_on_jig(jig: trimesh.Trimesh, body: list[Named]) -> Finding:
    """Return how far the object must be lifted until nothing of it stands in the jig.

    A volume alone says little: the post under a pear shared 1.3 mm³ with a core that stood 1.5 mm high.
    """
    post = manifold_of(jig)
    lifts = {name: _lift_mm(post, manifold_of(mesh)) for name, mesh in body}
    name = max(lifts, key=lambda name: lifts[name])
    text = (
        f"height by which the {name} stands above its place on the jig, as do all presses. Above the limit: "
        "widen body.bore_mm, or turn the body in its file"
    )
    common = np.reshape((post ^ manifold_of(dict(body)[name])).bounding_box(), (2, 3))
    place = place_of(common.mean(axis=0)) if lifts[name] else None
    status = "pass" if lifts[name] <= STANDS_MM else "fail"
    return Finding("object on its jig", "jig", lifts[name], STANDS_MM, "mm", status, text, place)


def _probes_beside_jig(spec: ObjectSpec, meshes: dict[str, trimesh.Trimesh]) -> list[Finding]:
    """Return how much of a probe meets the jig, where it comes down furthest on every face."""
    text = (
        "largest common volume of a probe and the jig, in the deepest press at the contact location of a "
        "face where the probe comes down furthest. Above the limit these locations cannot be pressed on "
        "the jig: leave the face out of body.sensed_faces, lessen contact_grid.count, or hold the object "
        "otherwise for them"
    )
    probes = {tips: meshes[f"probe_{tips}"] for tips in TIP_COUNTS if f"probe_{tips}" in meshes}
    pairs = [
        ((f"probe_{tips}", _move_to_face(probe, press)), ("jig", meshes["jig"]))
        for tips, probe in probes.items()
        for press in lowest_presses(spec, tips, np.asarray(probe.vertices))
    ]
    finding = largest_common("probes clear of the jig", "jig", pairs, text)
    # other locations can still be pressed: no reason to refuse the parts
    status = "warn" if finding.status == "fail" else "pass"
    return [replace(finding, status=status)] if pairs else []


def _lift_mm(jig: Manifold, body: Manifold) -> float:
    """Return the least lift along z after which two solids share no more than `RESTING_MM3`, by halving."""
    low, high = 0.0, MOST_LIFTED_MM

    def rests(lift: float) -> bool:
        return (jig ^ body.translate((0.0, 0.0, lift))).volume() <= RESTING_MM3

    if rests(low):
        return low
    while high - low > STANDS_MM / 8:
        middle = (low + high) / 2
        low, high = (low, middle) if rests(middle) else (middle, high)
    return high


def _move_to_face(mesh: trimesh.Trimesh, frame: FaceFrame) -> trimesh.Trimesh:
    """A part in a face's frame, moved to that face."""
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = frame.axes, frame.centre_mm
    return mesh.copy().apply_transform(pose)
