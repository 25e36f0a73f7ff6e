"""Flat jaws read from frames, as jaws and as tips alone, beside the joint presses that made the frames.

    python benchmarks/jaw_readings.py [--quick] [--out FOLDER]

Two jaws wider than the faces press opposite faces of three bodies to about five forces, under three tilts,
with noise drawn three times. Presses are solved jointly on a mesh of their own; no table or sum is in them.
The baseline is the same estimator without jaws: the sum of its tips on a face, and their centre.

On curved bodies one flat finger presses three places of three patches, with noise drawn three times. It is
read by the specification's own round tip, and by a specification whose indenter is that finger. Tables come
from the store, or are made first. Writes `jaw_readings.json`.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
from harness import Result, machine, run

from design.spec.object import IndenterSpec, MeshSpec, ObjectSpec
from design.spec_io import load_spec
from estimator.information.jaws import signals_of_motions
from estimator.inversion.explained import UNEXPLAINED
from estimator.inversion.inversion import Inversion
from estimator.inversion.readings import ContactSets
from fem.linear.response import ResponseOperator, build_response
from fem.mesh.tetrahedra import tetrahedralize
from fem.presses.joint import JointPress, Tip, press_tips
from instobj.stages.run import Run
from instobj.store.readers import INVERSION

EXAMPLES = Path(__file__).parents[1] / "examples"
BODIES = {
    "paper's cube": ("paper_cube.toml", []),
    "better_cube": ("better_cube.toml", []),
    "box 60 × 46 × 42": ("paper_cube.toml", ["body.size_mm=[60,46,42]"]),
}
CURVED = {"ball": "ball.toml", "capsule": "capsule.toml", "cylinder": "hall_skin.toml"}
FINGER = ['indenter.kind="cuboid"', "indenter.size_mm=[14,14]"]
"""Larger than what touches at the largest force here."""
PLACES_MM = ((0.0, 0.0), (6.0, 3.0), (-8.0, 6.0))
CURVED_FORCES_N = (2.0, 5.0, 10.0)
FACES = (3, 5)
FORCES_N = (5.0, 10.0, 20.0, 40.0, 80.0)
TILTS_DEG = ((0.3, 0.0), (0.0, -0.5), (0.4, 0.4))
DRAWS = 3
_OTHER_MESH = MeshSpec(surface_edge_mm=2.4, edge_mm=5.5)
_WIDER_MM = 100.0
"""Edges of the jaws: larger than any face here."""
_SECANTS = 3
"""Corrections of the depth: a tilted jaw's force bends with it."""


def measure(quick: bool) -> Result:
    """Errors by body and force."""
    rows = []
    for body in list(BODIES)[: 1 if quick else None]:
        example, changes = BODIES[body]
        spec = load_spec(EXAMPLES / example, changes)
        estimator = Run(spec).read(INVERSION)
        other = spec.changed(mesh=_OTHER_MESH)
        response = build_response(tetrahedralize(other), other)
        for force_n in FORCES_N[2:3] if quick else FORCES_N:
            rows.append(
                {"body": body, "force_n": force_n} | _row(spec, estimator, response, force_n)
            )
    curved = [
        row for body in list(CURVED)[: 1 if quick else None] for row in _curved_rows(body, quick)
    ]
    described = {"machine": machine(1, ["numpy", "scipy"]), "quick": quick}
    return described | {"rows": rows, "curved": curved}


def _curved_rows(body: str, quick: bool) -> Iterator[Result]:
    """Errors of a flat finger on a curved body, read by a round tip and by the finger itself."""
    path = EXAMPLES / CURVED[body]
    readers = {name: load_spec(path, keys) for name, keys in (("tip", []), ("finger", FINGER))}
    other = readers["finger"].changed(mesh=_OTHER_MESH)
    response, tips = build_response(tetrahedralize(other), other), other.body.sensed[:3]
    for force_n in CURVED_FORCES_N[1:2] if quick else CURVED_FORCES_N:
        presses = [
            _fingered(other, response, Tip(f, *xy), force_n) for f in tips for xy in PLACES_MM
        ]
        for name, spec in readers.items():
            estimator, rng = Run(spec).read(INVERSION), np.random.default_rng(7)
            errors = np.array(
                [
                    _error_of_finger(estimator.read(counts[None])[0], force_n)
                    for press in presses
                    for counts in _noisy(spec, press, rng)
                ]
            )
            yield {
                "body": body,
                "read_by": name,
                "force_n": force_n,
                "frames": len(errors),
                "read_as_one": float(np.mean(errors[:, 0] == 1)),
                "explained": float(np.mean(errors[:, 1] > UNEXPLAINED)),
                "force_ratio": np.percentile(errors[:, 2], [0, 10, 50, 90, 100]).tolist(),
                "within_90": float(np.mean(abs(errors[:, 3]) < 1.645)),
            }


def _fingered(spec: ObjectSpec, response: ResponseOperator, tip: Tip, force_n: float) -> JointPress:
    """Return one finger at the depth at which it bears a force within some per mille."""
    depth = 0.3
    for _ in range(2 * _SECANTS):
        press = press_tips(spec, response, [tip], np.array([depth]))
        # Hertz: force grows with the power 1.5 of the depth
        depth *= float(force_n / press.force_n[0]) ** (2 / 3)
    return press_tips(spec, response, [tip], np.array([depth]))


def _error_of_finger(reading: ContactSets, force_n: float) -> tuple[float, ...]:
    """Number of contacts, p value, all force over the true one, and the largest contact's error over σ."""
    held = reading.face[0] > 0
    if not held.any():
        return 0, float(reading.p_value[0]), 0.0, np.inf
    force, deviation = reading.force_n[0, held], np.sqrt(reading.covariance[0, held, 2, 2])
    largest = force.argmax()
    error = (force[largest] - force_n) / deviation[largest]
    return held.sum(), float(reading.p_value[0]), float(force.sum() / force_n), float(error)


def _row(
    spec: ObjectSpec, estimator: Inversion, response: ResponseOperator, force_n: float
) -> Result:
    without = replace(estimator, jaw_tables=())
    as_jaws, errors, errors_of_tips = [], [], []
    rng = np.random.default_rng(7)
    for tilt in TILTS_DEG:
        press = _pressed(spec, response, tilt, force_n)
        for counts in _noisy(spec, press, rng):
            reading, _ = estimator.read(counts[None])
            as_jaws.append(bool(reading.jaws[0]))
            errors.append([*_errors(reading, press), _tilt_error(reading, tilt)])
            errors_of_tips.append(_errors(without.read(counts[None])[0], press))
    jaws, tips = np.array(errors), np.array(errors_of_tips)
    return {
        "frames": len(jaws),
        "read_as_jaws": float(np.mean(as_jaws)),
        "force_error": _middle_and_most(jaws[:, 0]),
        "centre_mm": _middle_and_most(jaws[:, 1]),
        "tilt_deg": _middle_and_most(jaws[:, 2]),
        "tips_force_error": _middle_and_most(tips[:, 0]),
        "tips_centre_mm": _middle_and_most(tips[:, 1]),
    }


def _pressed(
    spec: ObjectSpec, response: ResponseOperator, tilt_deg: tuple[float, float], force_n: float
) -> JointPress:
    """Two jaws at the depth at which they bear about a force."""
    jaw = IndenterSpec(kind="cuboid", size_mm=(_WIDER_MM, _WIDER_MM), turn_deg=(0.0, *tilt_deg))
    tips, depth = [Tip(face, 0.0, 0.0) for face in FACES], 0.3
    for _ in range(_SECANTS):
        press = press_tips(spec.changed(indenter=jaw), response, tips, np.full(2, depth))
        # force grows with about the square of the depth while a tilted jaw comes to lie
        depth *= float((force_n / press.force_n.mean()) ** 0.5)
    return press_tips(spec.changed(indenter=jaw), response, tips, np.full(2, depth))


def _noisy(spec: ObjectSpec, press: JointPress, rng: np.random.Generator) -> Iterator[np.ndarray]:
    counts = signals_of_motions(spec, press.motion[None]).delta_counts[0, 0].ravel()
    noise = np.tile(np.asarray(spec.sensors.noise_counts, float), len(counts) // 3)
    for _ in range(DRAWS):
        yield counts + noise * rng.normal(size=len(counts))


def _errors(reading: ContactSets, press: JointPress) -> tuple[float, float]:
    """Largest error of both faces: of the whole force (relative) and of its centre (mm)."""
    assert press.centre_mm is not None
    force_errors, centre_errors = [], []
    for face, force, centre in zip(FACES, press.force_n, press.centre_mm, strict=True):
        here = reading.face[0] == face
        read = reading.force_n[0, here]
        force_errors.append(abs(read.sum() / force - 1))
        if read.sum() > 0:
            middle = read @ reading.xy_mm[0, here] / read.sum()
            centre_errors.append(float(np.linalg.norm(middle - centre)))
        else:
            centre_errors.append(np.nan)
    return float(max(force_errors)), float(max(centre_errors))


def _tilt_error(reading: ContactSets, tilt_deg: tuple[float, float]) -> float:
    tilts = reading.tilt_deg[0][np.isfinite(reading.tilt_deg[0, :, 0])]
    return float(abs(tilts - tilt_deg).max()) if len(tilts) else float("nan")


def _middle_and_most(errors: np.ndarray) -> list[float | None]:
    """Return median and largest of the errors that exist; None where none does."""
    known_errors = errors[np.isfinite(errors)]
    if not len(known_errors):
        return [None, None]
    return [float(np.median(known_errors)), float(known_errors.max())]


def report(result: Result) -> str:
    """One line a body and force."""
    return "\n".join(
        f"{row['body']}, {row['force_n']:g} N: jaws in {row['read_as_jaws']:.0%} of {row['frames']}; force, "
        f"centre, tilt {row['force_error']}, {row['centre_mm']}, {row['tilt_deg']}; as tips "
        f"{row['tips_force_error']}, {row['tips_centre_mm']}"
        for row in result["rows"]
    ) + "".join(
        f"\n{row['body']} by {row['read_by']}, {row['force_n']:g} N: one in {row['read_as_one']:.0%} of "
        f"{row['frames']}, explained {row['explained']:.0%}, force {np.round(row['force_ratio'], 2)}, within "
        f"90 % in {row['within_90']:.0%}"
        for row in result["curved"]
    )


if __name__ == "__main__":
    run(measure, report)
