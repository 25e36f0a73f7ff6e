"""Golden geometry: every object's parts, pockets and sensor seats as numbers in one YAML file.

    python -m tests.support.objects.golden_geometry

writes `tests/references/geometry.yaml` anew. Do so only after a deliberate change of a part, look at
the difference, and say in the commit why it changed.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import trimesh
import yaml

from design.build.parts import Part, parts_of
from design.files import atomic_path
from design.layout.body import face_frames
from design.layout.places.positions import sensor_layout
from design.layout.pockets import shell_pockets
from design.spec.object import ObjectSpec
from design.spec_io import load_spec

ROOT = Path(__file__).parents[3]
REFERENCE = ROOT / "tests/references/geometry.yaml"
FILES = {
    "preset": ROOT / "instobj/templates/cube.toml",
    **{path.stem: path for path in sorted((ROOT / "examples").glob("*.toml"))},
}
"""What `instobj new` starts from and every example, by the name that it has in the reference."""

HEADER = """\
# Golden geometry of the preset and of every file in examples/: parts (mm, mm³), floors of the shell's
# pockets and places of the sensors, face by face, in the object's frame (mm). Parts without a count
# of faces are known by their triangles. Written by `python -m tests.support.objects.golden_geometry`.
"""


def measured_part(part: Part) -> dict[str, Any]:
    """Volume, box, centre of mass, and the number of faces of an exact solid."""
    shape = part.make()
    if isinstance(shape, trimesh.Trimesh):
        box, centre, faces = shape.bounds, shape.center_mass, {}
        volume = float(shape.volume)
    else:
        found = shape.BoundingBox()
        box = [[found.xmin, found.ymin, found.zmin], [found.xmax, found.ymax, found.zmax]]
        centre, volume = shape.Center().toTuple(), shape.Volume()
        faces = {"faces": len(shape.Faces())}
    return {
        "count": part.count,
        "volume_mm3": round(volume, 6),
        "box_mm": _rounded(box),
        "centre_of_mass_mm": _rounded(centre),
        **faces,
    }


def measured_places(spec: ObjectSpec) -> dict[str, Any]:
    """Floors of the pockets and sensors, by the number of the face."""
    sensors = sensor_layout(spec)
    return {
        "pocket_floors_mm": {
            frame.number: _rounded([frame.to_object(p.axis_ends_mm[0]) for p in pockets])
            for frame, pockets in zip(face_frames(spec), shell_pockets(spec), strict=True)
        },
        "sensors_mm": {
            number: _rounded(sensors.position_mm[sensors.face == number])
            for number in spec.body.sensed
        },
    }


def _rounded(values: Any) -> Any:
    return (np.round(np.asarray(values, float), 6) + 0.0).tolist()


@cache
def golden_geometry() -> dict[str, Any]:
    """What is on record, by object."""
    return yaml.load(REFERENCE.read_bytes(), Loader=yaml.CSafeLoader)


def main() -> None:
    objects = {}
    for name, path in FILES.items():
        print(f"building {name}")
        spec = load_spec(path)
        parts = {part.name: measured_part(part) for part in parts_of(spec)}
        objects[name] = {"parts": parts, **measured_places(spec)}
    text = yaml.safe_dump(objects, sort_keys=False, default_flow_style=None, width=100)
    with atomic_path(REFERENCE) as path:
        path.write_text(HEADER + text, encoding="utf-8")


if __name__ == "__main__":
    main()
