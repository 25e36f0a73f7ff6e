"""Measures of each grasp of a track, with intervals by the estimator's covariance."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float, Int
from scipy.stats import norm

from design.body.surface_chart import FaceFrame
from design.layout.body import face_frames
from design.spec.object import ObjectSpec
from estimator.frames.dataset import NO_FACE
from estimator.grasps.balance import (
    asymmetry,
    drawn_in_balance,
    equilibrium_misfit,
    equilibrium_p,
    grasp_axis,
    net_wrench,
    side_forces_n,
    wrench_covariance,
)
from estimator.grasps.damage import (
    DamageLimit,
    Sphere,
    damage_probability,
)
from estimator.grasps.holding import (
    common_onset_s,
    contact_slip,
    creep_per_decade,
    loading_rate_n_per_s,
    peak_frames,
    unsteadiness,
)
from estimator.grasps.phases import Grasp, find_grasps
from estimator.grasps.skin import Skin
from estimator.grasps.track import ContactTrack, Placed, placed_contacts, variance_of_mean
from estimator.grasps.wrench_space import (
    closing_friction,
    contact_wrenches,
    friction_used,
    wrench_space,
)

if TYPE_CHECKING:
    from estimator.inversion.model.table import PressTable
    from estimator.recordings.attitude import RecordedMotion

_HALF = float(norm.ppf(0.95))
"""Half of a normal interval of 90 % in standard deviations."""
_DRAWS, _HULL_DRAWS = 99, 39
"""Draws of what the covariance allows: the contacts themselves and opposite pairs, of which an interval
leaves out one in ten; fewer of the slow hulls. Of 19 pairs its share scatters by 7 %, of 49 by 4 %."""
UNKNOWN = float("nan")


@dataclass(frozen=True)
class Conditions:
    """Facts of the object and of the test.

    Attributes
    ----------
    faces : of the object, by number
    hertz : its silicone and the gripper's tip, for Hertz
    tip_radius_mm : of the gripper's tips
    friction : between gripper and object, assumed
    weight_n : of the object; 0 where it is not known or borne otherwise
    limits : of damage
    motion : of the object by its IMU, on the track's clock; None where it has none
    presses : depth and contact area of solved presses (`ContactModel.skin`); None for Hertz
    """

    faces: Mapping[int, FaceFrame]
    hertz: Sphere
    tip_radius_mm: float
    friction: float = 0.5
    weight_n: float = 0.0
    limits: tuple[DamageLimit, ...] = ()
    motion: RecordedMotion | None = None
    presses: PressTable | None = None

    @property
    def skin(self) -> Skin:
        """Return the object's skin under the tips."""
        return Skin(self.faces, self.hertz, self.presses)


def conditions_of(spec: ObjectSpec, presses: PressTable | None = None) -> Conditions:
    """Return faces, skin and tips of a specification; the tip of its indenter presses."""
    radius = spec.indenter.radius_mm
    hertz = Sphere(spec.silicone.youngs_modulus_mpa, spec.silicone.poisson_ratio, radius)
    faces = {frame.number: frame for frame in face_frames(spec)}
    return Conditions(faces, hertz, radius, presses=presses)


@dataclass(frozen=True)
class Reading:
    """A figure with its 90 % interval; NaN ends where the estimator gives none."""

    value: float
    low: float = UNKNOWN
    high: float = UNKNOWN


@dataclass(frozen=True)
class MeasuredGrasp:
    """One grasp in figures.

    Attributes
    ----------
    start_s, end_s : by the recording's clock
    readings : by the names of `protocols.MEASURES`, and `damage_<fruit>` for each limit
    faces : mean and peak force of each face that was touched
    wrench, covariance : net force (N) and moment (N mm) in the hold
    opposed : two sides press against each other, and nothing else touches
    places : of each contact at the peak: face, x, y (mm), force (N), damage by limit
    placed : the estimator explains the peak, so that its places may be believed
    """

    grasp: Grasp
    start_s: float
    end_s: float
    readings: dict[str, Reading]
    faces: dict[int, tuple[Reading, Reading]]
    wrench: Float[np.ndarray, "6"]
    covariance: Float[np.ndarray, "6 6"]
    opposed: bool
    places: list[dict[str, float | int]]
    placed: bool


def measured_grasps(track: ContactTrack, conditions: Conditions) -> list[MeasuredGrasp]:
    """Measure every grasp of a track; none where nothing was grasped."""
    grasps = find_grasps(track.time_s, track.total_n)
    return [measured_grasp(track, grasp, conditions) for grasp in grasps]


def measured_grasp(track: ContactTrack, grasp: Grasp, conditions: Conditions) -> MeasuredGrasp:
    """Measure one grasp of a track; its number is the seed of what is drawn for intervals."""
    part, held = _part(track, grasp.start, grasp.end), _part(track, grasp.hold, grasp.release)
    closing = _part(track, max(grasp.approach, grasp.start - 1), min(grasp.hold + 2, grasp.end))
    rng = np.random.default_rng(grasp.number)
    hold = slice(grasp.hold - grasp.start, grasp.release - grasp.start)
    window = peak_frames(part.total_n, hold)
    peak = window.start + int(np.argmax(part.total_n[window]))
    top = part.averaged(_frames_like(part, peak, window))
    usual = _typical_frame(held, grasp.level_n)
    mean = held.averaged(_frames_like(held, usual, slice(0, len(held))))
    at_peak = placed_contacts(top, 0, conditions.faces)
    typical = placed_contacts(mean, 0, conditions.faces)
    wrench, covariance = net_wrench(typical), wrench_covariance(typical, conditions.friction)
    faces = _face_forces(part, hold)
    start_s, end_s = float(part.time_s[0]), float(part.time_s[-1])
    jolt = UNKNOWN
    if conditions.motion is not None:
        jolt = conditions.motion.jolt_between(start_s, end_s)
    pull = _pull_over(conditions, held.time_s)
    pull_at_peak = _pull_over(conditions, part.time_s[window])
    damage, places = _damage(top, at_peak, conditions, pull_at_peak, rng)
    readings = {
        "peak_n": _spread(float(part.total_n[window].mean()), float(top.total_sigma_n[0])),
        "mean_n": _spread(float(held.total_n.mean()), float(mean.total_sigma_n[0])),
        "finger_n": max((top for _, top in faces.values()), key=lambda reading: reading.value),
        **_with_intervals(at_peak, rng, partial(_peak_figures, conditions, bool(top.jaws[0]))),
        **_with_intervals(typical, rng, partial(_hold_figures, conditions)),
        **_with_intervals(typical, rng, partial(_hull_figures, conditions), _HULL_DRAWS),
        "equilibrium_p": Reading(_balance_chance(typical, wrench, covariance, conditions, pull)),
        **{name: Reading(value) for name, value in _course(held, closing, list(faces)).items()},
        "regrasps": Reading(float(grasp.regrasps)),
        "jolt_m_s2": Reading(jolt),
        "unexplained": Reading(float(np.mean(~part.explained))),
        **damage,
    }
    opposed = _is_opposed(typical)
    return MeasuredGrasp(
        grasp, start_s, end_s, readings, faces, wrench, covariance, opposed, places,
        bool(part.explained[int(np.argmax(part.total_n))]),
    )  # fmt: skip


def _part(track: ContactTrack, first: int, last: int) -> ContactTrack:
    return track.select(slice(first, last))


def _pull_over(
    conditions: Conditions, time_s: Float[np.ndarray, "frame"]
) -> Float[np.ndarray, "3"]:
    """Return the mean pull of the weight over some frames; NaN without an IMU."""
    if conditions.motion is None:
        return np.full(3, np.nan)
    return conditions.motion.pull_between(float(time_s[0]), float(time_s[-1]))


def _typical_frame(held: ContactTrack, level_n: float) -> int:
    """Frame with the usual number of contacts whose force is nearest to the level."""
    count = (held.face != NO_FACE).sum(axis=1)
    usual = int(np.argmax(np.bincount(count[count > 0]))) if np.any(count > 0) else 0
    return int(np.argmin(np.where(count == usual, abs(held.total_n - level_n), np.inf)))


def _frames_like(track: ContactTrack, frame: int, window: slice) -> Int[np.ndarray, "some"]:
    """Return the frames of a window with contacts on the same faces as in one of them."""
    alike = np.all(track.face == track.face[frame], axis=1)
    return np.arange(len(track))[window][alike[window]]


def _with_intervals(
    contacts: Placed,
    rng: np.random.Generator,
    figures: Callable[[Placed], dict[str, float]],
    draws: int = _DRAWS,
) -> dict[str, Reading]:
    """Medians and 90 % intervals of figures over what the contacts' covariance allows; figures of exact
    contacts without ends.

    A ratio or a length of a noisy vector is mostly larger than that of the vector's mean, which then
    lies below the interval: the median never does. Of what is truly 0 it is about one deviation.
    """
    if not contacts.covariance.any():
        return {name: Reading(value) for name, value in figures(contacts).items()}
    drawn = [figures(near_by) for near_by in _draws(contacts, rng, draws)]
    values = {name: np.sort([figures_of[name] for figures_of in drawn]) for name in drawn[0]}
    return {name: Reading(float(v[len(v) // 2]), *_ends(v)) for name, v in values.items()}


def _ends(ordered: Float[np.ndarray, "draw"]) -> tuple[float, float]:
    """Ends that 90 % of further draws lie between."""
    pairs = len(ordered) // 2
    # k of n pairs farther away leave out (k + 1)/(n + 1) of further ones
    farther = (pairs + 1) // 10 - 1
    return float(ordered[farther]), float(ordered[-1 - farther])


def _draws(contacts: Placed, rng: np.random.Generator, count: int = _DRAWS) -> list[Placed]:
    numbers = rng.standard_normal((count // 2, 5 * len(contacts) + 1))
    # in pairs of opposite errors about the contacts themselves: medians of even figures are theirs
    pairs = np.concatenate([np.zeros_like(numbers[:1]), numbers, -numbers])
    return contacts.drawn(pairs[:, :-1].reshape(len(pairs), -1, 5), pairs[:, -1])


def _peak_figures(conditions: Conditions, jaws: bool, contacts: Placed) -> dict[str, float]:
    skin = conditions.skin
    strength = {"grasp_n": float(np.mean(side_forces_n(contacts, grasp_axis(contacts))))}
    if jaws:  # the skin is known under round tips alone
        return strength | dict.fromkeys(("pressure_mpa", "depth_mm", "energy_mj"), UNKNOWN)
    return strength | {
        "pressure_mpa": float(skin.pressure_mpa(contacts).max(initial=0.0)),
        "depth_mm": float(skin.depth_mm(contacts).max(initial=0.0)),
        "energy_mj": float(skin.energy_mj(contacts).sum()),
    }


def _hold_figures(conditions: Conditions, contacts: Placed) -> dict[str, float]:
    wrench = net_wrench(contacts)
    return {
        "net_force_n": float(np.linalg.norm(wrench[:3])),
        "net_moment_nmm": float(np.linalg.norm(wrench[3:])),
        "asymmetry": asymmetry(contacts, grasp_axis(contacts)),
        "friction_used": friction_used(contacts.force_n),
        "friction_needed": closing_friction(
            contacts.point_mm, contacts.axes, _patch_mm(conditions, contacts)
        ),
    }


def _hull_figures(conditions: Conditions, contacts: Placed) -> dict[str, float]:
    patch = _patch_mm(conditions, contacts)
    reach = float(np.linalg.norm(contacts.point_mm, axis=1).max())
    point, axes = contacts.point_mm, contacts.axes
    hull = wrench_space(contact_wrenches(point, axes, conditions.friction, patch, reach))
    return {"closed": float(hull.closed), "epsilon": hull.epsilon, "volume": hull.volume}


def _patch_mm(conditions: Conditions, contacts: Placed) -> float:
    return float(conditions.skin.patch_radius_mm(contacts).mean())


def _balance_chance(
    contacts: Placed,
    wrench: np.ndarray,
    covariance: np.ndarray,
    conditions: Conditions,
    pull: Float[np.ndarray, "3"],
) -> float:
    """NaN where forces count as exact: then nothing balances exactly.

    The weight pulls by `pull`, of an accelerated object with what that takes; where it is NaN, in whatever
    direction balances best.
    """
    if not contacts.covariance.any():
        return UNKNOWN
    force, weight_n = wrench[:3], conditions.weight_n
    if np.isfinite(pull).all():
        force, weight_n = force + weight_n * pull, 0.0
    return equilibrium_p(equilibrium_misfit(force, covariance[:3, :3], weight_n), weight_n)


def _spread(value: float, sigma: float) -> Reading:
    """A force with its normal interval, none below 0."""
    if not sigma > 0:
        return Reading(value)
    return Reading(value, max(0.0, value - _HALF * sigma), value + _HALF * sigma)


def _face_forces(part: ContactTrack, hold: slice) -> dict[int, tuple[Reading, Reading]]:
    """Mean in the hold and peak in the grasp, each with its interval."""
    forces = {}
    for face in np.unique(part.face[part.face != NO_FACE]).tolist():
        force, sigma = part.face_force_n(face), part.face_sigma_n(face)
        mean, peak = (
            _spread(float(force[some].mean()), _sigma_of_mean(force[some], sigma[some]))
            for some in (hold, peak_frames(force, hold))
        )
        forces[face] = mean, peak
    return forces


def _sigma_of_mean(values: Float[np.ndarray, "frame"], sigma: Float[np.ndarray, "frame"]) -> float:
    """Standard deviation of a mean: as `ContactTrack.averaged`, of a sum over contacts."""
    return float(np.sqrt(variance_of_mean(np.asarray(np.mean(sigma**2)), values)))


def _course(held: ContactTrack, closing: ContactTrack, faces: list[int]) -> dict[str, float]:
    """Figures of the course of the force and of the contacts."""
    total, time_s = held.total_n, held.time_s
    centres = [_steady_centre_mm(held, face) for face in faces]
    slips = [contact_slip(time_s, centre) for centre in centres]
    # noise moves every centre: what did not slip has gone no way
    ways = [slip.distance_mm * slip.slipped for slip in slips if np.isfinite(slip.distance_mm)]
    # of the farthest slip: the earliest of several noisy onsets would be too early
    farthest = max((s for s in slips if s.slipped), key=lambda s: s.distance_mm, default=None)
    sliding = [centre for slip, centre in zip(slips, centres, strict=True) if slip.slipped]
    onset = common_onset_s(time_s, sliding)
    if np.isnan(onset) and farthest is not None:
        onset = farthest.onset_s
    return {
        "loading_n_per_s": loading_rate_n_per_s(closing.time_s, closing.total_n),
        "hold_s": float(time_s[-1] - time_s[0]),
        "creep": creep_per_decade(time_s, total),
        "unsteadiness": unsteadiness(total),
        "slip_mm": max(ways, default=UNKNOWN),
        "slip_onset_s": onset - float(time_s[0]),
        "slip_n": float(total[time_s <= onset].mean()) if np.isfinite(onset) else UNKNOWN,
    }


def _steady_centre_mm(held: ContactTrack, face: int) -> Float[np.ndarray, "frame 2"]:
    """Centre of force on a face in frames with its usual number of contacts, NaN in others: one that is
    missed for a while moves the centre, and nothing slips."""
    count = np.sum(held.face == face, axis=1)
    if not count.any():
        return np.full((len(held), 2), np.nan)
    usual = np.argmax(np.bincount(count[count > 0]))
    return np.where((count == usual)[:, None], held.face_centre_mm(face), np.nan)


def _damage(
    top: ContactTrack,
    at_peak: Placed,
    conditions: Conditions,
    pull: Float[np.ndarray, "3"],
    rng: np.random.Generator,
) -> tuple[dict[str, Reading], list[dict[str, float | int]]]:
    slots = np.flatnonzero(np.isin(top.face[0], list(conditions.faces))).tolist()
    columns = top.face[0, slots], *top.xy_mm[0, slots].T, top.normal_n[0, slots]
    places: list[dict[str, float | int]] = [
        dict(zip(("face", "x_mm", "y_mm", "force_n"), row, strict=True))
        for row in zip(*(column.tolist() for column in columns), strict=True)
    ]
    readings: dict[str, Reading] = {}
    drawn, held = _draws(at_peak, rng), (conditions.friction, conditions.weight_n, pull)
    numbers = rng.standard_normal((len(drawn) // 2, 3))
    pairs = np.concatenate([np.zeros((1, 3)), numbers, -numbers])
    balanced = drawn_in_balance(at_peak, drawn, pairs, *held)
    forces = np.array([contacts.force_n[:, 2] for contacts in balanced])
    for limit in conditions.limits:
        whole, each = damage_probability(limit, forces, conditions.tip_radius_mm)
        # the mean is the chance; where a few draws carry it, it lies beyond the ends and becomes one
        mean, (low, high) = float(whole.mean()), _ends(np.sort(whole))
        readings[f"damage_{limit.name}"] = Reading(mean, min(mean, low), max(mean, high))
        for place, chance in zip(places, each.tolist(), strict=True):
            place[f"damage_{limit.name}"] = chance
    return readings, places


def _is_opposed(held: Placed) -> bool:
    """Return whether contacts lie on two opposite sides and nowhere else."""
    share = held.inward @ grasp_axis(held)
    return bool(np.all(abs(share) > 0.9) and (share > 0).any() and (share < 0).any())
