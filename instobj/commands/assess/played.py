"""Grasps on the object's skin, frame by frame: the scene that the page of an assessment plays."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.stats import chi2, norm

from design.layout.body import body_of, face_frames
from design.spec.object import ObjectSpec
from estimator.grasps.track import ContactTrack, placed_contacts
from instobj.commands.assess.groups import Group
from instobj.viewer.archive import pack, stepped
from instobj.viewer.scene import Arrays, add_surface
from instobj.viewer.surface import shaded_part

_MOST_FRAMES = 300
"""Frames of a grasp that are shown, spread over it: a picture each for five seconds of a screen's."""
_COLUMNS = {"point_mm": 3, "normal": 3, "pull_n": 3, "radius_mm": 1, "halfwidth_n": 1}
"""Columns of a contact: place, outward normal and force in the object's frame, and 90 % of both."""


def grasps_scene(spec: ObjectSpec, groups: list[Group]) -> bytes:
    """The archive that the page reads: the skin, and the contacts of every grasp of some groups."""
    arrays: Arrays = {}
    add_surface(arrays, "skin", shaded_part(body_of(spec).outer_surface()))
    frames = face_frames(spec)
    faces = {frame.number: frame for frame in frames}
    grasps, times_s, counts, contacts = [], [], [], []
    for group in groups:
        for recording, grasp in group.grasps:
            end = grasp.grasp.end - 1
            kept = np.unique(np.linspace(grasp.grasp.start, end, _MOST_FRAMES).round().astype(int))
            track = recording.read.track.select(kept)
            rows = [_contact_rows(track, row, faces) for row in range(len(track))]
            grasps.append(
                {
                    "name": f"{group.name}, {recording.read.path.name}, grasp {grasp.grasp.number}",
                    "frames": [len(times_s), len(track)],
                    "peak": int(np.argmax(track.total_n)),
                }
            )
            times_s += (track.time_s - track.time_s[0]).tolist()
            counts += [len(row) for row in rows]
            contacts += rows
    columns = np.split(np.concatenate(contacts), np.cumsum([*_COLUMNS.values()])[:-1], axis=1)
    arrays |= {
        name: stepped(values, "i2") for name, values in zip(_COLUMNS, columns, strict=True)
    } | {
        "time_s": np.array(times_s, "<f4"),
        "first": np.concatenate([[0], np.cumsum(counts)]).astype("<u4"),
    }
    content: dict[str, Any] = {
        "size_mm": list(spec.body.size_mm),
        "faces": [
            {"number": f.number, "centre_mm": f.centre_mm.tolist(), "normal": f.normal.tolist()}
            for f in frames
        ],
        "grasps": grasps,
    }
    return pack(content, arrays)


def _contact_rows(track: ContactTrack, frame: int, faces: dict[int, Any]) -> np.ndarray:
    """Columns of the contacts of a frame; a force that was not read counts as none."""
    placed = placed_contacts(track, frame, faces)
    push = np.einsum("cij,cj->ci", placed.axes, np.nan_to_num(placed.force_n))
    variance = placed.covariance
    # a disc that holds 90 % of two coordinates of one variance each: r² = σ² χ²₂(0.9)
    radius = np.sqrt(chi2.ppf(0.9, 2) * (variance[:, 0, 0] + variance[:, 1, 1]) / 2)
    sigma = np.hypot(np.sqrt(variance[:, 4, 4]), placed.scale_error * placed.force_n[:, 2])
    return np.column_stack([placed.point_mm, -placed.inward, push, radius, norm.ppf(0.95) * sigma])
