"""Readings of an object that is zeroed, turned in Earth's field and pressed, beside one that stands still.

    python benchmarks/turned_object.py [--quick] [--frames N] [--out FOLDER]

Frames of the paper's cube by a second forward model (`tests/support/turned_frames.py`): tips anywhere, at
least 10.5 mm apart, contact solved jointly by finite elements, 1 to 12 N a tip, magpylib's magnets, Earth's
field of 50 µT in two random directions, noise, whole counts. Read by the inversion as the design has it
("grasp") and by one that takes the object to stand still ("bench"), both with an exact model. The
mechanics come from the store, or are made first. Writes `turned_object.json`.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
from harness import Result, machine, run
from scipy.stats import kstest

from design.layout.places.contact_grid import contact_grid
from design.layout.places.positions import magnet_layout
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from estimator.inversion.inversion import Inversion, inversion
from estimator.metrics.contacts import matched_contacts, possible_distance_mm
from estimator.signals.presses import press_signals
from fem.linear.response import ResponseOperator
from fem.presses.joint import Tip, press_path, refined_faces
from instobj.stages.run import Run
from instobj.store.readers import PRESSES, RESPONSE
from tests.support.mechanics.inverted import labelled_frames
from tests.support.turned_frames import zeroed_counts

EXAMPLES = Path(__file__).parents[1] / "examples"
_FORCE_N, _APART_MM = (1.0, 12.0), 10.5
_STEPS = 12
"""Depths of a press, of which one is read."""

Pressed = tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]
"""Faces and places of the tips of each frame, their forces, and the magnets' motions."""


def measure(quick: bool, frames: int) -> Result:
    """Rows by use, turned or still, and number of contacts."""
    spec = load_spec(EXAMPLES / ("gallery/small_cube.toml" if quick else "paper_cube.toml"))
    run = Run(spec)
    presses, response = run.read(PRESSES), run.read(RESPONSE)
    signals = press_signals(spec, *presses)
    readers = {
        use: inversion(
            spec.changed(limits=spec.limits.changed(use=use)), *presses, signals, 0.0, 0.0
        )
        for use in ("bench", "grasp")
    }
    rows: list[Result] = []
    for number in range(4):
        pressed = _pressed(spec, response, number, 12 if quick else frames)
        for turned in (False, True):
            rng = np.random.default_rng([number, turned])
            counts = zeroed_counts(spec, pressed[3], rng, turned)
            state = {"state": "turned" if turned else "still"}
            rows += [state | _row(reader, counts, pressed, use) for use, reader in readers.items()]
    return {"machine": machine(1, ["numpy", "scipy", "magpylib"]), "quick": quick, "rows": rows}


def _pressed(spec: ObjectSpec, response: ResponseOperator, number: int, frames: int) -> Pressed:
    """Contact of so many tips, in frames in which each bears what readers are judged at."""
    rng, found = np.random.default_rng(number), []
    if not number:
        still = np.zeros((frames, len(magnet_layout(spec).face), 6))
        return np.zeros((frames, 1), int), np.full((frames, 1, 2), np.nan), still[:, :1, 0], still
    faces, deepest = refined_faces(spec, response), max(spec.press.depths_mm)
    while len(found) < frames:
        face, xy = _apart(spec, rng, number)
        tips = [Tip(int(f), float(x), float(y)) for f, (x, y) in zip(face, xy, strict=True)]
        shares = rng.uniform(0.3, 1, number)
        depths = np.linspace(0.1, 1, _STEPS)[:, None] * shares * deepest
        path = press_path(spec, response, tips, depths, faces)
        low, high = _FORCE_N
        within = [step for step in path if low <= step.force_n.min() and step.force_n.max() <= high]
        if within:  # forces are even over the range
            wanted_n = rng.uniform(low, high)
            nearest = min(within, key=lambda press: abs(press.force_n.mean() - wanted_n))
            found.append((face, xy, nearest.force_n, nearest.motion))
    face, xy, force, motion = (np.array(part) for part in zip(*found[:frames], strict=True))
    return face, xy, force, motion


def _apart(
    spec: ObjectSpec, rng: np.random.Generator, number: int
) -> tuple[np.ndarray, np.ndarray]:
    """Faces and places of tips of which no two on a face are near each other."""
    half_mm = float(contact_grid(spec).x_mm.max())
    while True:
        face = rng.choice(spec.body.sensed, number)
        xy = rng.uniform(-half_mm, half_mm, (number, 2))
        away = np.linalg.norm(xy[:, None] - xy, axis=2)
        near = (face[:, None] == face) & (away < _APART_MM)
        if near.sum() == number:  # each with itself
            return face, xy


def _row(reader: Inversion, counts: np.ndarray, pressed: Pressed, name: str) -> Result:
    face, xy, force, _ = pressed
    shown = counts.reshape(len(counts), len(reader.model.signals.faces), -1, 3)
    frames = replace(labelled_frames(face, xy, force), signal_counts=shown)
    found, _ = reader.read(counts)
    matched = matched_contacts(frames, found)
    right = matched.right
    of_right = right[matched.frame]
    possible_mm = possible_distance_mm(reader, frames)
    p = np.sort(found.p_value[right])
    row = {
        "reader": name,
        "contacts": int((face > 0).sum(axis=1).max()),
        "frames": len(counts),
        "number_right": float(right.mean()),
        "contacts_read": float(found.number.mean()),
        "force_read_n": float(np.nansum(found.force_n, axis=1).mean()),
        "explained": float(found.explained.mean()),
        "median_p": float(np.median(p)) if len(p) else None,
        "p_from_uniform": float(kstest(p, "uniform").statistic) if len(p) else None,
    }
    if len(matched.frame):
        distance = matched.distance_mm[of_right]
        row["median_mm"] = float(np.median(distance))
        row["mean_over_bound"] = float(
            np.mean(distance) / np.mean(possible_mm[matched.frame[of_right]])
        )
        row["place_in_region"] = float(matched.place_covered[of_right].mean())
        row["force_in_interval"] = float(matched.force_covered[of_right].mean())
    return {key: round(v, 3) if isinstance(v, float) else v for key, v in row.items()}


def report(result: Result) -> str:
    """One line for each reader, state and number of contacts."""
    lines = []
    for row in result["rows"]:
        line = (
            f"{row['contacts']} contacts, {row['state']}, {row['reader']}: number right "
            f"{row['number_right']:.1%}, explained {row['explained']:.1%}, median p {row['median_p']}"
        )
        if "median_mm" in row:
            line += (
                f"; {row['median_mm']:.2f} mm, {row['mean_over_bound']:.2f} bounds, "
                f"{row['place_in_region']:.0%} of places in their regions"
            )
        lines.append(line)
    return "\n".join(lines)


if __name__ == "__main__":
    run(measure, report, frames=(int, 400, "of each number of contacts"))
