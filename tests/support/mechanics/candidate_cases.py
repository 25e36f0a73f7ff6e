"""Made-up, smooth motions of candidate magnets, and the ordinary chain on them for one layout."""

import numpy as np
import torch

from design.layout.body import core_frames, face_frames
from design.layout.places.contact_grid import (
    contact_grid,
    grid_places_in_lattice,
    press_lattice,
)
from design.layout.places.positions import (
    MagnetLayout,
    SensorLayout,
    chip_on_board,
    sinks_of_boards_mm,
)
from design.layout.pockets import board_frame, tilted_frame
from design.spec.object import ContactGridSpec, ObjectSpec
from estimator.field.environment import environment
from estimator.field.models import exact_model
from estimator.information.fisher import cramer_rao_bounds, disturbance_counts
from estimator.layouts.batch import Layouts
from estimator.layouts.surfaces import clamp_to_patch_mm
from estimator.signals.field_setup import Scene, sensed_field
from estimator.signals.hall import chip_errors, counts_of_field
from estimator.signals.interpolation import signal_gradient
from estimator.signals.presses import Signals
from fem.candidates.motions import (
    CandidateMotions,
    Influence,
    candidate_lattices,
)
from fem.candidates.presses import compressed
from tests.support.disturbed_inputs import disturbed

FACE = 3
"""Its x is −z and its y is +y: a mix-up of axes shows."""

SHARES = np.array([0.8, 1.2])
LINEAR = 1e-3
"""Of real motions, and of real noise: signals are linear in the first, bounds and δ the same."""


def made_up_spec(body=None):
    """Places 5 × 4 of the paper's cube, or those of a body; little noise, different on all axes of a chip,
    and as little of Earth's field."""
    spec = body or ObjectSpec(name="cube", contact_grid=ContactGridSpec(count=(5, 4), pitch_mm=6.0))
    noise = tuple(LINEAR * counts for counts in (22.0, 15.0, 11.0))
    update = {"noise_counts": noise, "zeroing_counts": 10 * LINEAR}
    earth = {"earth_field_ut": LINEAR * spec.tolerances.earth_field_ut}
    return spec.model_copy(
        update={
            "sensors": spec.sensors.model_copy(update=update),
            "tolerances": spec.tolerances.model_copy(update=earth),
        }
    )


def made_up_motions(spec, pitch_mm=2.0):
    """In proportion to force; silicone goes down, aside and tilts near a press."""
    lattices, frames = candidate_lattices(spec, pitch_mm), face_frames(spec)
    places = press_lattice(spec)
    points = np.concatenate([in_object(f, one) for f, one in zip(frames, lattices, strict=True)])
    motion = []
    for frame in frames:
        local, (x, y, normal) = frame.plane_coordinates(points), frame.axes.T
        away = local[:, None, :2] - places.xy_mm
        near = LINEAR * np.exp(-np.sum(away**2, -1) / 90 + local[:, 2:] / 9)
        # shift and turn for each mm away along x and y, and for all of it
        ways = [
            [*(0.05 * x), *(0.012 * y)],
            [*(0.05 * y), *(-0.012 * x)],
            [*(-0.35 * normal), 0, 0, 0],
        ]
        weights = np.stack([near * away[..., 0], near * away[..., 1], near], axis=-1)
        motion.append(np.float32(disturbed(weights @ np.array(ways), frame.number)))
    force = spec.score.force_n * np.ones((len(frames), len(places), 1)) * SHARES
    return table_of(spec, lattices, force, motion)


def table_of(spec, lattices, force_n, per_share):
    """Presses whose motions (candidate, place, 6), of each face, grow with the share of the force."""
    faces = np.array([frame.number for frame in face_frames(spec)])
    parts = [compressed(motion.transpose(0, 2, 1), 1e-7) for motion in per_share]
    modes = max(mode.shape[1] for _, mode in parts)
    by_candidate = np.zeros((len(per_share[0]), len(faces), modes, 6), np.float32)
    presses = np.zeros((*force_n.shape, modes), np.float32)
    for row, (rows, mode) in enumerate(parts):
        by_candidate[:, row, : mode.shape[1]] = rows
        presses[row, :, :, : mode.shape[1]] = mode[:, None] * SHARES[:, None]
    deepest = 1.5 * force_n.max(axis=2)
    places = press_lattice(spec)
    return CandidateMotions(
        faces,
        places,
        force_n,
        force_n / 2,
        deepest,
        lattices,
        by_candidate,
        presses,
        0.0,
        np.zeros((len(by_candidate), modes, 5), np.float32),
        no_influence(lattices[0].depth_mm),
    )


def no_influence(depth_mm):
    """Of magnets on each other."""
    values = np.zeros((len(depth_mm), len(depth_mm), 3, 6, 5), np.float32)
    return Influence(depth_mm, 6.0, 1.0, values)


def at_contacts(spec, of_lattice):
    """Of the places of the lattice of presses, the contact locations."""
    return of_lattice[grid_places_in_lattice(spec)]


def motion_of(table):
    """(face, place, step, candidate, 6) of a table."""
    return np.einsum("fpsr,cfrv->fpscv", table.presses, table.by_candidate, optimize=True)


def in_object(frame, lattice):
    """Candidates of a face; those beyond a round patch go on as its ends do."""
    xy = clamp_to_patch_mm(frame, frame.to_plane(lattice.xyd_mm[:, :2]))
    return frame.to_object(np.column_stack([xy, -lattice.xyd_mm[:, 2]]))


def random_layouts(count, seed=0, dtype=torch.float32):
    """Five magnets and three sensors each, tilted, of both polarities."""
    rng = np.random.default_rng(seed)
    xy, depth = rng.uniform(-15, 15, (count, 5, 2)), rng.uniform(2, 4, (count, 5, 1))
    azimuth = np.deg2rad(rng.uniform(0, 120, (count, 1)) + 120 * np.arange(3))
    radius = rng.uniform(6, 11, (count, 3, 1))
    parts = (
        np.concatenate([xy, depth], axis=-1),
        rng.normal(0, 0.1, (count, 5, 2)),
        rng.choice([-1.0, 1.0], (count, 5)),
        radius * np.stack([np.cos(azimuth), np.sin(azimuth)], axis=-1),
    )
    return Layouts(*(torch.as_tensor(part, dtype=dtype) for part in parts))


def ordinary_chain(spec, motions, face, layouts, row):
    """Bounds, signals at the score's force and rest counts by scene, interpolation and Fisher."""
    magnet_mm, turn, polarity, sensor_mm = (
        np.asarray(getattr(layouts, name)[row].detach(), float)
        for name in ("magnet_mm", "turn_rad", "polarity", "sensor_mm")
    )
    scene, motion = layout_scene(spec, motions, face, magnet_mm, turn, polarity, sensor_mm)
    return chain_of_scene(spec, motions, face, scene, motion)


def chain_of_scene(spec, motions, face, scene, motion):
    """The same of a scene whose sensors are the face's own, with the motions (place, step, body, 6) of what
    moves in it."""
    rest = counts_of_scene(spec, scene, np.zeros_like(motion[:1, 0]))[0]
    index = motions.faces.tolist().index(face)
    delta = np.zeros((len(motions.faces), *motion.shape[:2], *rest.shape))
    delta[index] = counts_of_scene(spec, scene, motion) - rest
    depth = np.array([1.0, 2.0])
    signals = Signals(motions.faces, motions.places, depth, motions.force_n, delta, rest)
    xy = contact_grid(spec).xy_mm
    force = np.full(len(xy), spec.score.force_n)
    found = signal_gradient(signals, np.full(len(xy), face), xy[:, 0], xy[:, 1], force)
    sigma = disturbance_counts(spec.sensors, "fresh", found.counts.shape[1])
    return cramer_rao_bounds(found.jacobian, sigma), found.counts, rest


def counts_of_scene(spec, scene, motion):
    """Counts (…, sensor, 3) where what moves has moved by (…, body, 6), by exact fields."""
    flat = motion.reshape(-1, *motion.shape[-2:])
    field = 1e3 * sensed_field(scene, flat, exact_model(spec.magnets))
    found = counts_of_field(field, scene.sensors.axes, spec.sensors)
    return found.reshape(*motion.shape[:-2], -1, 3)


def layout_scene(spec, motions, face, magnet_mm, turn, polarity, sensor_mm):
    centre, axis, faces, motion = [], [], [], []
    for frame in face_frames(spec):
        centre.append(frame.to_object(magnet_mm * [1, 1, -1]))
        axes = frame.axes_at(magnet_mm[:, :2])
        tilts = [tilted_frame(*np.rad2deg(t))[:, 2] for t in turn]
        axis.append(np.einsum("mij,mj->mi", axes, tilts))
        faces.append(np.full(len(magnet_mm), frame.number))
        index = motions.faces.tolist().index(face)
        along = frame.from_plane(magnet_mm[:, :2])
        motion.append(motions_at(motions, frame.number, along, magnet_mm[:, 2])[index])
    axis = np.concatenate(axis)
    strength = np.tile(polarity, len(faces))
    size = np.resize(spec.magnets.size_numbers, len(strength))
    magnets = MagnetLayout(
        np.concatenate(centre), axis, np.concatenate(faces), axis, strength, size
    )
    core = core_frames(spec)[spec.body.sensed.index(face)]
    azimuth = np.arctan2(sensor_mm[:, 1], sensor_mm[:, 0])
    sink = sinks_of_boards_mm(spec, core, np.column_stack([sensor_mm, azimuth]))
    depth = -spec.sensors.depth_below_core_face_mm - sink
    axes = core.axes_at(sensor_mm)
    boards = [one @ board_frame(turn) for one, turn in zip(axes, azimuth, strict=True)]
    sensors = SensorLayout(
        core.to_object(np.column_stack([sensor_mm, depth])),
        np.stack([(board @ chip_on_board(spec.sensors)).T for board in boards]),
        np.full(len(sensor_mm), face),
    )
    chips = chip_errors(spec.sensors, len(sensor_mm), 1)
    return Scene(magnets, sensors, chips, environment(spec)), np.concatenate(motion, axis=2)


def motions_at(table, face, xy_mm, depth_mm):
    """Motions of magnets among a face's candidates, in all presses: (face, place, step, magnet, 6)."""
    index, weight = table.weights(face, np.column_stack([xy_mm, depth_mm]))
    # m magnet, k of its 64 candidates, f pressed face, r mode, v of 6 motions; p place, s step
    mixed = np.einsum("mk,mkfrv->mfrv", weight, table.by_candidate[index])
    return np.einsum("fpsr,mfrv->fpsmv", table.presses, mixed, optimize=True)
