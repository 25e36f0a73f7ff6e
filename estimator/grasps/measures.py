"""Measures of each grasp of a track, with intervals by the estimator's covariance."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float
from scipy.stats import norm

from design.body.surface_chart import FaceFrame
from estimator.frames.dataset import NO_FACE
from estimator.grasps.balance import (
    asymmetry,
    equilibrium_misfit,
    equilibrium_p,
    grasp_axis,
    net_wrench,
    side_forces_n,
)
from estimator.grasps.damage import (
    DamageLimit,
    Sphere,
    damage_probability,
    energy_mj,
    patch_radius_mm,
)
from estimator.grasps.holding import (
    contact_slip,
    creep_per_decade,
    loading_rate_n_per_s,
    unsteadiness,
)
from estimator.grasps.phases import Grasp, find_grasps
from estimator.grasps.track import ContactTrack, Placed, placed_contacts
from estimator.grasps.wrench_space import (
    closing_friction,
    contact_wrenches,
    friction_used,
    wrench_space,
)

INTERVAL = (5.0, 95.0)
"""Percentiles of an interval: 90 %."""
_HALF = float(norm.ppf(INTERVAL[1] / 100))
DRAWS = 32
"""Draws of what the covariance allows: ends of an interval to some 15 % of its width."""
UNKNOWN = float("nan")


@dataclass(frozen=True)
class Conditions:
    """Facts of the object and of the test.

    Attributes
    ----------
    faces : of the object, by number
    skin : its silicone under the gripper's tip, for Hertz
    tip_radius_mm : of the gripper's tips
    friction : between gripper and object, assumed
    weight_n : of the object; 0 where it is not known or borne otherwise
    limits : of damage
    """

    faces: Mapping[int, FaceFrame]
    skin: Sphere
    tip_radius_mm: float
    friction: float = 0.5
    weight_n: float = 0.0
    limits: tuple[DamageLimit, ...] = ()


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


def measured_grasps(track: ContactTrack, conditions: Conditions) -> list[MeasuredGrasp]:
    """Measure every grasp of a track; none where nothing was grasped."""
    grasps = find_grasps(track.time_s, track.total_n)
    return [_measured(track, grasp, conditions) for grasp in grasps]


def _measured(track: ContactTrack, grasp: Grasp, conditions: Conditions) -> MeasuredGrasp:
    whole, hold = track.select(slice(grasp.start, grasp.end)), slice(grasp.hold, grasp.release)
    rng = np.random.default_rng(grasp.number)
    peak = grasp.start + int(np.argmax(whole.total_n))
    at_peak = placed_contacts(track, peak, conditions.faces)
    held = placed_contacts(track, _typical_frame(track, grasp), conditions.faces)
    wrench, covariance = net_wrench(held, conditions.friction)
    damage, places = _damage(track, peak, at_peak, conditions, rng)
    faces = _face_forces(track, grasp)
    readings = {
        **_forces(track, grasp, faces, at_peak, rng),
        **_balance(held, wrench, covariance, conditions, rng),
        **_closure(held, conditions, rng),
        **_hold(track.select(hold), faces),
        "loading_n_per_s": Reading(
            loading_rate_n_per_s(*_closing(track, grasp))
        ),
        "regrasps": Reading(float(grasp.regrasps)),
        "energy_mj": _drawn_reading(at_peak, rng, lambda c: _energy(c, conditions)),
        "unexplained": Reading(float(np.mean(~whole.explained))),
        **damage,
    }  # fmt: skip
    return MeasuredGrasp(
        grasp,
        float(track.time_s[grasp.start]),
        float(track.time_s[grasp.end - 1]),
        readings,
        faces,
        wrench,
        covariance,
        _is_opposed(held),
        places,
    )


def _typical_frame(track: ContactTrack, grasp: Grasp) -> int:
    """Frame of the hold with the usual number of contacts, whose force is nearest to the level."""
    part = track.select(slice(grasp.hold, grasp.release))
    count = (part.face != NO_FACE).sum(axis=1)
    usual = int(np.argmax(np.bincount(count[count > 0]))) if np.any(count > 0) else 0
    away = np.where(count == usual, abs(part.total_n - grasp.level_n), np.inf)
    return grasp.hold + int(np.argmin(away))


def _closing(track: ContactTrack, grasp: Grasp) -> tuple[np.ndarray, np.ndarray]:
    """Times and total forces from the last free frame into the hold."""
    frames = slice(max(grasp.approach, grasp.start - 1), min(grasp.hold + 2, grasp.end))
    return track.time_s[frames], track.total_n[frames]


def _draws(contacts: Placed, rng: np.random.Generator) -> list[Placed]:
    return [contacts.drawn(rng.standard_normal((len(contacts), 5))) for _ in range(DRAWS)]


def _drawn_reading(
    contacts: Placed, rng: np.random.Generator, figure: Callable[[Placed], float]
) -> Reading:
    """A figure of contacts and the interval of its draws; NaN without contacts."""
    if not len(contacts):
        return Reading(UNKNOWN)
    value = figure(contacts)
    if not contacts.covariance.any():
        return Reading(value)
    figures = np.array([figure(drawn) for drawn in _draws(contacts, rng)])
    if not np.isfinite(figures).all() and not np.isnan(figures).all():
        # ∞ is an answer (no friction closes the grasp), and percentiles must not interpolate to it
        low, high = np.percentile(figures, INTERVAL, method="nearest")
    else:
        low, high = np.percentile(figures, INTERVAL)
    return Reading(value, float(low), float(high))


def _spread(value: float, sigma: float) -> Reading:
    """A force with its normal interval, none below 0."""
    if not sigma > 0:
        return Reading(value)
    return Reading(value, max(0.0, value - _HALF * sigma), value + _HALF * sigma)


def _face_forces(track: ContactTrack, grasp: Grasp) -> dict[int, tuple[Reading, Reading]]:
    """Mean in the hold and peak in the grasp; errors are taken to last as long as the grasp."""
    forces = {}
    part = track.select(slice(grasp.start, grasp.end))
    held = slice(grasp.hold - grasp.start, grasp.release - grasp.start)
    for face in np.unique(part.face[part.face != NO_FACE]).tolist():
        force = part.face_force_n(face)
        sigma = np.sqrt(np.where(part.face == face, part.covariance[..., 4, 4], 0.0).sum(axis=1))
        peak = int(np.argmax(force))
        mean = _spread(float(force[held].mean()), float(sigma[held].mean()))
        forces[face] = (mean, _spread(float(force[peak]), float(sigma[peak])))
    return forces


def _forces(
    track: ContactTrack,
    grasp: Grasp,
    faces: dict[int, tuple[Reading, Reading]],
    at_peak: Placed,
    rng: np.random.Generator,
) -> dict[str, Reading]:
    part = track.select(slice(grasp.start, grasp.end))
    held = track.select(slice(grasp.hold, grasp.release))
    peak = int(np.argmax(part.total_n))
    strongest = max((peak for _, peak in faces.values()), key=lambda reading: reading.value)
    return {
        "peak_n": _spread(float(part.total_n[peak]), float(part.total_sigma_n[peak])),
        "mean_n": _spread(float(held.total_n.mean()), float(held.total_sigma_n.mean())),
        "finger_n": strongest,
        "grasp_n": _drawn_reading(
            at_peak, rng, lambda c: float(np.mean(side_forces_n(c, grasp_axis(c))))
        ),
    }


def _balance(
    held: Placed,
    wrench: np.ndarray,
    covariance: np.ndarray,
    conditions: Conditions,
    rng: np.random.Generator,
) -> dict[str, Reading]:
    force = wrench[:3]
    p_value = UNKNOWN
    if held.covariance.any():
        misfit = equilibrium_misfit(force, covariance[:3, :3], conditions.weight_n)
        p_value = equilibrium_p(misfit, conditions.weight_n)

    def size(part: slice) -> Callable[[Placed], float]:
        return lambda c: float(np.linalg.norm(net_wrench(c, conditions.friction)[0][part]))

    axis = grasp_axis(held) if len(held) else np.zeros(3)
    return {
        "net_force_n": _drawn_reading(held, rng, size(slice(0, 3))),
        "net_moment_nmm": _drawn_reading(held, rng, size(slice(3, 6))),
        "asymmetry": _drawn_reading(held, rng, lambda c: asymmetry(c, axis)),
        "equilibrium_p": Reading(p_value),
    }


def _closure(held: Placed, conditions: Conditions, rng: np.random.Generator) -> dict[str, Reading]:
    reach = float(np.linalg.norm(held.point_mm, axis=1).max(initial=1.0))

    def patch(contacts: Placed) -> float:
        return float(patch_radius_mm(contacts.force_n[:, 2], conditions.skin).mean())

    def space(contacts: Placed) -> tuple[float, float, float]:
        wrenches = contact_wrenches(
            contacts.point_mm, contacts.axes, conditions.friction, patch(contacts), reach
        )
        hull = wrench_space(wrenches)
        return float(hull.closed), hull.epsilon, hull.volume

    used = _drawn_reading(held, rng, lambda c: friction_used(c.force_n))
    needed = _drawn_reading(held, rng, lambda c: closing_friction(c.point_mm, c.axes, patch(c)))
    if not len(held):
        return dict.fromkeys(
            ("friction_used", "friction_needed", "closed", "epsilon", "volume"), used
        )
    drawn = np.array([space(contacts) for contacts in _draws(held, rng)])
    low, high = np.percentile(drawn, INTERVAL, axis=0)
    _, epsilon, volume = space(held)
    return {
        "friction_used": used,
        "friction_needed": needed,
        "closed": Reading(float(drawn[:, 0].mean())),
        "epsilon": Reading(epsilon, float(low[1]), float(high[1])),
        "volume": Reading(volume, float(low[2]), float(high[2])),
    }


def _hold(held: ContactTrack, faces: dict[int, tuple[Reading, Reading]]) -> dict[str, Reading]:
    total, time_s = held.total_n, held.time_s
    slips = [contact_slip(time_s, _steady_centre_mm(held, face)) for face in faces]
    # noise moves every centre: what did not slip has gone no way
    ways = [slip.distance_mm * slip.slipped for slip in slips if np.isfinite(slip.distance_mm)]
    onsets = [slip.onset_s for slip in slips if slip.slipped]
    onset = min(onsets, default=UNKNOWN)
    return {
        "hold_s": Reading(float(time_s[-1] - time_s[0])),
        "creep": Reading(creep_per_decade(time_s, total)),
        "unsteadiness": Reading(unsteadiness(total)),
        "slip_mm": Reading(max(ways, default=UNKNOWN)),
        "slip_onset_s": Reading(onset - float(time_s[0])),
        "slip_n": Reading(
            float(total[time_s <= onset].mean()) if onsets else UNKNOWN
        ),
    }  # fmt: skip


def _steady_centre_mm(held: ContactTrack, face: int) -> Float[np.ndarray, "frame 2"]:
    """Centre of force on a face in frames with its usual number of contacts, NaN in others: one that is
    missed for a while moves the centre, and nothing slips."""
    count = np.sum(held.face == face, axis=1)
    if not count.any():
        return np.full((len(held), 2), np.nan)
    usual = np.argmax(np.bincount(count[count > 0]))
    return np.where((count == usual)[:, None], held.face_centre_mm(face), np.nan)


def _energy(contacts: Placed, conditions: Conditions) -> float:
    return float(energy_mj(contacts.force_n[:, 2], conditions.skin).sum())


def _damage(
    track: ContactTrack,
    peak: int,
    at_peak: Placed,
    conditions: Conditions,
    rng: np.random.Generator,
) -> tuple[dict[str, Reading], list[dict[str, float | int]]]:
    slots = np.flatnonzero(np.isin(track.face[peak], list(conditions.faces)))
    places = [
        {
            "face": int(track.face[peak, slot]),
            "x_mm": float(track.xy_mm[peak, slot, 0]),
            "y_mm": float(track.xy_mm[peak, slot, 1]),
            "force_n": float(track.normal_n[peak, slot]),
        }
        for slot in slots
    ]
    readings: dict[str, Reading] = {}
    forces = np.array([contacts.force_n[:, 2] for contacts in _draws(at_peak, rng)])
    for limit in conditions.limits if len(at_peak) else ():
        whole, each = damage_probability(limit, forces, conditions.tip_radius_mm)
        readings[f"damage_{limit.name}"] = Reading(whole)
        for place, chance in zip(places, each.tolist(), strict=True):
            place[f"damage_{limit.name}"] = chance
    return readings, places


def _is_opposed(held: Placed) -> bool:
    """Return whether contacts lie on two opposite sides and nowhere else."""
    if len(held) < 2:
        return False
    share = held.inward @ grasp_axis(held)
    return bool(np.all(abs(share) > 0.9) and (share > 0).any() and (share < 0).any())
