"""Magnets of several sizes on a face: bodies and pockets, field and signals, lists, input."""

import magpylib
import numpy as np
import pytest
import trimesh
from numpy.testing import assert_allclose, assert_array_equal

import instobj
from design.build.amounts import silicone_amount
from design.build.order_list import order_list
from design.build.scene import magnet_halves
from design.errors import InputError, SpecError
from design.layout.places.positions import magnet_layout, sensor_layout, shell_body_layout
from design.layout.pockets import magnet_bodies, shell_pockets
from design.spec.object import ObjectSpec
from design.spec_io import parse_spec
from estimator.field.models import MixedModel, exact_model, magnets_model, sum_over_magnets
from estimator.field.sources import magnet_source, magnet_sources
from estimator.signals.hall import check_sensors_outside_magnets
from estimator.signals.presses import rest_counts
from fem.mesh.surfaces import body_surfaces
from instobj.viewer.scene import object_scene

PARTS = ("D8x2", "D4x1", "D4x2")
MAGNETS = {
    "part": PARTS,
    "grade": ["N35", "N52", "N42"],
    "positions_mm": [[2.0, -1.0], [-9.0, 4.0], [7.0, -9.5]],
    "tilt_deg": [[12, -20], [0, 25], [-8, 3]],
    "north": ["outward", "inward", "inward"],
}
SIZES_MM = ((8.0, 2.0), (4.0, 1.0), (4.0, 2.0))
REMANENCES_T = (1.20, 1.45, 1.31)
BLOCKS = {"part": None, "shape": "block", "size_mm": [[5, 3], [4, 6], [5, 3]], "height_mm": 2.0}
SHELL = {"pocket_diameter_mm": 8.2, "pocket_depth_mm": 4.0}


def cube(more=None, **content):
    magnets = {k: v for k, v in (MAGNETS | (more or {})).items() if v is not None}
    return ObjectSpec.model_validate(
        {"name": "cube", "magnets": magnets, "shell": SHELL, **content}
    )


def oracle_t(spec, points_mm):
    """Magpylib's field of all magnets, each of its own size and polarized as if it were alone."""
    layout, total = magnet_layout(spec), np.zeros((len(points_mm), 3))
    for k, (centre, axis, side) in enumerate(
        zip(layout.centre_mm, layout.axis, layout.side, strict=True)
    ):
        own = {"part": None, "grade": None, "remanence_t": REMANENCES_T[k % 3]}
        if spec.magnets.shape == "block":
            own["size_mm"] = spec.magnets.size_mm[k % 3]
            size = (*(1e-3 * edge for edge in own["size_mm"]), 2e-3)
            shape = magpylib.magnet.Cuboid
        else:
            own["diameter_mm"], own["height_mm"] = SIZES_MM[k % 3]
            size, shape = tuple(1e-3 * one for one in SIZES_MM[k % 3]), magpylib.magnet.Cylinder
        j = magnet_source(spec.magnets.changed(**own)).polarization_t
        turn = np.column_stack([side, np.cross(axis, side), axis])
        source = shape(polarization=(0, 0, j), dimension=size)
        total += source.getB((points_mm - centre) @ turn * 1e-3) @ turn.T
    return total


@pytest.mark.parametrize("shape", [{}, BLOCKS], ids=["disk", "block"])
def test_the_field_is_the_sum_of_every_magnets_own(shape):
    spec = cube(shape)
    points = np.array([[3.0, -2.0, 5.0], [30.0, 4.0, -6.0], [-1.0, 0.5, 28.0]])
    assert_allclose(instobj.magnet_field(spec, points), oracle_t(spec, points), rtol=1e-8)


def test_sensors_at_rest_read_that_field():
    spec, sensors = cube(), sensor_layout(cube())
    field = oracle_t(spec, sensors.position_mm)
    wanted = 1e3 * spec.sensors.counts_per_mt * np.einsum("sac,sc->sa", sensors.axes, field)
    assert_allclose(rest_counts(spec), wanted, rtol=0, atol=1e-3 * abs(wanted).max())
    series = rest_counts(spec, magnets_model(spec.magnets, 6.0))
    assert_allclose(series, wanted, rtol=0, atol=1e-3 * abs(wanted).max())


def test_a_list_of_one_size_is_that_size():
    listed, alike = cube({"part": ["D4x2"] * 3}), cube({"part": "D4x2"})
    assert not isinstance(exact_model(listed.magnets), MixedModel)
    assert listed.magnets.kinds == alike.magnets.kinds
    assert_array_equal(rest_counts(listed), rest_counts(alike))


def test_a_model_of_several_sizes_asks_which_each_magnet_has():
    model, place = magnets_model(cube().magnets, 6.0), (np.ones((3, 1)),) * 3
    with pytest.raises(ValueError, match="3 sizes"):
        sum_over_magnets(place, (np.zeros((3, 1)),) * 3, place, model)
    with pytest.raises(ValueError, match="too many values"):
        magnet_source(cube().magnets)


def test_bodies_lie_on_the_floors_of_pockets_as_much_wider_than_they_are():
    upright = cube({"tilt_deg": None})
    for body, pocket, (wide, high) in zip(
        magnet_bodies(upright)[0], shell_pockets(upright)[0], SIZES_MM, strict=True
    ):
        assert 2 * body.outline.half_mm[0] == wide
        assert_allclose(2 * pocket.outline.half_mm[0], wide + 0.2)
        assert_allclose([body.height_mm, pocket.lowest_mm], [high, -4.0])


def test_every_body_is_meshed_and_left_out_of_the_silicone_in_its_own_size():
    spec = cube()
    volumes = np.tile([np.pi / 4 * wide**2 * high for wide, high in SIZES_MM], 5)
    assert_allclose([one.volume for one in body_surfaces(spec)], volumes, rtol=1e-6)
    assert_allclose(shell_body_layout(spec).volume_mm3, volumes)
    halves = magnet_halves(spec, magnet_layout(spec))
    assert_allclose([north.volume for north, _ in halves], volumes / 2, rtol=4e-3)
    lighter = cube({"part": "D4x1"})
    less = silicone_amount(lighter).volume_cm3 - silicone_amount(spec).volume_cm3
    assert_allclose(less, (volumes.sum() - 15 * np.pi * 4) / 1e3, rtol=1e-6)


def test_the_page_shows_every_magnet_in_its_size(tmp_path):
    spec = cube()
    trimesh.creation.box((26.0, 26.0, 26.0)).export(tmp_path / "core.stl")
    _, arrays = object_scene(spec, tmp_path)
    axes = arrays["magnet_axes"]
    columns = np.linalg.norm(axes.counts.reshape(-1, 3, 3) * axes.step, axis=1)
    wanted = np.array([(wide / 8, wide / 8, high / 2) for wide, high in SIZES_MM])
    assert_allclose(columns, np.tile(wanted, (5, 1)), rtol=1e-3)


def test_each_size_is_bought_by_itself():
    lines = [line for line in order_list(cube(), None) if "magnet" in line.part]
    assert [line.pieces for line in lines] == [5, 5, 5]
    assert all(part in line.number for line, part in zip(lines, PARTS, strict=True))
    assert cube({"grade": "N42"}).magnets.kinds == ("Ø8 × 2 mm", "Ø4 × 1 mm", "Ø4 × 2 mm")


def test_a_sensor_in_the_largest_magnet_alone_is_named_with_it():
    spec = cube()
    sensors, magnets = sensor_layout(spec), magnet_layout(spec)
    check_sensors_outside_magnets(sensors, magnets, magnet_sources(spec.magnets))
    position = sensors.position_mm.copy()
    frame = magnets.frames[3]
    position[4] = magnets.centre_mm[3] + 3.0 * frame[:, 0]
    moved = type(sensors)(position, sensors.axes, sensors.face)
    with pytest.raises(InputError, match=r"inside magnet 3 .* a disk of Ø8 × 2 mm"):
        check_sensors_outside_magnets(moved, magnets, magnet_sources(spec.magnets))
    position[4] = magnets.centre_mm[4] + 3.0 * magnets.frames[4][:, 0]
    check_sensors_outside_magnets(moved, magnets, magnet_sources(spec.magnets))


REFUSED = {
    "part needs one entry for each of the 3": {"part": ["D6x1", "D8x2"]},
    "one shape; got block and disk": {"part": ["D6x1", "B5x5x1", "D6x1"]},
    "'D9x9' is not in the catalogue": {"part": ["D6x1", "D9x9", "D6x1"]},
    r"height_mm = 3.0 contradicts magnets.part = 'D4x1' \(1.0\)": {"height_mm": [2.0, 3.0, 2.0]},
    "diameter_mm needs one entry for each of the 3": {"part": None, "diameter_mm": [6.0, 5.0]},
    r"height_mm.*1.*greater than 0": {"part": None, "height_mm": [1.0, -2.0, 1.0]},
    "size_mm needs one entry for each of the 3": BLOCKS | {"size_mm": [[5, 3], [4, 6]]},
    "pocket_diameter_mm = 8.2 is narrower than the magnets of 10 mm": {
        "part": ["D10x2", "D4x1", "D4x2"]
    },
    "a magnet of 4 × 4 mm must fit below the seal": {
        "part": None,
        "diameter_mm": 4.0,
        "height_mm": [1.0, 4.0, 2.0],
    },
}


@pytest.mark.parametrize("text", REFUSED)
def test_bad_sizes_are_one_clear_error(text):
    magnets = {k: v for k, v in (MAGNETS | REFUSED[text]).items() if v is not None}
    with pytest.raises(SpecError, match=text):
        parse_spec({"name": "cube", "magnets": magnets, "shell": SHELL}, "made up")
