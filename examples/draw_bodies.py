"""Draw the bodies of some specifications cut open: silicone, core, magnets, sensor boards.

python examples/draw_bodies.py docs/bodies.png examples/ball.toml examples/handle.toml
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import trimesh

from design.build.parts import parts_of
from design.build.scene import magnet_halves
from design.layout.places.positions import magnet_layout
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from instobj.render.raster import camera_axes, depth_image

COLOURS = {
    "silicone": (0.93, 0.84, 0.68),
    "cut": (0.80, 0.36, 0.25),
    "core": (0.55, 0.66, 0.78),
    "north": (0.75, 0.15, 0.15),
    "south": (0.15, 0.25, 0.60),
}
STEP_MM = 0.6
"""Steps in depth that are drawn as lines."""

LIGHT = np.array([-0.45, 0.65, 0.62]) / np.linalg.norm([-0.45, 0.65, 0.62])


def triangles_of(spec: ObjectSpec) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Corners (triangle, 3, 3), outward normals and colours of the object, a quarter cut away."""
    solids = {part.name: part.make() for part in parts_of(spec) if part.name in ("core", "shell")}
    meshes = {name: as_mesh(solid) for name, solid in solids.items()}
    reach = 2 * float(abs(meshes["shell"].bounds).max())
    knife = trimesh.creation.box(bounds=[(0, -reach, -reach), (reach, 0, reach)])
    shell = trimesh.boolean.difference([meshes["shell"], knife], engine="manifold")
    flat = np.min(abs(shell.triangles[..., :2]).max(axis=1), axis=1) < 1e-4
    parts = [(shell, np.where(flat[:, None], COLOURS["cut"], COLOURS["silicone"]))]
    parts.append((meshes["core"], np.tile(COLOURS["core"], (len(meshes["core"].faces), 1))))
    for halves in magnet_halves(spec, magnet_layout(spec)):
        for half, name in zip(halves, ("north", "south"), strict=True):
            parts.append((half, np.tile(COLOURS[name], (len(half.faces), 1))))
    corners, normals, colours = zip(
        *((mesh.triangles, mesh.face_normals, colour) for mesh, colour in parts), strict=True
    )
    return np.concatenate(corners), np.concatenate(normals), np.concatenate(colours)


def as_mesh(solid: object) -> trimesh.Trimesh:
    """Triangles of an exact solid; what is known by its triangles is returned."""
    if isinstance(solid, trimesh.Trimesh):
        return solid
    points, faces = solid.tessellate(0.03, 0.15)  # pyright: ignore[reportAttributeAccessIssue]
    mesh = trimesh.Trimesh([point.toTuple() for point in points], faces)
    mesh.merge_vertices()
    mesh.update_faces(mesh.nondegenerate_faces())
    return mesh


def picture_of(spec: ObjectSpec) -> tuple[np.ndarray, tuple[float, ...]]:
    """Image (row, column, 3) and its extent in mm."""
    corners, normals, colours = triangles_of(spec)
    camera = camera_axes((1, -1.25, 0.8), (0, 0, 1))
    image = depth_image(corners @ camera.T)
    brightness = 0.45 + 0.55 * np.clip(normals @ camera.T @ LIGHT, 0, 1)
    shown = (colours * brightness[:, None])[image.triangle]
    shown[image.triangle < 0] = 1.0
    depth = np.where(image.triangle < 0, -1e6, image.depth_mm)
    shown[:-1][np.abs(np.diff(depth, axis=0)) > STEP_MM] = 0.1
    shown[:, :-1][np.abs(np.diff(depth, axis=1)) > STEP_MM] = 0.1
    return shown, image.extent_mm


def main(target: Path, files: list[Path]) -> None:
    """Draw one panel a specification, on one scale."""
    from matplotlib.figure import Figure

    columns = min(4, len(files))
    rows = -(-len(files) // columns)
    figure = Figure(figsize=(4.2 * columns, 4.4 * rows), layout="constrained")
    axes = np.atleast_1d(np.asarray(figure.subplots(rows, columns), dtype=object)).ravel()
    reach = 0.0
    for one, file in zip(axes, files, strict=False):
        spec = load_spec(file)
        shown, extent = picture_of(spec)
        one.imshow(shown, extent=extent, interpolation="antialiased")
        size = " × ".join(f"{edge:g}" for edge in np.round(spec.body.size_mm, 1))
        inside = f", {spec.body.inside} inside" if spec.body.kind == "dome" else ""
        one.set_title(f"{file.name}\n{spec.body.kind}{inside}, {size} mm", fontsize=11)
        reach = max(reach, *(abs(edge) for edge in extent))
    for one in axes:
        one.set_axis_off()
        one.set(xlim=(-reach, reach), ylim=(-reach, reach))
    axes[0].plot([-reach, 10 - reach], [-0.96 * reach] * 2, color="black", lw=2)
    axes[0].text(5 - reach, -0.94 * reach, "10 mm", ha="center", va="bottom")
    figure.savefig(target, dpi=100)


if __name__ == "__main__":
    main(Path(sys.argv[1]), [Path(name) for name in sys.argv[2:]])
