"""Counts of the simulated object beside those of joint contact mechanics with the exact field."""

import numpy as np

from design.layout.body import face_frame
from estimator.field.models import exact_model
from estimator.signals.field_setup import counts, scene, sensed_field


def solved_changes(spec, motion):
    """Changes of counts (press, sensor, 3) under motions (press, magnet, 6) of the magnets."""
    around = scene(spec)
    still = np.concatenate([np.zeros_like(motion[:1]), motion])
    read = counts(around, sensed_field(around, still, exact_model(spec.magnets)), spec)
    return read[1:] - read[0]


def simulated_changes(hall, press):
    """Changes of counts (sensor, 3) that the simulated object reads of a joint press, shear included."""
    frames = [face_frame(hall.spec, tip.face) for tip in press.tips]
    # tips are placed by lengths along a curved surface
    places = [
        frame.to_plane(np.array([tip.x_mm, tip.y_mm]))
        for frame, tip in zip(frames, press.tips, strict=True)
    ]
    points = [
        frame.to_object(np.append(place, 0.0)) for frame, place in zip(frames, places, strict=True)
    ]
    in_faces_n = np.column_stack([press.shear_n, -press.force_n])
    forces_n = [
        frame.axes_at(place) @ force
        for frame, place, force in zip(frames, places, in_faces_n, strict=True)
    ]
    return hall.read(np.array(points), np.array(forces_n)) - hall.rest_counts


def share_of_error(simulated, solved):
    """Root mean square of the difference over that of the change."""
    return float(np.sqrt(np.mean((simulated - solved) ** 2) / np.mean(solved**2)))
