"""A parallel-jaw grasp: two jaws with tips on opposite faces, squeezed to one force."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.errors import InputError
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from instobj.commands.presses.loads import (
    joint_pressed,
    loads_document,
    require_no_slip,
)
from instobj.commands.presses.places import Place, check_places, jaw_given
from instobj.stages.run import Run
from instobj.store.publish import require_writable, run_folder

if TYPE_CHECKING:
    from fem.presses.joint import JointPress


def grasp_specification(
    path: Path, jaws: list[str], force_n: float, out: Path, overrides: list[str]
) -> dict[str, Any]:
    """Squeeze the object between two jaws, `FACE:X,Y[;X,Y]` each.

    The tips of one jaw share its travel. Results go to `runs/<name>/grasp_<faces>_<force>N/`.

    Raises
    ------
    InputError
        A bad specification, not two jaws on opposite faces, a tip that cannot be pressed, sticking
        friction, or a force that is not reached.
    """
    spec = load_spec(path, overrides, table=False)
    first, second = _two_jaws(spec, jaws)
    require_no_slip(spec)
    checked = check_places(spec, [*first, *second], to_depth=False)
    if checked.refused:
        raise InputError(checked.refused[0]["error"])
    if spec.indenter.friction != "none" or any(spec.indenter.direction_deg):
        raise InputError(
            "a grasp is frictionless and straight. Set indenter.friction = 'none' and "
            "indenter.direction_deg = [0, 0]"
        )
    require_writable(out)
    run = Run(spec)
    final, pressed = joint_pressed(run, (first, second), force_n)
    label = f"grasp_{first[0].face}_{second[0].face}_{force_n:g}N"
    document = loads_document("grasp", run, pressed, (), run_folder(out, spec.name) / label)
    moment = unbalanced_moment_nmm(spec, final)
    document["objects"][0]["summary"]["grasp"] = {
        "force N": force_n,
        "moment the jaws leave, N mm": float(np.linalg.norm(moment)),
    }
    return document


def unbalanced_moment_nmm(spec: ObjectSpec, press: JointPress) -> np.ndarray:
    """Moment of the tips' normal forces about the object's centre, taken at their centres of pressure.

    A real object would turn until it vanishes, or friction bears it; here the core is held.
    """
    from design.layout.body import face_frames

    frames = {frame.number: frame for frame in face_frames(spec)}
    moment = np.zeros(3)
    centres = np.zeros((len(press.tips), 2)) if press.centre_mm is None else press.centre_mm
    for tip, force, away in zip(press.tips, press.force_n, centres, strict=True):
        frame = frames[tip.face]
        xy = frame.to_plane(np.array([tip.x_mm, tip.y_mm]))
        tangent = frame.tangent(xy)
        place = tangent.to_object(np.append(xy + away, 0.0))
        moment += np.cross(place, -force * tangent.normal)
    return moment


def _two_jaws(spec: ObjectSpec, jaws: list[str]) -> tuple[list[Place], list[Place]]:
    from design.layout.body import face_frames

    if len(jaws) != 2:
        raise InputError(
            f"a grasp has two jaws; got {len(jaws)}. Example: --jaw 3:0,0 --jaw '5:-7.5,0;7.5,0'"
        )
    first, second = (jaw_given(jaw) for jaw in jaws)
    normals = {frame.number: frame.normal for frame in face_frames(spec)}
    faces = (first[0].face, second[0].face)
    for face in faces:
        if face not in normals:
            raise InputError(f"face {face} is not sensed. Choose one of {sorted(normals)}")
    if normals[faces[0]] @ normals[faces[1]] > -0.5:
        raise InputError(
            f"faces {faces[0]} and {faces[1]} are not opposite each other: a parallel jaw cannot "
            "squeeze them. Take 3 and 5, or 2 and 4"
        )
    return first, second
