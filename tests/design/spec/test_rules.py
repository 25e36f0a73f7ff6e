"""Rules that several keys of a table obey together: what is taken, what is refused, and what is said."""

import re

import pytest
from pydantic import ValidationError

from design.errors import SpecError
from design.spec.base import complaints
from design.spec.object import ObjectSpec
from design.spec_io import with_overrides
from instobj.sweep.study import StudySpec

RULES = """
mechanics.element=taylor-hood silicone.poisson_ratio=% | 0.01 | 0.009 | takes silicone.poisson_ratio from 0.01
mechanics.element=p2 silicone.poisson_ratio=% | 0.45 | 0.46 | takes silicone.poisson_ratio up to 0.45
mechanics.element=p2-p0 silicone.poisson_ratio=% | 0.4999 | 0.49995 | up to 0.4999; got 0.49995
mechanics.element=% silicone.layers=[[1,5]] | p2-p0 | taylor-hood | whose pressure
silicone.layers=[[%,5]] mechanics.element=p2-p0 | 7.9 | 8 | are 8 mm thick
silicone.youngs_modulus_mpa=0.4 silicone.youngs_modulus_range_mpa=[%,0.5] | 0.4 | 0.41 | around youngs_modulus
silicone.youngs_modulus_mpa=0.4 silicone.youngs_modulus_range_mpa=[0.2,%] | 0.4 | 0.39 | around youngs_modulus
silicone.prony=[[0.5,1],[%,2]] | 0.4 | 0.5 | sum to less than 1; got 1
sensors.frame_rate_hz=% | 317 | 318 | is beyond the 317
sensors.frame_rate_hz=% sensors.averaging=1 sensors.count_per_face=2 | 470 | 480 | 10 sensors with averaging =
sensors.frame_rate_hz=% sensors.averaging=32 | 179 | 311 | is beyond the 310
body.sensed_faces=[1,3] magnets.positions_mm=% | [[[0,0]],[[1,1]]] | [[[0,0]],[[1,1]],[[2,2]]] | holds 3 lists
sensors.count_per_face=% sensors.positions_mm=[[5,0],[-5,0]] | 2 | 3 | = 3 places on every face; got \\[2\\]
sensors.rotations_deg=% | [[0,0,0],[0,0,90],[0,0,180]] | [[0,0,0],[0,0,90]] | 3 sensors of a face; got lists o
sensors.rotations_deg=[[0,0,0],[0,0,90],[0,0,180]] sensors.chip=% | inward | outward | Give rotations_deg alon
sensors.range_mt=% | 80 | 80.1 | beyond the ranges of TMAG5273A1
sensors.part=% | TMAG5273B2 | TMAG5273E2 | is not in the catalogue
sensors.part=MLX90393 sensors.noise_counts=% | [9,9,12] | [] | noise_counts
body.sensed_faces=[1] magnets.positions_mm=% | [[[0,0],[5,5]]] | [[[0,0],[5]]] | positions_mm
magnets.positions_mm=% | [[1,2]] | [] | positions_mm
magnets.shape=ring magnets.inner_diameter_mm=% | 5.9 | 6 | inner_diameter_mm must be below magnets.diameter_mm
magnets.shape=ring magnets.inner_diameter_mm=% | 0.1 | 0 | needs magnets.inner_diameter_mm above 0
magnets.shape=% magnets.inner_diameter_mm=2 | ring | disk | belongs to a ring
magnets.part=D6x1 magnets.height_mm=% | 1 | 2 | contradicts magnets.part = 'D6x1'
magnets.grade=N42 magnets.remanence_t=% | 1.28 | 1.27 | outside grade N42 \\(1.28 to 1.33 T\\)
magnets.positions_mm=[[0,0],[9,9]] magnets.north=% | ["inward","outward"] | ["inward"] | one entry for each of
magnets.positions_mm=[[0,0],[9,9]] magnets.tilt_deg=% | [[1,0],[0,0]] | [[1,0],[0,0],[0,1]] | one entry for ea
magnets.positions_mm=[[0,0],[9,9]] magnets.depth_mm=% | [2,2] | [2] | one entry for each of the 2
body.size_mm=[1,%,4] | 5 | 4.99 | must measure 5 to 1000 mm
body.size_mm=[10,%,40] | 1000 | 1000.5 | must measure 5 to 1000 mm
body.kind=sphere body.size_mm=[50,%,50] | 50 | 51 | three times its diameter
body.kind=capsule body.size_mm=[40,40,%] | 41 | 40 | and z above it
body.kind=capsule body.size_mm=[40,%,60] | 40 | 41 | x and y alike
body.kind=dome body.size_mm=[40,40,%] | 20.1 | 20 | z above half of it
body.kind=dome body.size_mm=[40,%,30] | 40 | 41 | x and y alike
body.kind=cylinder body.size_mm=[40,%,30] | 40 | 41 | x and y alike
body.open_faces=% | [2,3,4,5,1] | [2,3,4,5,1,6] | no face of silicone
body.open_faces=% | [2,3,4] | [2,3,4,5] | two faces \\[1, 6\\]
body.open_faces=% | [1,6,2] | [1,6,2,4] | two faces \\[3, 5\\]
body.kind=cylinder body.open_faces=% | [1,6] | [2] | may name \\[1, 6\\]; got \\[2\\]
body.kind=dome body.size_mm=[40,40,30] body.inside=% | air | water | inside
body.inside=% | core | air | inside
body.sensed_faces=% | [1,5] | [1,6] | sensed_faces
mechanics.interface=% mechanics.slip.shift_mm=[0.1,0,0] | bonded | frictionless | moves a bonded interface
indenter.kind=cuboid indenter.size_mm=[6,9] indenter.fillet_mm=% | 2.9 | 3.1 | fillet_mm
indenter.kind=flat indenter.radius_mm=3 indenter.fillet_mm=% | 2.9 | 3.1 | fillet_mm
press.depths_mm=% | [0.5,0.6] | [0.6,0.6] | depths_mm
as_built.magnets=[{face=2,magnet=%}] | 5 | 6 | magnet
as_built.sensors=[{face=2,sensor=%}] | 3 | 4 | sensor
as_built.magnets=[{face=%,magnet=1}] | 5 | 6 | face
as_built.magnets=[{face=2,magnet=1,axis=[0,0,%]}] | 0.1 | 0 | has no direction
collection.faces=% | [1,2] | [2,2] | names a face twice; got \\[2, 2\\]
collection.grasp_faces=% | [3,5] | [3,3] | grasp_faces names a face twice
collection.grasp_faces=% | [3,5,5] | [3,5,2] | fingers on different faces
collection.tangential_share=0.5 collection.kind=% | continuous | paper | tangential_share
collection.tangential_share=0.5 collection.kind=continuous collection.contacts=% | 1 | 2 | tangential_share
collection.kind=continuous collection.contacts=2 collection.tangential_share=% | 0 | 0.1 | tangential_share
protocol.peak_force_n=% | [10,10] | [10.1,10] | peak_force_n
search.vary.magnet_depth_mm=% | [2,3] | [3,3] | must rise from above 0
search.vary.magnet_depth_mm=% | [0.1,3] | [0,3] | magnet_depth_mm
search.vary.magnet_count=[2,3] search.vary.%=9 | magnet_reach_mm | sensor_reach_mm | needs search.vary.magnet
search.vary.sensor_count=[2,3] search.vary.%=9 | sensor_reach_mm | magnet_reach_mm | needs search.vary.sensor
search.forces_n=% | [2,5] | [5,5] | must increase strictly
mechanics.correction=large-strain mechanics.element=% | taylor-hood | p2-p0 | correction
mechanics.correction=large-strain mechanics.interface=% | bonded | frictionless | correction
mechanics.correction=large-strain mechanics.slip.shift_mm=[0,0,%] | 0 | 0.1 | correction
mechanics.interface=frictionless mechanics.slip.rotation_deg=[0,0,%] | 0 | 1 | moves a bonded interface
indenter.turn_deg=[9,0,%] | 0 | 3 | does nothing to a hemisphere
indenter.kind=% indenter.turn_deg=[9,0,3] | flat | hemisphere | does nothing to a hemisphere
indenter.kind=% indenter.vertices_mm=[[0,0,0],[6,0,8],[-6,5,8],[-6,-5,8]] | stl | flat | goes with indenter
indenter.fillet_mm=% | 0 | 1 | fillet_mm
environment.magnets=[{position_mm=[90,0,0],remanence_t=[0,0,%]}] | 1 | 0 | must not be zero
environment.steel_plates=[{position_mm=[90,0,0],normal=[%,0,0]}] | 1 | 0 | normal
environment.earth_ut=% | [0,60,0] | [0,160,0] | earth_ut
load_cell.scale_n=% | -20 | 0 | must not be 0
load_cell.kind=hx711 load_cell.pins=% | ["D40","D41"] | ["D40"] | pins
load_cell.kind=analog load_cell.pins=% | ["A0"] | ["A0","A1"] | pins
as_built.magnets=[{face=2,magnet=1},{face=%,magnet=1}] | 3 | 2 | magnet 1 of face 2
as_built.sensors=[{face=2,sensor=1},{face=2,sensor=%}] | 2 | 1 | sensor 1 of face 2
"""
"""Changes of the paper's cube with a value for %, one that is taken, one that is refused, and the words."""


def said_of(changes):
    try:
        ObjectSpec.model_validate(with_overrides({"name": "x"}, changes.split()))
    except ValidationError as error:
        return " ".join(complaints(error, ObjectSpec))
    return ""


@pytest.mark.parametrize("row", RULES.strip().splitlines())
def test_a_rule_takes_up_to_its_border(row):
    changes, taken, refused, words = row.split(" | ")
    assert not said_of(changes.replace("%", taken))
    assert re.search(words, said_of(changes.replace("%", refused)))


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (
            "magnets.depth_mm=-3",
            "magnets.depth_mm: Input should be greater than 0 and less than or equal to 1000; got -3",
        ),
        (
            "magnets.depth_mm=[3,-1]",
            "magnets.depth_mm.1: Input should be greater than 0 and less than or equal to 1000; got -1",
        ),
        (
            "magnets.depth_mm='deep'",
            "magnets.depth_mm: Input should be a valid number or a list in brackets; got 'deep'",
        ),
        (
            "environment.earth_ut='up'",
            "environment.earth_ut: Input should be a valid number or a list in brackets; got 'up'",
        ),
        ("environment.earth_ut=[1,0]", "environment.earth_ut.2 is missing. Add it"),
        (
            "contact_grid.count=3",
            "contact_grid.count: Input should be 'fill' or a list in brackets; got 3",
        ),
        (
            "contact_grid.count=[1,5]",
            "contact_grid.count.0: Input should be greater than or equal to 2 and less than or equal to "
            "100; got 1",
        ),
        (
            "magnets.positions_mm=3",
            "magnets.positions_mm: Input should be a list in brackets; got 3",
        ),
    ],
)
def test_a_key_of_several_kinds_is_told_in_one_line(change, said):
    assert said_of(change) == said


def test_a_value_inside_a_table_of_several_kinds_is_told_in_one_line():
    with pytest.raises(SpecError) as told:
        StudySpec(name="s", specification="a.toml", grid={"body.size": [1, {"x": 2}]})
    kinds = "integer or a valid number or a valid string or a valid boolean or a valid list"
    assert str(told.value) == f"grid.body.size.1: Input should be a valid {kinds}"


UNLIKELY = {
    "silicone.youngs_modulus_mpa=414": "equal to 50; got 414. In kPa it would be 0.414 MPa",
    "silicone.youngs_modulus_mpa=0.2e6": "In Pa it would be 0.2 MPa",
    "score.force_n=8000": "In mN it would be 8 N",
    "magnets.remanence_t=12": "In kG it would be 1.2 T",
    "magnets.remanence_t=4.3": "equal to 2; got 4.3",
    "shell.thickness_mm=0.008": "In m it would be 8 mm",
    "mould.wall_mm=0.015": "mould.wall_mm: Input should be greater than or equal to 0.1",
    "tolerances.sensor_gain_relative=20000": "less than or equal to 0.5",
    "tolerances.sensor_rotation_deg=200": "less than or equal to 30",
    "seed=100000000000000000000": "seed",
    "sensors.axes=['X','Y','Z','Y']": "sensors.axes: names Y twice",
    "body.open_faces=[6,6]": "body.open_faces: names 6 twice",
    "as_built.sensors=[{face=1,sensor=1,dead=['X','X']}]": "names X twice",
    "shell.thickness_mm=true": "shell.thickness_mm: true and false are no values of this key",
    "sensors.positions_mm=[[true,1.0],[5,5]]": "sensors.positions_mm: true and false",
    "sensors.averaging=true": "sensors.averaging: true and false",
    "seed=true": "seed: true and false",
    "search.limits.times_start={worst_force_bound_n=true}": "times_start: true and false",
    "inversion.jaws=1": "inversion.jaws: write true or false; got 1",
    "training.process='yes'": "training.process: write true or false",
    "body.scale=2": "body.scale = 2.0 has no effect on body.kind = 'box'. Leave it out",
    "body.bore_mm=3": "body.bore_mm = 3.0 has no effect on body.kind = 'box'",
    "body.kind=ellipsoid body.open_faces=[3]": "body.open_faces",
    "body.size_mm='70,50,35'": "a list in brackets; got '70,50,35'. Write it as [70, 50, 35]",
    "shell.thickness_mm='9mm'": "a number alone (the key names its unit); got '9mm'",
    "name='Würfel'": "name: letters, digits, _ . - alone, a letter or digit first; no blanks, no umlauts",
}
"""Changes of the paper's cube that are no sense, and what is said of each."""


@pytest.mark.parametrize(("changes", "words"), UNLIKELY.items(), ids=UNLIKELY)
def test_what_is_no_sense_is_refused_with_what_was_meant(changes, words):
    assert words in said_of(changes)


@pytest.mark.parametrize(
    ("change", "bounds"),
    [
        ("silicone.youngs_modulus_mpa=414", "or equal to 0.001 and less than or equal to 50; got"),
        ("shell.thickness_mm=-8", "or equal to 0.3 and less than or equal to 200; got -8"),
        ("magnets.height_mm=[1,-2,1,1,1]", "0 and less than or equal to 1000; got -2"),
        ("magnets.tilt_deg=[[31,0]]", "or equal to -30 and less than or equal to 30; got 31"),
        ("contact_grid.count=[1,5]", "or equal to 2 and less than or equal to 100; got 1"),
        ("sensors.chip_spread=[2,0]", "or equal to 0 and less than 0.5; got 2"),
        ("seed=-1", "or equal to 0 and less than or equal to 2147483647; got -1"),
    ],
)
def test_a_value_beyond_a_bound_is_told_with_both(change, bounds):
    """In lists and in keys of several kinds too; the end that was kept was not told."""
    assert f"Input should be greater than {bounds}" in said_of(change)


def test_no_unit_is_proposed_that_would_lie_beyond_the_other_bound():
    assert "In m it would be" not in said_of("shell.thickness_mm=0.29")
    assert "In cm it would be 2.9 mm" in said_of("shell.thickness_mm=0.29")


@pytest.mark.parametrize("changes", ["body.kind=sphere body.bore_mm=8", "inversion.jaws=true"])
def test_what_a_kind_uses_is_taken(changes):
    assert not said_of(changes)
