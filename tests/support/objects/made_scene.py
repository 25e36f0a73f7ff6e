"""Scenes of made-up numbers: a cube whose presses are dents of a closed form, without any solver."""

from pathlib import Path

import numpy as np
import trimesh

from design.layout.body import face_frames
from design.layout.places.contact_grid import contact_grid
from design.layout.places.positions import live_channels
from instobj.viewer.archive import Stepped, pack, stepped
from instobj.viewer.scene import add_surface, object_scene
from instobj.viewer.surface import links_of, shaded
from tests.support.pictures import save_dot

DEPTHS_MM = np.array([1.0, 2.0, 3.0])
_DENT_MM = 5.0


def write_made_scene(spec, folder: Path, stiffness_n_per_mm: float = 2.0) -> dict[str, np.ndarray]:
    """Write `scene.bin` and `object.png`; returns forces, counts and bounds that the page should show.

    Forces are `stiffness` times depth, times one more for every face; counts tell face, place and step.
    """
    spec_faces, xy = face_frames(spec), contact_grid(spec).xy_mm
    core = trimesh.creation.box([edge - 2 * spec.shell.thickness_mm for edge in spec.body.size_mm])
    core.export(folder / "core.stl")
    content, arrays = object_scene(spec, folder)
    content["face_vertices"] = _add_dents(spec, spec_faces, xy, arrays)
    faces, sensors = len(spec_faces), len(arrays["sensor_face"])
    above = np.column_stack([xy, np.zeros(len(xy))])
    arrays["place_xy_mm"] = xy.astype("<f4")
    arrays["place_mm"] = np.stack([f.to_object(above) for f in spec_faces]).astype("<f4")
    arrays["place_axes"] = stepped(np.stack([f.axes_at(xy) for f in spec_faces]), "i2")
    told = made_numbers(faces, len(xy), sensors, stiffness_n_per_mm)
    arrays["force_n"] = told["force_n"].astype("<f4")
    arrays["counts"] = Stepped(told["counts"].astype("<i2"))
    arrays["live"] = live_channels(spec).astype("<u1")
    motion = np.zeros((faces, len(xy), 1, len(arrays["magnet_face"]), 3))
    arrays["motion_mm"] = arrays["motion_rad"] = stepped(motion, "i1")
    arrays["ellipse_mm2"] = np.stack(
        [told["bound_mm"] ** 2, 0 * told["bound_mm"], told["bound_mm"] ** 2 / 4], axis=-1
    ).astype("<f4")
    arrays["map_bound"] = told["bound_mm"].astype("<f4")
    grid = contact_grid(spec)
    content |= {
        "press": {
            "depth_mm": DEPTHS_MM.tolist(),
            "shown_steps": [2],
            "noise_counts": [4.0, 4.0, 6.0],
            "counts_per_mt": 100.0,
            "force_error": [0.01, 0.02, 0.03],
        },
        "maps": [
            {"stem": "bound", "title": "Position bound", "unit": "mm", "log": True, "weak": "high",
             "force_n": 2.0}
        ],
        "grid": {"x_mm": grid.x_mm.tolist(), "y_mm": grid.y_mm.tolist()},
    }  # fmt: skip
    (folder / "scene.bin").write_bytes(pack(content, arrays))
    save_dot(folder / "object.png")
    return told


def made_numbers(faces, places, sensors, stiffness_n_per_mm):
    """Forces (face, place, step), counts (…, sensor, axis), position bounds (face, place)."""
    face, place, step = np.meshgrid(*map(np.arange, (faces, places, len(DEPTHS_MM))), indexing="ij")
    counts = 100 * face[..., None, None] + 10 * place[..., None, None] + step[..., None, None]
    signs = np.array([1, -2, 3]) * (1 + np.arange(sensors)[:, None])
    return {
        "force_n": stiffness_n_per_mm * DEPTHS_MM[step] * (1 + face),
        "counts": counts * signs,
        "bound_mm": 0.1 * stiffness_n_per_mm * (1 + face + 0.1 * place)[..., 0],
    }


def _add_dents(spec, faces, xy_mm, arrays) -> list[int]:
    """A finely divided box, pushed in as exp(−r²/w²) of the distance to the place."""
    box = trimesh.creation.box(spec.body.size_mm)
    for _ in range(4):
        box = box.subdivide()
    points = np.asarray(box.vertices)
    surface = shaded(points, np.asarray(box.faces))
    add_surface(arrays, "silicone", surface)
    local = [frame.plane_coordinates(points) for frame in faces]
    on_face = [np.flatnonzero(abs(one[:, 2]) < 1e-6) for one in local]
    normals = np.concatenate(
        [np.tile(f.normal, (len(v), 1)) for f, v in zip(faces, on_face, strict=True)]
    )
    links = links_of(surface.source, np.concatenate(on_face), normals)
    arrays["link_vertex"] = links.picture.astype("<u4")
    arrays["link_source"] = links.face.astype("<u4")
    arrays["link_mm"] = stepped(links.vector, "i1")
    first = np.cumsum([0, *map(len, on_face)])
    shape = np.zeros((len(faces), 1, first[-1], len(xy_mm)))
    for k, there in enumerate(on_face):
        away = local[k][there][:, None, :2] - xy_mm
        shape[k, 0, first[k] : first[k + 1]] = np.exp(-(away**2).sum(axis=-1) / _DENT_MM**2)
    arrays["shape"] = stepped(shape, "i1")
    return [len(there) for there in on_face]
