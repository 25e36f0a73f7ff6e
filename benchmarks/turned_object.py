"""Readings of an object that is zeroed, turned in Earth's field and pressed, beside one that stands still.

    python benchmarks/turned_object.py [--quick] [--frames N] [--out FOLDER]

Frames of five bodies on coarse meshes by a second forward model (`tests/support/turned_frames.py`): tips
anywhere, contact solved jointly by finite elements, 1 to 12 N a tip, magpylib's magnets, Earth's field of
50 µT in two random directions, noise, whole counts. Objects to the design are read by the inversion as the
design has it ("grasp") and, of the first body, by one that takes the object to stand still ("bench"), both
with an exact model. Then 40 objects of each body are drawn within `[tolerances]` and turned; the design's
inversion reads them ("design"). Two of each body are also read by their twins ("twin"), calibrated on
simulated presses of 25 places a face, and by exact models of the drawn objects ("exact"): what no twin can
better. Beside them stands how often the tip that shows least can be seen at all.
Finished bodies are kept until all are, and an interrupted run goes on from them. The mechanics come from
the store, or are made first. Writes `turned_object.json`.
"""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
from harness import Result, conclude, kept, machine, option_parser, parts_folder
from scipy.stats import chi2, kstest, ncx2

from design.errors import InputError
from design.layout.places.positions import magnet_layout
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from estimator.calibration.twin.digital_twin import calibrate, places_left_out
from estimator.calibration.twin.inverted_twin import inverted_twin
from estimator.calibration.twin.pressed_places import invalidate_hard_presses, pressed_places
from estimator.frames.contact_cases import random_case
from estimator.frames.press_protocol import simulate_presses
from estimator.inversion.inversion import Inversion, inversion
from estimator.inversion.model.noise import MESH_ERROR, design_error
from estimator.metrics.contacts import matched_contacts, possible_distance_mm
from estimator.signals.presses import press_signals
from estimator.tolerances.assembly import Assembly
from estimator.tolerances.virtual_object import drawn_assembly, twin_signals
from fem.linear.response import ResponseOperator
from fem.presses.joint import Tip, press_path, refined_faces
from fem.presses.results import MagnetMotions, PressForces
from instobj.stages.run import Run
from instobj.store.readers import PRESSES, RESPONSE
from tests.support.mechanics.inverted import labelled_frames
from tests.support.turned_frames import zeroed_counts

EXAMPLES = Path(__file__).parents[1] / "examples"
BODIES = ("paper_cube", "handle", "ball", "egg", "hall_skin")
COARSE = {"edge_mm": 7.0, "surface_edge_mm": 2.5, "rim_edge_ratio": 1.0, "envelope_mm": 0.15}
"""Mesh of every body: frames and readers share it."""
PITCH_MM = 4.0
OBJECTS, TWINS = 40, 2
"""Drawn objects of a body, and how many of them get a twin."""
_RESTS = 8
"""Frames at rest for each with so many contacts: false contacts are rare, and these frames cheap."""
_LABELLED = 25
"""Places of a face that a twin is calibrated on."""
_FIRST_SEED = 1000
"""Drawn objects are not those that the design's error is taken from."""
_FORCE_N = (1.0, 12.0)
_STEPS = 12
"""Depths of a press, of which one is read."""
_FALSE_TIPS = 1e-4
"""Chance that a tip is seen at one place where none is: 1 % of frames, over some 100 places that differ."""
_LIGHTEST_N = (1.0, 2.0, 3.0, 5.0, 12.0)
"""Ranges of the lightest tip's force."""

Pressed = tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]
"""Faces and places of the tips of each frame, their forces, and the magnets' motions."""
Presses = tuple[PressForces, MagnetMotions]


def measure(quick: bool, frames: int, parts: Path) -> Result:
    """Rows by body, use or object, turned or still, and number of contacts."""
    rows: list[Result] = []
    for body in ("gallery/small_cube",) if quick else BODIES:
        name = body.rsplit("/", maxsplit=1)[-1]
        measured = kept(parts, name, lambda body=body: _of_body(body, quick, frames))
        rows += [{"body": name} | row for row in measured]
    return {"machine": machine(1, ["numpy", "scipy", "magpylib"]), "quick": quick, "rows": rows}


def _of_body(body: str, quick: bool, frames: int) -> list[Result]:
    spec = load_spec(EXAMPLES / f"{body}.toml")
    if not quick:
        mesh, grid = spec.mesh.changed(**COARSE), spec.contact_grid.changed(pitch_mm=PITCH_MM)
        spec = spec.changed(mesh=mesh, contact_grid=grid)
    objects, twins = (4, 1) if quick else (OBJECTS, TWINS)
    run = Run(spec)
    presses, response = run.read(PRESSES), run.read(RESPONSE)
    signals = press_signals(spec, *presses)
    readers = {
        use: inversion(
            spec.changed(limits=spec.limits.changed(use=use)), *presses, signals, 0.0, 0.0
        )
        for use in (("bench", "grasp") if quick or body == BODIES[0] else ("grasp",))
    }
    error = design_error(spec, *presses, signals)
    design = inversion(spec, *presses, signals, error, spec.tolerances.modulus_relative)
    drawn = [drawn_assembly(spec, _FIRST_SEED + number) for number in range(objects)]
    readers_of = [
        {
            "twin": _twin(spec, presses, number, drawn[number]),
            "exact": inversion(
                spec, *presses, twin_signals(spec, drawn[number], *presses), 0.0, 0.0
            ),
        }
        for number in range(twins)
    ]
    rows: list[Result] = []
    for number in range(4):
        some = frames if number else _RESTS * frames
        pressed = _pressed(spec, response, number, 12 if quick else some)
        for turned in (False, True):
            rng = np.random.default_rng([number, turned])
            counts = zeroed_counts(spec, pressed[3], rng, turned)
            state = {"state": "turned" if turned else "still"}
            rows += [state | _row(reader, counts, pressed, use) for use, reader in readers.items()]
        state, rng = {"state": "turned"}, np.random.default_rng([number, 2])
        of_design = _of_objects(spec, pressed, drawn, rng)
        rows.append(state | _row(design, *of_design, "design"))
        for which, readers_here in enumerate(readers_of):
            face, xy, force, motion = (part[which::twins] for part in pressed)
            some = face, xy, force, motion
            of_twin = _of_objects(spec, some, drawn[which : which + 1], rng)
            seen = _chance_to_see(readers_here["exact"], *of_twin)
            rows += [
                state | _row(reader, *of_twin, f"{name} {which + 1}") | {"least_tip_seen": seen}
                for name, reader in readers_here.items()
            ]
    return rows


def _of_objects(
    spec: ObjectSpec, pressed: Pressed, objects: list[Assembly], rng: np.random.Generator
) -> tuple[np.ndarray, Pressed]:
    """Counts of turned objects, each in its share of the frames, and what presses them."""
    face, xy, force, motion = pressed
    which = np.arange(len(face)) % len(objects)
    counts = [
        zeroed_counts(spec, motion[[frame]], rng, built=objects[number].scene)
        for frame, number in enumerate(which)
    ]
    stiffer = np.array([objects[number].modulus_ratio for number in which])
    return np.concatenate(counts), (face, xy, force * stiffer[:, None], motion)


def _twin(spec: ObjectSpec, presses: Presses, number: int, built: Assembly) -> Inversion:
    """Return the inversion of an object's twins, each of some places of one face."""
    hidden = spec.changed(seed=_FIRST_SEED + number)
    frames = simulate_presses(hidden, twin_signals(spec, built, *presses), "")
    rng, twins, left = np.random.default_rng([number, 3]), {}, {}
    for face in spec.body.sensed:
        reachable = invalidate_hard_presses(frames, presses[0], face)
        pressed = pressed_places(spec, reachable, face)
        chosen = np.zeros(len(pressed), bool)
        chosen[rng.permutation(len(pressed))[:_LABELLED]] = True
        labelled = pressed.select_places(chosen)
        twins[face] = calibrate(spec, *presses, labelled)
        shares, _ = places_left_out(spec, *presses, labelled)
        left[face] = max(float(np.sqrt(np.mean(shares**2))), MESH_ERROR)
    return inverted_twin(spec, *presses, twins, left)


def _pressed(spec: ObjectSpec, response: ResponseOperator, number: int, frames: int) -> Pressed:
    """Contact of so many tips, in frames in which each bears what readers are judged at."""
    rng, found = np.random.default_rng(number), []
    if not number:
        still = np.zeros((frames, len(magnet_layout(spec).face), 6))
        return np.zeros((frames, 1), int), np.full((frames, 1, 2), np.nan), still[:, :1, 0], still
    faces, deepest = refined_faces(spec, response), max(spec.press.depths_mm)
    while len(found) < frames:
        case = random_case(spec, rng, 0, number)
        tips = [Tip(int(f), *xy.tolist()) for f, xy in zip(case.face, case.xy_mm, strict=True)]
        shares = rng.uniform(0.3, 1, number)
        depths = np.linspace(0.1, 1, _STEPS)[:, None] * shares * deepest
        try:
            path = press_path(spec, response, tips, depths, faces)
        except InputError:  # two tips share the border of a curved patch
            continue
        low, high = _FORCE_N
        within = [step for step in path if low <= step.force_n.min() and step.force_n.max() <= high]
        if within:  # forces are even over the range
            wanted_n = rng.uniform(low, high)
            nearest = min(within, key=lambda press: abs(press.force_n.mean() - wanted_n))
            found.append((case.face, case.xy_mm, nearest.force_n, nearest.motion))
    face, xy, force, motion = (np.array(part) for part in zip(*found[:frames], strict=True))
    return face, xy, force, motion


def _chance_to_see(reader: Inversion, counts: np.ndarray, pressed: Pressed) -> float | None:
    """Return the mean chance, over frames, that the tip that shows least is seen beside the others.

    That of a test of all three unknowns of a tip whose place is known, by linearised signals at the truth:
    what others take up at the best is taken off.
    """
    face, xy, force, _ = pressed
    if not face.any():
        return None
    rows = np.searchsorted(reader.model.signals.faces, face)
    singles = reader.model.singles(rows, np.concatenate([xy, force[..., None]], axis=2))
    white = reader.disturbances.observed(counts).white
    shape = len(face), -1, reader.model.channels
    signals, slopes = white(singles[:, :, 0]), white(singles[:, :, 1:].reshape(shape))
    chances = []
    for shown, slope in zip(signals, slopes, strict=True):
        of_tips = []
        for tip, signal in enumerate(shown):
            others = np.delete(slope, np.s_[3 * tip : 3 * tip + 3], axis=0).T
            left = signal - others @ np.linalg.lstsq(others, signal, rcond=None)[0]
            of_tips.append(ncx2.sf(chi2.isf(_FALSE_TIPS, 3), 3, left @ left))
        chances.append(min(of_tips))
    return round(float(np.mean(chances)), 3)


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
        "right_by_lightest": _by_lightest(right, force) if face.any() else "",
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


def _by_lightest(right: np.ndarray, force: np.ndarray) -> str:
    """Return frames read right of all frames, by the force of the lightest tip."""
    which = np.digitize(force.min(axis=1), _LIGHTEST_N[1:-1])
    parts = (right[which == part] for part in range(len(_LIGHTEST_N) - 1))
    return ", ".join(f"{part.sum()} of {len(part)}" for part in parts)


def report(result: Result) -> str:
    """Return a line for each reader and state, of all bodies and of each: by 0 to 3 contacts."""
    rows, lines = result["rows"], []
    bodies = list(dict.fromkeys(row["body"] for row in rows))
    for body in ["all bodies", *bodies] if len(bodies) > 1 else bodies:
        some = [row for row in rows if body in ("all bodies", row["body"])]
        kinds = dict.fromkeys((row["state"], row["reader"]) for row in some)
        for state, reader in kinds:
            of_kind = [row for row in some if (row["state"], row["reader"]) == (state, reader)]
            if len({row["body"] for row in of_kind}) < len({row["body"] for row in some}):
                continue  # a reader that only some bodies have
            right = _by_contacts(of_kind, "number_right", 100)
            places = _by_contacts(of_kind, "place_in_region", 100)
            bounds = _by_contacts(of_kind, "mean_over_bound", 1)
            lines.append(
                f"{body}, {state}, {reader}: number right {right} %; {bounds} bounds, {places} % of "
                "places in their regions"
            )
    return "\n".join(lines)


def _by_contacts(rows: list[Result], name: str, scale: float) -> str:
    """Return the mean over bodies for each number of contacts that has one."""
    shown = []
    for number in range(4):
        values = [row[name] for row in rows if row["contacts"] == number and name in row]
        if values:
            mean = scale * float(np.mean(values))
            shown.append(f"{mean:.3g}" if scale > 1 else f"{mean:.2f}")
    return " / ".join(shown)


def main() -> None:
    """Measure, write, print."""
    parser = option_parser(__doc__ or "")
    parser.add_argument("--frames", type=int, default=40, help="of each number of contacts")
    options = parser.parse_args()
    form = "quick" if options.quick else f"of_{options.frames}"
    parts = parts_folder("turned_object", form, options, {"machine": machine(1, [])})
    conclude("turned_object", options, measure(options.quick, options.frames, parts), report)
    shutil.rmtree(parts)


if __name__ == "__main__":
    main()
