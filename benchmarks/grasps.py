"""Grasps of two simulated grippers, assessed from what a hidden object feels while it is turned.

    python benchmarks/grasps.py [--quick] [--draws N] [--out FOLDER]

The object is the paper's cube off its design within the tolerances, its mechanics on a mesh of their own.
Contact is solved jointly by finite elements. An estimator is calibrated on single presses of 25 places of
each of the two faces that the jaws press. Then a draw is two parallel jaws, one a quarter harder, with ten
grasps each: anywhere on two opposite faces, peaks that scatter by 10 %, turned in Earth's field of 50 µT
between two random directions, with the chips' noise, whole counts, errors of the zero and drift. One grasp
of three slips by 1 to 3 mm. Places and slips come from a pool; everything else is drawn anew. Finished
draws are kept, and an interrupted run goes on from them. Writes `grasps.json`.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Any

import numpy as np
from harness import Result, conclude, machine, option_parser, parts_folder
from scipy.spatial.transform import Rotation, Slerp
from scipy.stats import kstest

from design.files import atomic_path
from design.layout.body import face_frame
from design.layout.places.contact_grid import contact_grid
from design.spec.object import MeshSpec, ObjectSpec
from design.spec_io import load_spec
from estimator.calibration.twin.digital_twin import calibrate
from estimator.calibration.twin.inverted_twin import inverted_twin
from estimator.calibration.twin.pressed_places import invalidate_hard_presses, pressed_places
from estimator.frames.press_protocol import PLACE_ID_STRIDE, disturbed, simulated_frames
from estimator.grasps.balance import net_wrench
from estimator.grasps.damage import DamageLimit
from estimator.grasps.measures import MeasuredGrasp, conditions_of, measured_grasps
from estimator.grasps.ranking import compare
from estimator.grasps.rests import contacts_between_rests
from estimator.grasps.track import ContactTrack, placed_contacts, track_of_sets
from estimator.inversion.inversion import Inversion
from estimator.inversion.storage import load_inversion, save_inversion
from estimator.signals.monotone import monotone_cubic
from estimator.signals.presses import Signals
from estimator.tolerances.assembly import Assembly, counts_of
from estimator.tolerances.virtual_object import drawn_assembly, twin_model
from fem.linear.response import ResponseOperator, build_response
from fem.mesh.tetrahedra import tetrahedralize
from fem.presses.joint import Tip, press_path, refined_faces
from fem.presses.to_force import squeeze_path
from instobj.stages.run import Run
from instobj.store.readers import PRESSES

EXAMPLES = Path(__file__).parents[1] / "examples"
FACES = (3, 5)
GRIPPERS_N = {"gentle": 6.0, "rough": 7.5}
"""Force of each jaw, in the median."""
SPREAD, GRASPS = 0.1, 10
_OTHER_MESH = MeshSpec(surface_edge_mm=2.4, edge_mm=5.5)
_HIDDEN = 1_000
"""Added to the specification's seed for the errors of the object."""
_LABELLED = 25
"""Places of each face that the estimator is calibrated on, and depths of a press as shares of the deepest."""
_DEPTHS = np.linspace(0.1, 1.0, 16)
_LEFT_SHARE = 0.02
"""Share of the signals that such twins leave at places between (`calibration/twin/digital_twin.py`)."""
_POOL, _SLIPPING = 45, 3
"""Grasps whose mechanics is solved, of which one in so many slips."""
_LEVELS_N = (0.5, 2.0, 5.0, 8.0, 11.0)
"""Forces of a jaw that are solved; the object's own modulus scales them."""
_REACH_MM = 8.0
"""Places of jaws from the middle of the face, along each axis."""
_SLIP_MM, _SLIP_MM_PER_S = (1.0, 3.0), (10.0, 40.0)
_EARTH_T = 50e-6
_FRUIT = DamageLimit("fruit", "force_n", 7.2, 0.15, "made for this benchmark")
"""Fruit that the harder gripper damages more often than not."""
_REST = 20
"""Frames at rest before and after a grasp, two seconds each."""
_SHAPE = np.concatenate(
    [np.zeros(_REST), [0, 0.25, 0.6, 0.9], np.ones(11), [0.4, 0], np.zeros(_REST)]
)
"""Force of a grasp over its peak, frame by frame: rest, closing, hold, release, rest."""
_HELD = (_REST + 4, _REST + 15)


@dataclass(frozen=True)
class Hidden:
    """The object as it is, which the estimator does not know."""

    spec: ObjectSpec
    assembly: Assembly
    signals: Signals
    earth: np.ndarray

    def counts(self, motion: np.ndarray, field_t: np.ndarray) -> np.ndarray:
        """Changes of counts (frame, channel) against rest without a field."""
        model = twin_model(self.spec, self.assembly, motion)
        counts = counts_of(self.spec, self.assembly.scene, motion, model)
        change = counts - self.signals.baseline_counts
        return change.reshape(len(motion), -1) + field_t @ self.earth


def hidden_object(spec: ObjectSpec, signals_of: Signals) -> Hidden:
    """Draw the object; signals of Earth's field are linear in it."""
    assembly = drawn_assembly(spec, spec.seed + _HIDDEN)
    rest = np.zeros((1, assembly.scene.bodies, 6))
    model = twin_model(spec, assembly, rest)
    still = counts_of(spec, assembly.scene, rest, model)[0]
    around = assembly.scene.environment
    turned = [
        replace(assembly.scene, environment=replace(around, uniform_t=around.uniform_t + unit))
        for unit in 1e-4 * np.eye(3)
    ]
    earth = [(counts_of(spec, scene, rest, model)[0] - still).ravel() / 1e-4 for scene in turned]
    signals = replace(signals_of, baseline_counts=still)
    return Hidden(spec, assembly, signals, np.array(earth))


@dataclass(frozen=True)
class Jaws:
    """One grasp's mechanics.

    Attributes
    ----------
    xy_mm : (node, jaw, 2) places of both tips along the slip, one node where it holds
    motion : (node, level, magnet, 6) at `_LEVELS_N`
    """

    xy_mm: np.ndarray
    motion: np.ndarray

    @property
    def slip_mm(self) -> float:
        """Return the way of the first tip."""
        return float(np.linalg.norm(self.xy_mm[-1, 0] - self.xy_mm[0, 0]))


def solved_jaws(spec: ObjectSpec, response: ResponseOperator, faces: Any, number: int) -> Jaws:
    """Solve a grasp by two tips opposite each other; a slip has three places, a straight way."""
    rng = np.random.default_rng([number, 17])
    place = rng.uniform(-_REACH_MM, _REACH_MM, 2)
    nodes = [place]
    if number % _SLIPPING == 0:
        # towards the middle, so that a slip stays on the face
        angle = np.arctan2(*-place[::-1]) + rng.uniform(-1, 1)
        way = rng.uniform(*_SLIP_MM) * np.array([np.cos(angle), np.sin(angle)])
        nodes = [place, place + way / 2, place + way]
    frames = [face_frame(spec, face) for face in FACES]
    xy, motions = [], []
    for first in nodes:
        through = frames[0].to_object(np.append(frames[0].to_plane(first), 0.0))
        second = frames[1].from_plane(frames[1].plane_coordinates(through)[:2])
        tips = [Tip(face, *at.tolist()) for face, at in zip(FACES, (first, second), strict=True)]
        path = squeeze_path(spec, response, ([tips[0]], [tips[1]]), _LEVELS_N, faces)
        xy.append([first, second])
        motions.append([press.motion for press in path])
    return Jaws(np.array(xy), np.array(motions))


def labelled_frames(hidden: Hidden, response: ResponseOperator, faces: Any) -> Any:
    """Frames of single presses at places of every face, with load cells' noise; a press a zero."""
    spec, rng = hidden.spec, np.random.default_rng([1, 18])
    grid, signals, rows = contact_grid(spec), [], []
    depths = _DEPTHS[:, None] * max(spec.press.depths_mm)
    for face in FACES:
        for place in rng.permutation(len(grid.xy_mm))[:_LABELLED].tolist():
            path = press_path(
                spec, response, [Tip(face, *grid.xy_mm[place].tolist())], depths, faces
            )
            motion = np.array([press.motion for press in path])
            force = hidden.assembly.modulus_ratio * np.array([press.force_n[0] for press in path])
            change = hidden.counts(motion, np.zeros((len(motion), 3)))
            signals.append(disturbed(spec, hidden.signals, change[None], rng)[0])
            number = len(signals) - 1
            rows += [(face, place, *grid.xy_mm[place], one, number) for one in force.tolist()]
    face, place, x, y, force, press = np.array(rows).T
    noisy = force + spec.protocol.force_noise_n * rng.standard_normal(len(force))
    zero = np.zeros_like(force)
    return simulated_frames(
        spec, "", np.concatenate(signals),
        contact_face=face.astype(int)[:, None],
        contact_xy_mm=np.stack([x, y], axis=1)[:, None],
        force_n=np.stack([zero, zero, noisy], axis=1)[:, None],
        valid=noisy > 0.5,
        press_id=press.astype(int),
        place_id=(place + PLACE_ID_STRIDE * face).astype(int),
        session_id=press.astype(int),
    )  # fmt: skip


def calibrated(spec: ObjectSpec, presses: Any, frames: Any) -> Inversion:
    """Invert the twins of the pressed faces; forces are as uncertain as their moduli are."""
    twins = {}
    for face in FACES:
        reachable = invalidate_hard_presses(frames, presses[0], face)
        twins[face] = calibrate(spec, *presses, pressed_places(spec, reachable, face))
    estimator = inverted_twin(spec, *presses, twins, dict.fromkeys(FACES, _LEFT_SHARE))
    force_error = max(twin.modulus_error for twin in twins.values())
    return replace(estimator, disturbances=replace(estimator.disturbances, force_error=force_error))


@dataclass(frozen=True)
class Grasped:
    """What was done to the object in one grasp, frame by frame; `onset_s` is NaN where it held."""

    time_s: np.ndarray
    force_n: np.ndarray
    xy_mm: np.ndarray
    onset_s: float
    slip_mm: float
    counts: np.ndarray


def grasped(hidden: Hidden, jaws: Jaws, peak_n: float, rng: np.random.Generator) -> Grasped:
    """Take, hold, turn and release the object."""
    time_s = np.arange(len(_SHAPE)) / hidden.spec.sensors.frame_rate_hz
    force = peak_n * _SHAPE
    along, onset_s = np.zeros(len(time_s)), np.nan
    if len(jaws.xy_mm) > 1:
        # three frames or more of the hold come before it, and four after its beginning
        onset_s = rng.uniform(time_s[_HELD[0] + 3], time_s[_HELD[1] - 5])
        lasts = jaws.slip_mm / rng.uniform(*_SLIP_MM_PER_S)
        along = np.clip((time_s - onset_s) / lasts, 0.0, 1.0)
    # the parabola through the nodes at 0, ½ and 1 (Lagrange)
    weights = np.ones((1, len(along)))
    if len(jaws.xy_mm) > 1:
        weights = np.array(
            [(1 - along) * (1 - 2 * along), 4 * along * (1 - along), along * (2 * along - 1)]
        )
    nodes, levels = jaws.motion.shape[:2]
    scaled = force / hidden.assembly.modulus_ratio
    table = np.concatenate([np.zeros((nodes, 1, *jaws.motion.shape[2:])), jaws.motion], axis=1)
    at_force = monotone_cubic(
        np.tile(np.array([0.0, *_LEVELS_N]), (nodes, 1)),
        table.reshape(nodes, levels + 1, -1),
        np.tile(scaled, (nodes, 1)),
    )
    # n node, f frame, m motion
    motion = np.einsum("nf,nfm->fm", weights, at_force).reshape(len(force), *jaws.motion.shape[2:])
    xy = np.einsum("nf,njk->fjk", weights, jaws.xy_mm)
    field = earth_t(rng, len(force))
    change = hidden.counts(motion, field - field[0])
    counts = disturbed(hidden.spec, hidden.signals, change[None], rng)[0]
    return Grasped(time_s, force, xy, onset_s, jaws.slip_mm, counts)


def earth_t(rng: np.random.Generator, frames: int) -> np.ndarray:
    """Earth's field in the object's frame, from one random orientation to another while it is held."""
    turns = Rotation.random(2, random_state=rng)
    share = np.clip((np.arange(frames) - _HELD[0]) / (_HELD[1] - _HELD[0]), 0.0, 1.0)
    return Slerp([0, 1], turns)(share).apply(np.array([0.0, 0.0, _EARTH_T]))


def track_of(estimator: Inversion, grasp: Grasped) -> ContactTrack:
    """Read every frame in its order."""
    sets, _ = contacts_between_rests(estimator, grasp.counts)
    return track_of_sets(grasp.time_s, sets, estimator.disturbances.force_error)


def true_track(grasp: Grasped) -> ContactTrack:
    """The contacts as they were."""
    frames = len(grasp.time_s)
    touched = grasp.force_n > 0
    face = np.where(touched[:, None], np.array(FACES), 0)
    xy = np.where(touched[:, None, None], grasp.xy_mm, np.nan)
    force = np.full((frames, 2, 3), np.nan)
    force[touched, :, 2] = grasp.force_n[touched, None]
    return ContactTrack(
        grasp.time_s,
        face,
        xy,
        force,
        np.zeros((frames, 2, 5, 5)),
        np.ones(frames, bool),
        np.zeros(frames, bool),
    )


def jaw_angles_deg(
    read: ContactTrack, true: ContactTrack, frame: int, conditions: Any
) -> list[float]:
    """Angle between the wrench of each jaw as read and as it was, moments over the object's half width."""
    both = [placed_contacts(track, frame, conditions.faces) for track in (read, true)]
    angles = []
    for face in FACES:
        one, two = (_wrench(contacts, face) for contacts in both)
        norm = np.linalg.norm(one) * np.linalg.norm(two)
        cosine = float(one @ two / norm) if norm > 0 else 0.0
        angles.append(float(np.degrees(np.arccos(np.clip(cosine, -1, 1)))))
    return angles


def _wrench(contacts: Any, face: int) -> np.ndarray:
    some = contacts.face == face
    names = ("face", "point_mm", "axes", "force_n", "covariance")
    part = replace(contacts, **{name: getattr(contacts, name)[some] for name in names})
    wrench = net_wrench(part)
    reach = abs(contacts.point_mm).max(initial=1.0)
    return np.concatenate([wrench[:3], wrench[3:] / reach])


@dataclass(frozen=True)
class Felt:
    """One grasp of a draw: what was done, what was read, and the limit of the fruit in its place."""

    gripper: str
    done: Grasped
    track: ContactTrack
    limit_n: float


def drawn(number: int, hidden: Hidden, estimator: Inversion, pool: list[Jaws]) -> list[Felt]:
    """Return the grasps of both grippers, read frame by frame."""
    rng = np.random.default_rng([number, 19])
    chosen = rng.permutation(len(pool))[: 2 * GRASPS].reshape(2, GRASPS)
    felt = []
    for (gripper, level), own in zip(GRIPPERS_N.items(), chosen.tolist(), strict=True):
        for jaws in own:
            peak = level * float(np.clip(rng.normal(1, SPREAD), 0.7, 1.3))
            done = grasped(hidden, pool[jaws], peak, rng)
            limit = float(_FRUIT.median * np.exp(_FRUIT.spread * rng.standard_normal()))
            felt.append(Felt(gripper, done, track_of(estimator, done), limit))
    return felt


def save_draw(path: Path, felt: list[Felt]) -> None:
    """Write a draw's grasps, so that measures may change without reading frames anew."""
    values = {}
    for row, one in enumerate(felt):
        values |= {f"{row}_gripper": np.array(one.gripper), f"{row}_limit_n": np.array(one.limit_n)}
        for name, part in (("done", one.done), ("track", one.track)):
            values |= {f"{row}_{name}_{key}": np.asarray(v) for key, v in vars(part).items()}
    with atomic_path(path) as temporary, temporary.open("wb") as file:
        np.savez_compressed(file, **values)


def load_draw(path: Path) -> list[Felt]:
    """Read what `save_draw` wrote."""
    with np.load(path) as file:
        values = {name: file[name] for name in file.files}

    def part(row: int, name: str, kind: Any) -> Any:
        held = [values[f"{row}_{name}_{field.name}"] for field in fields(kind)]
        return kind(*(value.item() if value.ndim == 0 else value for value in held))

    return [
        Felt(
            str(values[f"{row}_gripper"]), part(row, "done", Grasped), part(row, "track", ContactTrack),
            float(values[f"{row}_limit_n"]),
        )
        for row in range(2 * GRASPS)
    ]  # fmt: skip


def draw_figures(felt: list[Felt], conditions: Any) -> Result:
    """Two grippers' grasps as measured and as they were, and how they are ranked."""
    rows, peaks = [], {gripper: [] for gripper in GRIPPERS_N}
    for one in felt:
        found = measured_grasps(one.track, conditions)
        peak = float(one.done.force_n.max())
        row: Result = {"gripper": one.gripper, "peak_n": peak, "slipped": one.done.slip_mm > 0}
        row["damaged"] = peak > one.limit_n
        if len(found) == 1:
            row |= grasp_row(found[0], one.track, one.done, conditions)
            peaks[one.gripper].append(found[0].readings["peak_n"].value)
        rows.append(row)
    (difference,) = compare({name: np.array(values) for name, values in peaks.items()})
    return {
        "rows": rows,
        "order_right": bool(difference.shift > 0),
        "ranked_right": bool(difference.sure and difference.shift > 0),
        "ranked_wrong": bool(difference.sure and difference.shift < 0),
    }


def grasp_row(found: MeasuredGrasp, track: ContactTrack, grasp: Grasped, conditions: Any) -> Result:
    """Return errors of a grasp's measures."""
    truth = true_track(grasp)
    held = slice(found.grasp.hold, found.grasp.release)
    true_n = float(truth.total_n[held].mean())
    mean = found.readings["mean_n"]
    frame = found.grasp.hold + 1
    pull, sigma = np.nan, np.nan
    if set(found.faces) == set(FACES):
        # along the x axis, through both faces; friction acts across it
        pull, sigma = float(found.wrench[0]), float(np.sqrt(found.covariance[0, 0]))
    start_s = float(track.time_s[found.grasp.hold])
    return {
        "unexplained": found.readings["unexplained"].value,
        "force_error": mean.value / true_n - 1,
        "force_inside": bool(mean.low <= true_n <= mean.high),
        "force_half_width": (mean.high - mean.low) / 2 / true_n,
        "angle_deg": max(jaw_angles_deg(track, truth, frame, conditions)),
        "pull_over_sigma": pull / sigma,
        "equilibrium_p": found.readings["equilibrium_p"].value,
        "slip_mm": found.readings["slip_mm"].value,
        "slip_error_mm": found.readings["slip_mm"].value - grasp.slip_mm,
        "onset_error_s": found.readings["slip_onset_s"].value + start_s - grasp.onset_s,
        "damage": found.readings["damage_fruit"].value,
        "friction_needed": found.readings["friction_needed"].value,
    }


def measure(options: Any, parts: Path) -> Iterator[Result]:
    """Yield the draws, made or kept."""
    spec = load_spec(EXAMPLES / "paper_cube.toml")
    presses = Run(spec).read(PRESSES)
    hidden = hidden_object(spec, _table(presses, spec))
    ready, model = parts / "pool.npz", parts / "contacts.nc"
    if not (ready.is_file() and model.is_file()):
        other = spec.changed(mesh=_OTHER_MESH)
        response = build_response(tetrahedralize(other), other)
        faces = refined_faces(other, response)
        if not model.is_file():
            frames = labelled_frames(hidden, response, faces)
            print("labelled presses are simulated", flush=True)
            save_inversion(calibrated(spec, presses, frames), model)
            print("the estimator is calibrated", flush=True)
        solved = [solved_jaws(other, response, faces, n) for n in range(_POOL)]
        np.savez(
            ready,
            **{f"xy_{n}": jaws.xy_mm for n, jaws in enumerate(solved)},
            **{f"motion_{n}": jaws.motion for n, jaws in enumerate(solved)},
        )
    print("mechanics is ready", flush=True)
    with np.load(ready) as file:
        pool = [Jaws(file[f"xy_{n}"], file[f"motion_{n}"]) for n in range(_POOL)]
    estimator = load_inversion(model)
    conditions = replace(conditions_of(spec), limits=(_FRUIT,))
    for number in range(2 if options.quick else options.draws):
        path = parts / f"draw_{number}.npz"
        if not path.is_file():
            save_draw(path, drawn(number, hidden, estimator, pool))
            print(f"draw {number}", flush=True)
        yield draw_figures(load_draw(path), conditions)


def _table(presses: Any, spec: ObjectSpec) -> Signals:
    from estimator.signals.presses import press_signals

    return press_signals(spec, *presses)


def figures_of(draws: list[Result]) -> Result:
    """Shares and errors over all draws."""
    rows = [row for draw in draws for row in draw["rows"]]
    whole = [row for row in rows if "force_error" in row]

    def column(name: str, some: list[Result] = whole) -> np.ndarray:
        return np.array([row[name] for row in some], float)

    error, angle = abs(column("force_error")), column("angle_deg")
    pull, p = column("pull_over_sigma"), column("equilibrium_p")
    slipped = [row for row in whole if row["slipped"]]
    held = [row for row in whole if not row["slipped"]]
    seen = [row for row in slipped if row["slip_mm"] > 0]
    onset, way = abs(column("onset_error_s", seen)), abs(column("slip_error_mm", seen))
    chance, damaged = column("damage"), column("damaged")
    bins = []
    for low, high in ((0.0, 0.1), (0.1, 0.3), (0.3, 0.5), (0.5, 0.7), (0.7, 0.9), (0.9, 1.01)):
        here = (chance >= low) & (chance < high)
        if here.any():
            said, seen_share = float(chance[here].mean()), float(damaged[here].mean())
            counted = {"from": low, "to": min(high, 1.0), "grasps": int(here.sum())}
            bins.append(counted | {"said": said, "damaged": seen_share})
    result = {
        "draws": len(draws),
        "grasps": len(rows),
        "order_right": float(np.mean([draw["order_right"] for draw in draws])),
        "ranked_right": float(np.mean([draw["ranked_right"] for draw in draws])),
        "ranked_wrong": float(np.mean([draw["ranked_wrong"] for draw in draws])),
        "read_as_one_grasp": len(whole) / len(rows),
        "unexplained": float(column("unexplained").mean()),
        "force_within_5_percent": float(np.mean(error <= 0.05)),
        "force_error_median": float(np.median(error)),
        "force_error_p95": float(np.quantile(error, 0.95)),
        "force_bias": float(np.mean(column("force_error"))),
        "force_inside_90": float(np.mean(column("force_inside"))),
        "force_half_width": float(np.median(column("force_half_width"))),
        "angle_within_5_deg": float(np.mean(angle <= 5)),
        "angle_median_deg": float(np.median(angle)),
        "angle_p95_deg": float(np.quantile(angle, 0.95)),
        "pull_chi2_per_dof": float(np.nanmean(pull**2)),
        "equilibrium_p_below_5": float(np.mean(p < 0.05)),
        "equilibrium_p_from_uniform": float(kstest(p[np.isfinite(p)], "uniform").statistic),
        "slips": len(slipped),
        "slips_seen": len(seen) / max(1, len(slipped)),
        "false_slips": float(np.mean(column("slip_mm", held) > 0)),
        "onset_within_50_ms": float(np.mean(onset <= 0.05)),
        "onset_error_median_s": float(np.median(onset)),
        "slip_within_0.5_mm": float(np.mean(way <= 0.5)),
        "slip_error_median_mm": float(np.median(way)),
        "brier": float(np.mean((chance - damaged) ** 2)),
        "brier_of_the_mean": float(np.var(damaged)),
    }  # fmt: skip
    return {name: round(v, 3) if isinstance(v, float) else v for name, v in result.items()} | {
        "reliability": [{k: round(v, 3) for k, v in one.items()} for one in bins]
    }


def report(result: Result) -> str:
    """Figures, a line each."""
    figures = dict(result["figures"])
    bins = figures.pop("reliability")
    lines = [f"{name} {value}" for name, value in figures.items()]
    lines += [
        f"chance {one['from']} to {one['to']}: {one['grasps']} grasps, said {one['said']}, "
        f"damaged {one['damaged']}"
        for one in bins
    ]
    return "\n".join(lines)


def main() -> None:
    """Measure, write, print."""
    parser = option_parser(__doc__ or "")
    parser.add_argument("--draws", type=int, default=100)
    options = parser.parse_args()
    result: Result = {"machine": machine(1, ["numpy", "scipy"]), "quick": options.quick}
    parts = parts_folder("grasps", "draws", options, result)
    parts.mkdir(parents=True, exist_ok=True)
    draws = list(measure(options, parts))
    conclude("grasps", options, result | {"figures": figures_of(draws)}, report)


if __name__ == "__main__":
    main()
