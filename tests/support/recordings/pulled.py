"""Grasp-and-pull recordings of a magnetic skin by a model of their own: closed formulas, no specification.

Magnets lie in a half-space that a contact presses and pulls (Boussinesq and Cerruti, incompressible). Five
chips below see them as dipoles. The gripper pulls by a way; the contact sticks to the cone of friction.
"""

from dataclasses import dataclass

import numpy as np

RATE_HZ = 50.0
FRAMES, REST, CLOSED, OPENED = 170, 25, 45, 150
"""Frames of a recording, the last at rest, the last of closing, the first of opening where it opens."""
NOISE_UT = 1.0
_MODULUS_MPA, _PATCH_MM, _STIFF_N_PER_MM = 0.3, 2.5, 1.5
_MOMENT_A_MM2 = 100.0
"""Strength as weak as that of magnets of a printed skin, whose channels change by some 100 µT."""
_CHIPS_MM = np.array([[0, 0, -9.0], [7, 0, -9], [-7, 0, -9], [0, 7, -9], [0, -7, -9]])
_MAGNETS_MM = np.array([[x, y, -4.0] for x in (-6.0, 0.0, 6.0) for y in (-6.0, 0.0, 6.0)])


@dataclass(frozen=True)
class Pulled:
    """Recording (frame, 15) in µT, whether its contact slipped, when (s; NaN) and how far (mm)."""

    values: np.ndarray
    slipped: bool
    onset_s: float
    way_mm: float
    returns: bool


def sunk_mm(points, place, force):
    """Displacement (…, 3) at points of an incompressible half-space under a point force at its surface.

    u = (f/ρ + r (r·f)/ρ³)/(4πG) for ν = ½ (Johnson, Contact Mechanics, 1985, 3.2 and 3.6), the source
    raised by the patch's radius, so that nothing is singular.
    """
    away = points - np.append(place, _PATCH_MM)
    far = np.linalg.norm(away, axis=-1, keepdims=True)
    shear = _MODULUS_MPA / 3
    along = away * (away @ force)[..., None] / far**3
    return (force / far + along) / (4 * np.pi * shear)


def field_ut(magnets, moments):
    """Sum of the dipoles' flux density at the chips, (chip, 3) in µT; places in mm."""
    away = _CHIPS_MM[:, None] - magnets
    far = np.linalg.norm(away, axis=-1, keepdims=True)
    along = np.sum(away * moments, axis=-1, keepdims=True)
    # µ0/4π = 1e-7 T m/A; A mm² over mm³ is 1e3 A/m, so 1e-4 T, 100 µT
    return np.sum(100 * (3 * away * along / far**5 - moments / far**3), axis=1)


def pulled(seed, slips=None):
    """Recording of rest, closing, hold, and a pull that may be let go; both kinds are equally likely.

    Stiffness, friction and grip are the recording's own; slips below 0.3 mm count as none.
    """
    rng = np.random.default_rng([seed, 55])
    slips = bool(rng.integers(2)) if slips is None else slips
    moments = (
        np.array([0, 0, _MOMENT_A_MM2]) * rng.choice([-1, 1], (9, 1)) * rng.normal(1, 0.05, (9, 1))
    )
    time = np.arange(FRAMES) / RATE_HZ
    grip_n, friction = rng.uniform(2, 6), rng.uniform(0.4, 1.0)
    normal = grip_n * np.clip((np.arange(FRAMES) - REST) / (CLOSED - REST), 0, 1)
    # the skin creeps, the gripper's motor hunts
    normal *= 1 - 0.03 * np.log1p(np.clip(time - CLOSED / RATE_HZ, 0, None) / 0.1) / np.log(10)
    normal *= 1 + rng.uniform(0, 0.03) * np.sin(
        2 * np.pi * rng.uniform(0.5, 2) * time + rng.uniform(0, 6)
    )
    begin, lasts = rng.uniform(1.2, 1.7), rng.uniform(0.15, 0.8)
    limit_mm = friction * grip_n / _STIFF_N_PER_MM
    reach_mm = limit_mm * rng.uniform(0.3, 0.85) if not slips else limit_mm + rng.uniform(1.0, 4.0)
    returns = bool(rng.integers(2))
    ramp = np.clip((time - begin) / lasts, 0, 1)
    pull_mm = reach_mm * (3 * ramp**2 - 2 * ramp**3)
    if returns:
        pull_mm = pull_mm - reach_mm * np.clip((time - begin - lasts - 0.3) / 0.3, 0, 1)
    if rng.integers(2):  # let go at the end
        normal *= np.clip((OPENED + 10 - np.arange(FRAMES)) / 10, 0, 1)
    angle = rng.uniform(0, 2 * np.pi)
    turn = angle + rng.uniform(-0.25, 0.25) * ramp
    target = pull_mm[:, None] * np.stack([np.cos(turn), np.sin(turn)], axis=1)
    place = rng.uniform(-3, 3, 2)
    values, moved, onset, way = np.empty((FRAMES, 15)), np.zeros(2), np.nan, 0.0
    for frame in range(FRAMES):
        stretch = target[frame] - moved
        most = friction * normal[frame] / _STIFF_N_PER_MM
        size = np.linalg.norm(stretch)
        if size > most and frame > CLOSED:
            moved = moved + stretch * (1 - most / size)
            onset = time[frame] if np.isnan(onset) else onset
            way = np.linalg.norm(moved) if frame < OPENED else way
        force = np.append(_STIFF_N_PER_MM * (target[frame] - moved), -normal[frame])
        sunk = sunk_mm(_MAGNETS_MM, place + moved, force)
        values[frame] = field_ut(_MAGNETS_MM + sunk, moments).ravel()
    drift = np.cumsum(rng.normal(0, 0.05, values.shape), axis=0)
    noisy = values + drift + rng.normal(0, NOISE_UT, values.shape)
    return Pulled(noisy, bool(way > 0.3), onset if way > 0.3 else np.nan, float(way), returns)
