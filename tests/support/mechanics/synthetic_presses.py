"""Smooth analytic presses for tests: a Gaussian dimple that shifts and tilts what is in the shell."""

import numpy as np

from design.layout.body import face_frames
from design.layout.places.contact_grid import PlaceGrid, press_lattice
from design.layout.places.positions import shell_body_layout
from design.spec.object import ObjectSpec
from fem.presses.results import MagnetMotions, PressForces

WIDTH_MM = 5.5


def synthetic_presses(
    spec: ObjectSpec, lattice: PlaceGrid | None = None
) -> tuple[PressForces, MagnetMotions]:
    """Every quantity is smooth in x, y and force, and no symmetry of the cube is kept."""
    lattice = lattice or press_lattice(spec)
    depth = np.asarray(spec.press.depths_mm)
    faces = np.arange(1, 6)
    force = force_n(faces[:, None, None], lattice.xy_mm[None, :, None, :], depth)
    motion = np.stack(
        [
            face_motion(spec, face, lattice.xy_mm[:, None, :], force[face - 1])
            for face in range(1, 6)
        ]
    )
    area = 8 * depth * np.ones_like(force)
    return PressForces(faces, lattice, depth, force, area), MagnetMotions(
        faces, lattice, depth, motion
    )


def force_n(face, xy_mm, depth_mm):
    """Hertz-like with a stiffness that varies smoothly over the face (N)."""
    x, y = xy_mm[..., 0] / 15, xy_mm[..., 1] / 15
    stiffness = 2.6 * (1 + 0.05 * face + 0.12 * x - 0.08 * y - 0.2 * x**2 - 0.15 * y**2)
    return stiffness * depth_mm**1.5 * (1 + 0.06 * depth_mm)


def face_motion(spec, face, xy_mm, force):
    """Motion (…, body, 6) of all bodies in the shell for presses at xy on a face (object's frame)."""
    frame = face_frames(spec)[face - 1]
    local = frame.from_object(shell_body_layout(spec).centre_mm)
    away = local[:, :2] - xy_mm[..., None, :]
    reach = np.exp(-np.sum(away**2, -1) / (2 * WIDTH_MM**2)) * np.exp((local[:, 2] + 2.5) / 9)
    press = (force / (1 + 0.01 * force))[..., None]
    down = -0.055 * press * reach
    sideways = 0.006 * press[..., None] * reach[..., None] * away * [1.0, 0.8]
    tilt = (down / WIDTH_MM**2)[..., None] * np.stack([-away[..., 1], 0.9 * away[..., 0]], -1)
    shift = np.concatenate([sideways, down[..., None]], -1) @ frame.axes.T
    turn = np.concatenate([tilt, 0.02 * down[..., None]], -1) @ frame.axes.T
    return np.concatenate([shift, turn], -1)


def coarse_spec(**changes) -> ObjectSpec:
    """A small contact grid and few depths, so that tests stay quick."""
    content = {
        "name": "synthetic",
        "contact_grid": {"count": (4, 5), "pitch_mm": 3.0},
        "press": {"depths_mm": (0.5, 1.0, 1.5, 2.0, 3.0, 4.0)},
        "search": {"forces_n": ()},
        **changes,
    }
    return ObjectSpec.model_validate(content)
