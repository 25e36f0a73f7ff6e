"""Magnets of several grades on a face: their strengths, field, signals, layouts of a search, input."""

import magpylib
import numpy as np
import pytest
from numpy.testing import assert_allclose

import instobj
from design.errors import SpecError
from design.layout.places.positions import magnet_layout, sensor_layout
from design.spec.assembly import AsBuiltSpec, BuiltMagnet, TolerancesSpec
from design.spec.object import ObjectSpec
from design.spec_io import parse_spec
from estimator.field.sources import magnet_source
from estimator.layouts.batch import layouts_of
from estimator.signals.presses import rest_counts
from estimator.tolerances.assembly import designed, draw

GRADES = ("N35", "N52", "N42")
TYPICAL_T = (1.20, 1.45, 1.31)
MAGNETS = {
    "positions_mm": [[2.0, -1.0], [-9.0, 4.0], [7.0, -9.5]],
    "tilt_deg": [[12, -20], [0, 25], [-8, 3]],
    "north": ["outward", "inward", "inward"],
    "grade": GRADES,
}
BLOCKS = {"shape": "block", "size_mm": [5.0, 3.0], "height_mm": 2.0}


def cube(more=None, **content):
    return ObjectSpec.model_validate({"name": "cube", "magnets": MAGNETS | (more or {}), **content})


def oracle_t(spec, points_mm):
    """Magpylib's field of all magnets, each polarized as its own grade is at its working point."""
    layout, total = magnet_layout(spec), np.zeros((len(points_mm), 3))
    rows = zip(layout.centre_mm, layout.axis, layout.side, np.tile(TYPICAL_T, 5), strict=True)
    for centre, axis, side, remanence_t in rows:
        alone = magnet_source(spec.magnets.changed(grade=None, remanence_t=remanence_t))
        j, turn = alone.polarization_t, np.column_stack([side, np.cross(axis, side), axis])
        if spec.magnets.shape == "block":
            size = (5e-3, 3e-3, 2e-3)
            source = magpylib.magnet.Cuboid(polarization=(0, 0, j), dimension=size)
        else:
            source = magpylib.magnet.Cylinder(polarization=(0, 0, j), dimension=(6e-3, 1e-3))
        total += source.getB((points_mm - centre) @ turn * 1e-3) @ turn.T
    return total


@pytest.mark.parametrize("shape", [{}, BLOCKS], ids=["disk", "block"])
def test_the_field_is_the_sum_of_every_magnets_own(shape):
    spec = cube(shape)
    points = np.array([[3.0, -2.0, 5.0], [30.0, 4.0, -6.0], [-1.0, 0.5, 28.0]])
    assert_allclose(instobj.magnet_field(spec, points), oracle_t(spec, points), rtol=1e-8)
    alike = cube(shape | {"grade": "N42"})
    assert not np.allclose(instobj.magnet_field(alike, points), oracle_t(spec, points), rtol=0.02)


def test_sensors_at_rest_read_that_field():
    spec, sensors = cube(), sensor_layout(cube())
    field = oracle_t(spec, sensors.position_mm)
    wanted = 1e3 * spec.sensors.counts_per_mt * np.einsum("sac,sc->sa", sensors.axes, field)
    assert_allclose(rest_counts(spec), wanted, rtol=0, atol=1e-3 * abs(wanted).max())


def test_a_list_of_one_grade_is_that_grade():
    listed, alike = cube({"grade": ["N42"] * 3}), cube({"grade": "N42"})
    assert listed.magnets.remanences_t == alike.magnets.remanences_t
    assert_allclose(rest_counts(listed), rest_counts(alike), rtol=0, atol=0)


def test_remanences_may_be_given_for_each_magnet():
    measured = cube({"remanence_t": [1.18, 1.46, 1.33]})
    assert_allclose(magnet_layout(measured).strength[:3], np.array([1.18, 1.46, 1.33]) / 1.18)
    assert (
        cube({"grade": None, "remanence_t": TYPICAL_T}).magnets.strengths
        == cube().magnets.strengths
    )


def test_what_was_measured_goes_before_the_grade():
    found = (BuiltMagnet(face=3, magnet=2, remanence_t=1.40),)
    built = magnet_layout(cube(as_built=AsBuiltSpec(magnets=found)))
    wanted = np.tile(TYPICAL_T, 5) / 1.20
    wanted[7] = 1.40 / 1.20
    assert_allclose(built.strength, wanted, rtol=1e-12)


def test_virtual_objects_scatter_about_every_magnets_own_grade():
    none = dict.fromkeys(TolerancesSpec.model_fields, 0.0)
    spec = cube(tolerances=none | {"remanence_relative": 0.01})
    rng = np.random.default_rng(3)
    drawn = [draw(spec, designed(spec), rng).scene.magnets.strength for _ in range(200)]
    assert_allclose(np.mean(drawn, axis=0), np.tile(TYPICAL_T, 5) / 1.20, rtol=4e-3)
    assert_allclose(np.std(drawn, axis=0), 0.01 * np.tile(TYPICAL_T, 5) / 1.20, rtol=0.25)


def test_a_search_starts_from_the_designs_grades():
    spec = cube()
    polarization = layouts_of(spec, 1).polarity[0] * spec.magnets.remanences_t[0]
    assert_allclose(polarization, [1.20, -1.45, -1.31], rtol=1e-6)


REFUSED = {
    "grade needs one entry for each of the 3": {"grade": ["N35", "N52"]},
    "remanence_t needs one entry for each of the 3": {"grade": None, "remanence_t": [1.2, 1.3]},
    "remanence_t: .*at least 1 item": {"grade": None, "remanence_t": []},
    r"1.3 lies outside grade N52 \(1.42 to 1.48 T\)": {"remanence_t": [1.2, 1.3, 1.31]},
    "1.2 lies outside grade N52": {"remanence_t": 1.2},
    "'N99' is not in the catalogue": {"grade": ["N35", "N99", "N42"]},
    r"grade\.1: .*string; got 52": {"grade": ["N35", 52, "N42"]},
    r"grade = 'N35' contradicts magnets.part = 'MP 12x5x2 / N38' \('N38'\)": {
        "part": "MP 12x5x2 / N38"
    },
}


@pytest.mark.parametrize("text", REFUSED)
def test_bad_grades_are_one_clear_error(text):
    with pytest.raises(SpecError, match=text):
        parse_spec({"name": "cube", "magnets": MAGNETS | REFUSED[text]}, "made up")
