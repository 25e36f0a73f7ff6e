"""Settings of made-up parts, the sides that they lie on, a scene: a page that a person can judge."""

import numpy as np
import trimesh

from design.build.print_settings import lying_side, print_settings
from design.build.scene import assembly_scene, magnet_halves
from design.layout.places.positions import magnet_layout
from tests.support.objects.worked_objects import worked
from tests.support.physics_pages import assert_page

NAMES = (
    "core",
    "shell",
    "mould_pin_1",
    "mould_locator_2",
    "mould_half_a",
    "probe_2",
    "jig",
    "magnet_template",
)


def hooked():
    """An arm of 30 × 6 × 4 mm on a column of 8 × 8 × 26 mm, by which it stands."""
    parts = [[[0, 0, 0], [8, 8, 26]], [[7, 1, 20], [37, 7, 24]]]
    boxes = [trimesh.creation.box(bounds=np.array(bounds, float)) for bounds in parts]
    return trimesh.boolean.union(boxes, engine="manifold")


SHAPES = {
    "hook": hooked(),
    "cone": trimesh.creation.cone(radius=6.0, height=14.0, sections=24),
    "plate": trimesh.creation.box((30.0, 20.0, 2.0)),
    "needle": trimesh.creation.box((3.0, 4.0, 40.0)),
}


def of_parts():
    for shape, mesh in SHAPES.items():
        yield f"{shape} lies on", lying_side(mesh)
    for name in NAMES:
        settings = print_settings(worked("box"), name, SHAPES["hook"], printed=True)
        sizes = [settings.layer_mm, settings.walls, settings.infill_percent, settings.supports]
        down = [settings.brim_mm, *settings.down, *settings.rotation @ np.array([1.0, 2.0, 3.0])]
        yield f"{name}: layer, walls, infill (%), supports, brim, down, turned", [*sizes, *down]


def of_scene():
    for shape in ("disk", "ring", "block"):
        hole = 1.5 * (shape == "ring")
        sizes = {"shape": shape, "size_mm": (4.0, 3.0), "inner_diameter_mm": hole}
        spec = worked("box").changed(magnets=worked("box").magnets.changed(**sizes))
        halves = magnet_halves(spec, magnet_layout(spec))[:4]
        yield f"{shape}: volumes of halves (mm³)", [half.volume for pair in halves for half in pair]
        boxes = [half.bounds for pair in halves for half in pair]
        yield f"{shape}: boxes around halves, north first (mm)", np.array(boxes)
    body = trimesh.creation.box((46.0, 50.0, 56.0))
    scene = assembly_scene(worked("box"), {"core": body, "shell": body})
    boards = [mesh for name, mesh in scene.geometry.items() if name.startswith("sensor")]
    yield "parts of a scene, boards", [len(scene.geometry), len(boards)]
    yield "boxes around boards (mm)", np.array([board.bounds for board in boards])


def test_the_page_of_builds():
    assert_page("design/build", [*of_parts(), *of_scene()])
