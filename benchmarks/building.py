"""Time from a specification to all parts on disk: the paper's cube, and a fruit of 50 000 triangles.

    python benchmarks/building.py [--quick] [--out FOLDER]

The fruit is made here: a pear, bumpy and as noisy as a scan, always the same. Its time counts from
its file and specification to STL and 3MF of every part; imports are not counted in either. Times are
processor time on one thread, the least of several runs. Writes `building.json`.
"""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any

import numpy as np
import trimesh
from harness import best_seconds, machine, run
from scipy.spatial import ConvexHull

from design.build.export import build_object
from design.spec.object import ObjectSpec
from design.spec_io import load_spec

CUBE_TARGET_S, FRUIT_TARGET_S = 5.0, 30.0
TRIANGLES = 50_000
NOISE_MM = 0.05
FRUIT = """
name = "fruit"
[body]
kind = "imported"
file = "{file}"
sensed_faces = [2, 3, 4, 5]
[magnets]
positions_mm = [[0, 0], [9, 0], [-9, 0]]
[sensors]
radius_mm = 7.0
[core]
recess_inner_radius_mm = 3.8
recess_outer_radius_mm = 10.2
[contact_grid]
count = [5, 5]
pitch_mm = 3.0
"""


def fruit(triangles: int) -> trimesh.Trimesh:
    """A closed pear, 69 mm wide and 76 mm high, of so many triangles (an even number)."""
    count = triangles // 2 + 2
    height = 1 - (2 * np.arange(count) + 1) / count
    turn = np.pi * (1 + np.sqrt(5)) * np.arange(count)
    across = np.sqrt(1 - height**2)
    on_ball = np.column_stack([across * np.cos(turn), across * np.sin(turn), height])
    hull = ConvexHull(on_ball)
    corner = on_ball[hull.simplices]
    inward = np.linalg.det(corner) < 0
    hull.simplices[inward] = hull.simplices[inward, ::-1]
    surface = trimesh.Trimesh(on_ball, hull.simplices, process=False)
    bumps = 0.4 * np.sin(6 * on_ball[:, 0] + 1) * np.sin(5 * on_ball[:, 1]) * np.cos(4 * height)
    bumps += NOISE_MM * np.random.default_rng(1).standard_normal(count)
    girth = 31 - 4.5 * np.tanh(3 * (height - 0.3)) * (1 + height)
    surface.vertices = on_ball * np.column_stack([girth, girth, 0 * girth + 38]) + (
        bumps[:, None] * on_ball
    )
    return surface


def built(spec: ObjectSpec, folder: Path) -> dict[str, Any]:
    """Build and write an object; the shell's volume and whether all surfaces close."""
    manifest = build_object(spec, folder / spec.name)
    return {
        "parts": len(manifest.parts),
        "closed": all(part.stl_watertight for part in manifest.parts),
        "shell_mm3": manifest.part("shell").volume_mm3,
    }


def fruit_result(folder: Path, triangles: int, repeats: int) -> dict[str, Any]:
    """Each run reads a file of its own: what is kept of a file read before would flatter it."""
    surface, numbers, found = fruit(triangles), iter(range(99)), {}

    def from_file_to_parts() -> None:
        stem = f"fruit_{next(numbers)}"
        surface.export(folder / f"{stem}.stl")
        (folder / f"{stem}.toml").write_text(FRUIT.format(file=f"{stem}.stl"))
        found.update(built(load_spec(folder / f"{stem}.toml"), folder))

    seconds = best_seconds(from_file_to_parts, repeats)
    return {"seconds": seconds, "target_s": FRUIT_TARGET_S, "triangles": triangles, **found}


def cube_result(folder: Path, repeats: int) -> dict[str, Any]:
    spec, found = ObjectSpec(name="cube"), {}
    seconds = best_seconds(lambda: found.update(built(spec, folder)), repeats)
    return {"seconds": seconds, "target_s": CUBE_TARGET_S, **found}


def measure(quick: bool) -> dict[str, Any]:
    """Both times; in the quick form of a coarser fruit."""
    with tempfile.TemporaryDirectory() as name:
        folder, repeats = Path(name), 1 if quick else 3
        return {
            "cube": cube_result(folder, repeats),
            "fruit": fruit_result(folder, 2_000 if quick else TRIANGLES, repeats),
        }


def report(result: dict[str, Any]) -> str:
    """The result as lines for people."""
    cube, fruit = result["cube"], result["fruit"]
    return "\n".join(
        [
            f"the paper's cube, {cube['parts']} parts: {cube['seconds']:.1f} s (target "
            f"{CUBE_TARGET_S:g} s)",
            f"a fruit of {fruit['triangles']} triangles, {fruit['parts']} parts: "
            f"{fruit['seconds']:.1f} s (target {FRUIT_TARGET_S:g} s)",
        ]
    )


def whole(quick: bool) -> dict[str, Any]:
    """Figures, and what they were measured on."""
    here = machine(1, ("numpy", "cadquery", "cadquery-ocp", "trimesh", "manifold3d", "pyvista"))
    return {"machine": here, "quick": quick, **measure(quick)}


if __name__ == "__main__":
    run(whole, report)
