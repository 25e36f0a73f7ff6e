"""A response operator in closed form: five faces of one half-space each, magnets that follow smoothly.

Contact between tips of one face is then Hertz's with Boussinesq's interaction; faces do not feel
each other except through `between_faces`.
"""

import numpy as np

from design.layout.body import face_frames
from design.layout.places.positions import shell_body_layout
from fem.contact.half_space import normal_compliance
from fem.contact.refined import hat_patches
from fem.linear.response import FaceSurface, ResponseOperator

DECAY_MM = 6.0


def half_space_response(spec, vertices=19, between_faces=0.0) -> ResponseOperator:
    """Every face a square grid of vertices; a force sinks magnets by a Gaussian of the distance."""
    surfaces = [
        _surface(frame.number, spec.body.size_mm[0], vertices) for frame in face_frames(spec)
    ]
    hats = hat_patches(surfaces[0])
    constants = (spec.silicone.youngs_modulus_mpa, spec.silicone.poisson_ratio)
    own = normal_compliance(hats, hats, *constants)
    count, faces = len(own), len(surfaces)
    layout = shell_body_layout(spec)
    bodies = len(layout.face)
    compliance = np.zeros((faces * count + 6 * bodies,) * 2)
    stiffness = 1 / own.sum()
    for i in range(faces):
        for j in range(faces):
            block = own if i == j else between_faces * stiffness * np.outer(own.sum(1), own.sum(1))
            compliance[i * count : (i + 1) * count, j * count : (j + 1) * count] = block
    for frame, surface in zip(face_frames(spec), surfaces, strict=True):
        (mine,) = np.nonzero(np.asarray(layout.face) == frame.number)
        place = frame.from_object(layout.centre_mm[mine])[:, :2]
        away = place[:, None] - surface.xy_mm
        sink = 0.02 * hats.area_mm2 * np.exp(-np.sum(away**2, axis=2) / 2 / DECAY_MM**2)
        tilt = np.stack([-away[..., 1], away[..., 0]], -1) * sink[..., None] / DECAY_MM**2
        columns = slice((frame.number - 1) * count, frame.number * count)
        for row, body in enumerate(mine):
            first = faces * count + 6 * body
            motion = -np.outer(frame.normal, sink[row])
            turn = frame.axes[:, :2] @ tilt[row].T
            compliance[first : first + 6, columns] = np.vstack([motion, turn])
    return ResponseOperator(tuple(surfaces), compliance, 0, 0)


def _surface(number, edge_mm, vertices):
    line = np.linspace(-edge_mm / 2, edge_mm / 2, vertices)
    xy = np.stack(np.meshgrid(line, line, indexing="ij"), -1).reshape(-1, 2)
    index = np.arange(vertices**2).reshape(vertices, vertices)
    a, b, c, d = index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]
    lower, upper = np.stack([a, b, c], -1), np.stack([a, c, d], -1)
    return FaceSurface(number, xy, np.concatenate([lower.reshape(-1, 3), upper.reshape(-1, 3)]))
