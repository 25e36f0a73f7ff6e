"""What is said of objects that do not fit: which key, what it is, and how to fix it.

Each line of the cases breaks one of the objects of `tests/support/objects/worked_objects.py`.
"""

import re
from copy import deepcopy

import pytest

from design.fit.boards import boards_across_edges
from design.fit.everything import problems_of
from design.spec.object import ObjectSpec
from design.spec_io import with_overrides
from tests.support.objects.worked_objects import OBJECTS

CASES = """
box: body.size_mm=[24.5,40,50]
box: core.recess_depth_mm=4.6
box: core.recess_outer_radius_mm=15.2
box: core.recess_inner_radius_mm=6.7
box: core.wire_hole_side_diameter_mm=21.5
box: core.wire_hole_top_diameter_mm=22.5
box: shell.pocket_depth_mm=8.25
box: shell.pocket_depth_mm=1.1
box: shell.pocket_diameter_mm=3.9
box: magnets.depth_mm=[1.25,2.6,0.5]
closed box: magnets.depth_mm=[7.5,6.9,2.2]
box: magnets.positions_mm=[[20.1,-6],[-7,24.2],[5,5.5]]
box: magnets.positions_mm=[[3,-6],[-7,2],[5,-3.5]]
box: magnets.positions_mm=[[3,-6],[-7,2],[18.2,-20.4]]
box: sensors.depth_below_core_face_mm=2.7
box: sensors.positions_mm=[[12.2,1.5],[-2,14.6]]
box: sensors.positions_mm=[[4.2,1.5],[6.1,-0.4]]
box: sensors.positions_mm=[[1,15],[1,-14]]
box: core.recess_inner_radius_mm=3.3
box: core.recess_width_mm=3.7
box: core.recess_depth_mm=2.05
box: sensors.radius_mm=5.75
box: press.depths_mm=[1,4.9]
box: indenter.radius_mm=1.4
box: indenter.kind=cuboid indenter.size_mm=[47,51]
box: contact_grid.count=[17,5]
box: contact_grid.count=[5,19] indenter.direction_deg=[5,-20]
box: contact_grid.count="fill" contact_grid.pitch_mm=22.3
box: contact_grid.count="fill" contact_grid.pitch_mm=0.3
box: contact_grid.count="fill" indenter.radius_mm=22.6
box: environment.magnets=[{position_mm=[26,-3,4]},{position_mm=[1,30,2],size_mm=[7,9]}]
box: environment.magnets=[{position_mm=[10,-3,4],size_mm=[7,9]}]
box: environment.steel_plates=[{position_mm=[0,5,27],normal=[0,0.3,-2]}]
box: environment={steel_plates=[{position_mm=[0,40,0],normal=[0,-2,0]}],magnets=[{position_mm=[1,35.5,2]}]}
box: core.keys.positions_mm=[[14.2,-10],[10.5,16.6]]
box: core.keys.positions_mm=[[1.6,-2.1]]
box: core.keys.positions_mm=[[5.5,2.2]]
box: core.keys.positions_mm=[[10.5,-10],[11.7,-9.1]]
box: core.keys.positions_mm=[[5,5.5]] core.keys.size_mm=[3,3,5.2]
box: core.keys.size_mm=[3,3,8.3]
box: mechanics.interface=frictionless
box: core.keys.size_mm=[9,14,1.5]
box: shell.slits.depth_mm=11.1
box: shell.seal_layer_mm=1.9
box: as_built.magnets=[{face=3,magnet=2,dent_mm=1.0}] mechanics.correction=large-strain
box: as_built.magnets=[{face=3,magnet=2,dent_mm=1.9}]
box: core.wire_channel_mm=[1,4.6]
box: core.bay_mm=[25,29,38]
box: core.bay_mm=[24.9,28.9,37.5]
box: mould.style=one-piece body.open_faces=[] core.bay_mm=[5,5,5]
box: magnets.shape=block magnets.size_mm=[4.5,5.2] magnets.positions_mm=[[3,-6],[-7,2],[5,-2]]
reverse box: shell.pocket_depth_mm=1.1
reverse box: magnets.height_mm=4.8
reverse box: magnets.positions_mm=[[2.2,-2],[-3,6]]
reverse box: magnets.positions_mm=[[5.5,-2],[6.1,2.4]]
reverse box: magnets.positions_mm=[[13.1,-2],[-3,15.4]]
reverse box: magnets.depth_mm=2.2
reverse box: sensors.positions_mm=[[4.2,1.5],[4.4,4.8]]
reverse box: sensors.positions_mm=[[20.2,1.5],[-2,22.3]]
reverse box: as_built.magnets=[{face=3,magnet=2,dent_mm=0.4}]
pad: core.recess_depth_mm=5.2
pad: shell.pocket_depth_mm=6.2 shell.thickness_mm=6
pad: magnets.positions_mm=[[18.6,-6],[-7,2],[5,15.4]]
pad: magnets.positions_mm=[[3,-6],[-7,2],[5,-3]]
pad: core.keys.positions_mm=[[9,9]] core.keys.size_mm=[2,2,1]
pad: core.bay_mm=[10,9,3.2]
pad: core.bay_mm=[39,33,3]
pad: mould.style=one-piece contact_grid.count=[17,12]
pad: contact_grid.count="fill" contact_grid.pitch_mm=18
cylinder: shell.thickness_mm=20.5
cylinder: core.recess_depth_mm=15.5
cylinder: core.recess_depth_mm=4.3 core.wire_channel_mm=[1,3.8]
cylinder: arrangement=sensors-in-shell
cylinder: mechanics.interface=frictionless mechanics.slip.rim=held
sleeve: core.recess_outer_radius_mm=23.5
sleeve: shell.pocket_depth_mm=8.3
sleeve: magnets.depth_mm=7.6
sleeve: magnets.depth_mm=0.55
sleeve: magnets.positions_mm=[[26.5,-6],[5,19.6]]
sleeve: magnets.positions_mm=[[3,-6],[4.5,-2.7]]
sleeve: magnets.positions_mm=[[3,18.4],[-7,2]]
cylinder: sensors.positions_mm=[[19.8,1.5],[-2,13.6]]
sleeve: sensors.depth_below_core_face_mm=2.65
sleeve: sensors.package_mm=[3.8,9.9,1.2]
sleeve: press.depths_mm=[1,4.85]
sleeve: contact_grid.count=[22,14]
sleeve: contact_grid.count=[4,16] indenter.tip_count=2
cylinder: core.keys.positions_mm=[[1.2,0.6]]
cylinder: core.keys.positions_mm=[[11,6],[12.4,6.9]]
cylinder: core.keys.positions_mm=[[5,5.5]] core.keys.size_mm=[3,3,8.5]
cylinder: shell.slits.depth_mm=7.4
cylinder: body.sensed_faces=[1,2]
cylinder: magnets.positions_mm=[[3,-6],[-7,2],[1,14.3]] shell.slits.depth_mm=6.8
cylinder: core.bay_mm=[9,10,37.5]
cylinder: core.bay_mm=[20.2,20.3,12]
closed cylinder: core.bay_mm=[9,10,12] shell.slits.depth_mm=3
closed cylinder: mould.style=one-piece
capsule: body.bore_mm=33
capsule: magnets.positions_mm=[[1.5,-4],[-4.5,19.8]]
closed capsule: shell.seal_layer_mm=2.2
closed sphere: contact_grid.count="fill" contact_grid.pitch_mm=26
sphere: core.keys.positions_mm=[[0.5,0.3]] core.keys.size_mm=[2,2,1.5]
dome: shell.thickness_mm=24.2
dome: core.recess_depth_mm=7.3
dome of silicone: press.depths_mm=[1,12.4]
hollow dome: core.keys.positions_mm=[[9,9]] core.keys.size_mm=[2,2,1]
hollow dome: contact_grid.count=[16,14]
"""
TIGHT = """
box: shell.seal_layer_mm=1.74
box: as_built.magnets=[{face=3,magnet=2,dent_mm=1.74}] shell.seal_layer_mm=0
box: core.bay_mm=[23.1,27.1,36.5]
box: magnets.depth_mm=[0.61,2.6,0.9] shell.seal_layer_mm=0
box: core.keys.positions_mm=[[13.9,-10],[10.5,14.2]]
sleeve: press.depths_mm=[1,4.79]
sleeve: shell.pocket_depth_mm=7.98
sleeve: magnets.depth_mm=0.7
sleeve: magnets.positions_mm=[[3,-6],[4.5,-1.0]]
cylinder: shell.slits.depth_mm=6.99
cylinder: core.bay_mm=[19.8,20.1,12]
cylinder: core.keys.positions_mm=[[13.0,4.0],[7.5,11.3]]
closed capsule: shell.seal_layer_mm=1.8
reverse box: magnets.height_mm=4.6
reverse box: shell.pocket_depth_mm=1.3
pad: magnets.positions_mm=[[3,-6],[-7,2],[17.4,14.5]]
"""
"""What still fits, near its limit: each takes a little more than the record of what is refused allows."""


KEY = re.compile(r"\b[a-z_]+[._][a-z_*]+\b|body|indenter|sensor")
FIX = re.compile(
    r"\b(Make|Move|Lower|Raise|Use|Choose|Change|Take|Seat|Leave|Set|Give|Press|Turn|Deepen|Space|"
    r"would fit)\b"
)
PROPOSED = re.compile(r"([\w.]+) would fit with (\w+) = (.*)")


ABOUT_PRESSES = re.compile("contact_grid|indenter|press")
ABOUT_BOARDS = re.compile("sensors\\.")
QUICKER = {
    "box": "body.sensed_faces=[1,2,3]",
    "closed box": "body.sensed_faces=[1,3]",
    "cylinder": "body.sensed_faces=[1,3,4] mould.style=one-piece",
    "sleeve": "body.sensed_faces=[2,3]",
    "closed cylinder": "body.sensed_faces=[2,3]",
    "capsule": "body.sensed_faces=[1,3]",
    "closed capsule": "body.sensed_faces=[1,3]",
    "sphere": "body.sensed_faces=[1,3]",
    "closed sphere": "body.sensed_faces=[1]",
}
"""Faces of what takes long with all of them, and a mould without pins."""


def changed(name, changes):
    given = f"{QUICKER.get(name, '')} {changes}".split()
    return ObjectSpec.model_validate(with_overrides(deepcopy(OBJECTS[name]), given))


def cases_of(name):
    return [case for case in CASES.strip().splitlines() if case.startswith(f"{name}: ")]


def problems(name, changes):
    spec = changed(name, changes)
    sentences = list(problems_of(spec, table=ABOUT_PRESSES.search(changes) is not None))
    if ABOUT_BOARDS.search(changes) and spec.arrangement == "sensors-in-core":
        sentences += filter(None, [boards_across_edges(spec)])
    return sentences


@pytest.mark.parametrize("name", [name for name in OBJECTS if cases_of(name)])
def test_what_does_not_fit_is_told_by_its_key_with_a_fix(name):
    """One test for an object: calls are checked for shapes in the first of every test alone."""
    for case in cases_of(name):
        sentences = problems(*case.split(": ", 1))
        assert sentences, case
        untold = [one for one in sentences if not (KEY.search(one) and FIX.search(one))]
        assert not untold, case


@pytest.mark.parametrize("name", [name for name in OBJECTS if cases_of(name)])
def test_what_is_proposed_instead_fits(name):
    for case in cases_of(name):
        changes = case.split(": ", 1)[1]
        for sentence in problems(name, changes):
            if match := PROPOSED.search(sentence):
                table, key, value = match.groups()
                better = f"{changes} {table}.{key}={value.replace(' ', '')}"
                told = problems(name, better)
                assert not any(f"{table} would fit" in one for one in told), (case, told)


def test_what_fits_is_not_refused():
    """Every object as it is, but those that take long and are much like others, then the tight ones."""
    as_is = [f"{name}: " for name in OBJECTS if name not in ("ellipsoid", "closed capsule")]
    for case in [*as_is, *TIGHT.strip().splitlines()]:
        name, changes = case.split(": ", 1)
        spec = changed(name, changes)
        assert not problems_of(spec, table=ABOUT_PRESSES.search(changes) is not None), case
