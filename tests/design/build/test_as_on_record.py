"""Settings of made-up parts, the sides that they lie on, and magnets of a scene, on record."""

import numpy as np
import pytest
import trimesh

from design.build.print_settings import _standing, lying_side, print_settings
from design.build.scene import _moved, assembly_scene, magnet_halves
from design.layout.places.positions import magnet_layout
from tests.support.objects.worked_objects import worked
from tests.support.recorded_facts import assert_on_record, of_solids, told

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


@pytest.mark.parametrize("shape", SHAPES)
def test_parts_lie_as_on_record(shape):
    mesh = SHAPES[shape]
    side = np.array(lying_side(mesh))
    lines = [told("down", side), told("bed, overhang, height", _standing(mesh, side))]
    ways = np.array([[0, 0, -1], [1, 0, 0], [0, 0.6, 0.8]])
    lines += [told(f"way {k}", _standing(mesh, way)) for k, way in enumerate(ways, start=1)]
    assert_on_record("printing", shape, lines)


@pytest.mark.parametrize("name", NAMES)
def test_settings_are_those_of_the_part_s_use(name):
    settings = print_settings(worked("box"), name, SHAPES["hook"], printed=True)
    turned = settings.rotation @ np.array([1.0, 2.0, 3.0])
    sizes = [settings.layer_mm, settings.walls, settings.infill_percent, settings.supports]
    line = told(name, [*sizes, settings.brim_mm, *settings.down, *turned])
    assert_on_record("printing", f"settings of {name}", [line])


@pytest.mark.parametrize("shape", ["disk", "ring", "block"])
def test_halves_of_magnets_lie_north_outward_as_on_record(shape):
    sizes = {"shape": shape, "size_mm": (4.0, 3.0), "inner_diameter_mm": 1.5 * (shape == "ring")}
    spec = worked("box").changed(magnets=worked("box").magnets.changed(**sizes))
    halves = magnet_halves(spec, magnet_layout(spec))
    lines = [of_solids("north", [north for north, _ in halves[:4]])]
    lines.append(of_solids("south", [south for _, south in halves[:4]]))
    assert_on_record("scene", shape, lines)


def test_a_scene_holds_boards_in_their_places():
    body = trimesh.creation.box((46.0, 50.0, 56.0))
    scene = assembly_scene(worked("box"), {"core": body, "shell": body})
    boards = [mesh for name, mesh in scene.geometry.items() if name.startswith("sensor")]
    lines = [told("parts", [len(scene.geometry)]), of_solids("boards", boards)]
    assert_on_record("scene", "boards", lines)


def test_a_moved_mesh_is_a_copy_in_its_frame():
    box = trimesh.creation.box((1.0, 2.0, 3.0))
    turned = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    moved = _moved(box, turned, np.array([10.0, 0.0, 0.0]))
    np.testing.assert_allclose(moved.bounds, [[9.0, -0.5, -1.5], [11.0, 0.5, 1.5]], atol=1e-12)
    np.testing.assert_allclose(box.bounds, [[-0.5, -1.0, -1.5], [0.5, 1.0, 1.5]])
