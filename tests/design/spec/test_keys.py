"""Limits and defaults of the keys, entered twice; what all numbers share, on both sides."""

import typing
from collections.abc import Iterator
from itertools import product

import pytest
from pydantic import BaseModel, TypeAdapter, ValidationError, create_model

from design.errors import SpecError
from design.spec.base import Count, Force, Length, Offset, RecoilPermeability, Remanence
from design.spec.object import ObjectSpec

WANTED = """
name: most 80
seed: ge 0, le 2.14748e+09
body.size_mm: gt 0, le 1e+08
body.open_faces: ge 1, le 6
body.sensed_faces: ge 1, le 6
body.bore_mm: gt 0, le 1000
body.scale: ge 0.0001, le 10000
shell.thickness_mm: ge 0.3, le 200
shell.pocket_diameter_mm: gt 0, le 1000
shell.pocket_depth_mm: gt 0, le 1000
shell.seal_layer_mm: ge 0, le 1000
shell.dent_mm: ge 0, le 1000
shell.slits.width_mm: gt 0, le 1000
shell.slits.depth_mm: ge 0, le 1000
shell.slits.end_mm: ge 0, le 1000
silicone.youngs_modulus_mpa: ge 0.001, le 50
silicone.youngs_modulus_range_mpa: ge 0.001, le 50
silicone.poisson_ratio: ge -0.3, le 0.5
silicone.density_g_per_cm3: ge 0.005, le 20
silicone.layers.thickness_mm: gt 0, le 1000
silicone.layers.modulus_ratio: ge 0.001, le 1000
silicone.prony.fraction: gt 0, lt 1
silicone.prony.time_s: ge 0.0001, le 1e+07
silicone.elongation_percent: ge 1, le 3000
silicone.thinnest_wall_mm: ge 0.05, le 50
magnets.diameter_mm: gt 0, le 1000, least 1
magnets.inner_diameter_mm: ge 0, le 1000, least 1
magnets.size_mm: gt 0, le 1000, least 1
magnets.height_mm: gt 0, le 1000, least 1
magnets.remanence_t: ge 0.01, le 2, least 1
magnets.recoil_permeability: ge 1, le 2
magnets.temperature_c: ge -40, le 150
magnets.depth_below_core_face_mm: ge 0, le 1000
magnets.positions_mm: ge -1000, le 1000, least 1
magnets.depth_mm: gt 0, le 1000
magnets.tilt_deg: ge -30, le 30
core.wall_mm: ge 0.3, le 200
core.recess_width_mm: gt 0, le 1000
core.recess_inner_radius_mm: gt 0, le 1000
core.recess_outer_radius_mm: gt 0, le 1000
core.recess_depth_mm: gt 0, le 1000
core.hub_radius_mm: gt 0, le 1000
core.wire_hole_top_diameter_mm: gt 0, le 1000
core.wire_hole_side_diameter_mm: gt 0, le 1000
core.wire_channel_width_mm: ge 0, le 1000
core.wire_channel_depth_mm: gt 0, le 1000
core.wires_per_sensor: ge 1, le 20
core.bay_mm: gt 0, le 1000
core.keys.positions_mm: ge -1000, le 1000
core.keys.size_mm: gt 0, le 1000
core.keys.height_mm: gt 0, le 1000
sensors.axes: least 1
sensors.count_per_face: ge 1, le 12
sensors.radius_mm: gt 0, le 1000
sensors.depth_below_core_face_mm: ge 0, le 1000
sensors.first_azimuth_deg: ge -720, le 720, least 1
sensors.positions_mm: ge -1000, le 1000, least 1, most 12
sensors.package_mm: gt 0, le 1000
sensors.chip_mm: gt 0, le 1000
sensors.mount_rotation_deg: ge -720, le 720
sensors.rotations_deg: ge -720, le 720, least 1, most 12
sensors.counts_per_mt: ge 0.1, le 1e+06
sensors.range_mt: ge 0.01, le 3000
sensors.noise_counts: gt 0, le 32768
sensors.gain_tolerance: ge 0, lt 0.5
sensors.cross_axis_tolerance: ge 0, lt 0.5
sensors.zeroing_counts: ge 0, le 1e+06
sensors.drift_counts: ge 0, le 1e+06
sensors.frame_rate_hz: ge 0.01, le 100000
load_cell.capacity_n: ge 0.1, le 10000
load_cell.output_mv_per_v: ge -10, le 10
load_cell.newtons_per_v: ge -500, le 500
load_cell.zero_v: ge 0, le 5
environment.earth_field_ut: ge 0, le 100
environment.earth_direction: ge -10000, le 10000
environment.magnets.position_mm: ge -1000, le 1000
environment.magnets.axis: ge -10000, le 10000
environment.magnets.diameter_mm: gt 0, le 1000
environment.magnets.height_mm: gt 0, le 1000
environment.magnets.remanence_t: ge 0.01, le 2
environment.magnets.recoil_permeability: ge 1, le 2
environment.steel_plates.position_mm: ge -1000, le 1000
environment.steel_plates.normal: ge -10000, le 10000
environment.steel_plates.relative_permeability: ge 1, le 1e+12
contact_grid.count: ge 2, le 100
contact_grid.pitch_mm: gt 0, le 1000
indenter.radius_mm: gt 0, le 1000
indenter.length_mm: gt 0, le 1000
indenter.size_mm: gt 0, le 1000
indenter.fillet_mm: ge 0, le 1000
indenter.vertices_mm: ge -1000, le 1000, least 4
indenter.yaw_deg: ge -720, le 720
indenter.tilt_deg: ge -45, le 45
indenter.direction_deg: ge -60, le 60
indenter.tip_spacing_mm: gt 0, le 1000
press.depths_mm: gt 0, le 1000, least 2
mesh.edge_mm: ge 0.02, le 100
mesh.surface_edge_mm: ge 0.02, le 100
mesh.rim_edge_ratio: ge 0.1, le 1
mesh.envelope_mm: ge 0.0001, le 5
mesh.magnet_sides: ge 6, le 64
mechanics.slip.shift_mm: ge -3, le 3
mechanics.slip.rotation_deg: ge -10, le 10
score.force_n: ge 0.001, le 500
protocol.presses_per_place: ge 3, le 1e+06
protocol.frames_per_press: ge 4, le 1e+06
protocol.rest_frames_per_press: ge 2, le 1e+06
protocol.peak_force_n: ge 0.001, le 500
protocol.lateral_jitter_mm: ge 0, le 20
protocol.force_noise_n: ge 0, le 20
collection.faces: ge 1, le 6, least 1
collection.frames_per_case: ge 4, le 1e+08
collection.non_contact_cases: ge 1, le 100000
collection.dual_poses: ge -1000, ge -720, le 1000, le 720
collection.triple_poses: ge -1000, ge -720, le 1000, le 720
collection.grasp_faces: ge 1, le 6
collection.grasp_force_n: ge 0.001, le 500
collection.random_grasps: ge 0, le 100000
collection.presses: ge 1, le 1e+09
collection.contacts: ge 1, le 5
collection.tangential_share: ge 0, le 2
training.history_frames: ge 0, le 100
training.hidden_units: ge 1, le 1e+07, least 1, most 20
training.epochs: ge 1, le 100000
training.ensemble: ge 1, le 20
training.trees: ge 0, le 500
training.coverage: gt 0, lt 1
training.twins: ge 2, le 1000
inversion.contacts: ge 1, le 8
inversion.model_error: ge 0, lt 1
inversion.drift_counts: ge 0, le 1e+06
inversion.window_frames: ge 1, le 100000
inversion.tangential_share: ge 0, le 2
limits.position_bound_mm: ge 0.001, le 100
limits.detectable_force_n: ge 0.001, le 500
limits.saturation_margin: gt 0, lt 1
tolerances.magnet_seat_mm: ge 0, le 5
tolerances.magnet_seat_depth_mm: ge 0, le 5
tolerances.magnet_tilt_deg: ge 0, le 30
tolerances.remanence_relative: ge 0, le 0.5
tolerances.sensor_seat_mm: ge 0, le 5
tolerances.sensor_rotation_deg: ge 0, le 30
tolerances.sensor_gain_relative: ge 0, le 0.5
tolerances.sensor_offset_ut: ge 0, le 10000
tolerances.core_shift_mm: ge 0, le 0.6
tolerances.core_yaw_deg: ge 0, le 2
tolerances.modulus_relative: ge 0, le 1
tolerances.temperature_k: ge 0, le 60
tolerances.earth_field_ut: ge 0, le 100
as_built.magnets.face: ge 1, le 6
as_built.magnets.magnet: ge 1, le 100000
as_built.magnets.centre_mm: ge -1000, le 1000
as_built.magnets.axis: ge -10000, le 10000
as_built.magnets.remanence_t: ge 0.01, le 2
as_built.magnets.dent_mm: ge 0, le 1000
as_built.sensors.face: ge 1, le 6
as_built.sensors.sensor: ge 1, le 100000
as_built.sensors.position_mm: ge -1000, le 1000
as_built.sensors.rotation_deg: ge -720, le 720
search.objectives: least 1, most 4
search.forces_n: ge 0.001, le 500, most 8
search.polish_steps: ge 0, le 1000
search.trials: ge 1, le 1e+07
search.seconds: gt 0, le 1e+08
search.leaders: ge 1, le 100000
search.finalists: ge 1, le 10000
search.vary.magnet_count: ge 1, le 100000, least 1, most 20
search.vary.magnet_part: least 1, most 20
search.vary.magnet_sizes: least 1, most 20
search.vary.magnet_reach_mm: gt 0, le 1000
search.vary.magnet_depth_mm: ge -1000, le 1000
search.vary.magnet_tilt_deg: gt 0, le 30
search.vary.magnet_grade: least 1, most 20
search.vary.sensor_count: ge 1, le 12, least 1, most 20
search.vary.sensor_reach_mm: gt 0, le 1000
search.vary.sensor_chip: least 1, most 20
search.vary.shell_thickness_mm: ge 0.3, le 200, least 1, most 20
search.vary.silicone: least 1, most 20
search.limits.places_worse: ge 0, le 1
search.limits.times_start: gt 0, le 10000
mould.wall_mm: ge 0.1, le 100
mould.parting_azimuth_deg: ge -720, le 720
mould.flange_mm: ge 0.1, le 100
mould.draft_deg: ge 0, le 10
mould.pour_mm: ge 0.1, le 100
printer.bed_mm: ge 20, le 5000
printer.wall_mm: ge 0.1, le 100
printer.feature_mm: ge 0.1, le 100
printer.hole_mm: ge 0.1, le 100
printer.clearance_mm: ge 0.005, le 2
"""
DEFAULTS = """
seed: 1
arrangement: 'sensors-in-core'
body.kind: 'box'
body.size_mm: (42.0, 42.0, 42.0)
body.open_faces: (6,)
body.inside: 'core'
body.bore_mm: 10.0
body.unit: 'mm'
body.scale: 1.0
shell.thickness_mm: 8.0
shell.pocket_diameter_mm: 6.0
shell.pocket_depth_mm: 3.0
shell.seal_layer_mm: 0.0
shell.dent_mm: 0.0
shell.slits.width_mm: 1.0
shell.slits.depth_mm: 0.0
shell.slits.end_mm: 8.0
silicone.name: 'Platsil Gel-10'
silicone.youngs_modulus_mpa: 0.414
silicone.youngs_modulus_range_mpa: (0.15, 0.54)
silicone.poisson_ratio: 0.4999
silicone.density_g_per_cm3: 1.07
silicone.cure: 'platinum'
silicone.elongation_percent: 970.0
silicone.thinnest_wall_mm: 1.0
magnets.shape: 'disk'
magnets.diameter_mm: 6.0
magnets.inner_diameter_mm: 0.0
magnets.size_mm: (5.0, 5.0)
magnets.height_mm: 1.0
magnets.remanence_t: 1.43
magnets.recoil_permeability: 1.05
magnets.temperature_c: 20.0
magnets.depth_below_core_face_mm: 0.0
magnets.positions_mm: ((0.0, 0.0), (10.0, 10.0), (-10.0, 10.0), (-10.0, -10.0), (10.0, -10.0))
magnets.tilt_deg: ()
magnets.north: ()
core.wall_mm: 4.5
core.recess_width_mm: 7.0
core.recess_inner_radius_mm: 4.5
core.recess_outer_radius_mm: 11.0
core.recess_depth_mm: 3.0
core.hub_radius_mm: 2.0
core.wire_hole_top_diameter_mm: 2.0
core.wire_hole_side_diameter_mm: 4.0
core.wire_channel_width_mm: 0.0
core.wire_channel_depth_mm: 1.0
core.wires_per_sensor: 4
core.keys.positions_mm: ()
core.keys.size_mm: (3.0, 3.0)
core.keys.height_mm: 1.5
sensors.part: 'TMAG5273A1'
sensors.axes: ('X', 'Y', 'Z')
sensors.averaging: 16
sensors.count_per_face: 3
sensors.radius_mm: 8.585
sensors.depth_below_core_face_mm: 2.3
sensors.first_azimuth_deg: (240.0, 180.0, 240.0, 60.0, 300.0)
sensors.package_mm: (6.6, 6.2, 1.6)
sensors.chip_mm: (2.9, 2.8, 1.25)
sensors.chip: 'inward'
sensors.mount_rotation_deg: (0.0, 0.0, 0.0)
sensors.counts_per_mt: 820.0
sensors.range_mt: 40.0
sensors.noise_counts: (22.0, 22.0, 11.0)
sensors.gain_tolerance: 0.0
sensors.cross_axis_tolerance: 0.0
sensors.zeroing_counts: 10.0
sensors.drift_counts: 60.0
sensors.frame_rate_hz: 10.5
load_cell.kind: 'none'
load_cell.rate_sps: 80
load_cell.capacity_n: 49.03
load_cell.output_mv_per_v: 1.0
load_cell.newtons_per_v: 24.5
load_cell.zero_v: 2.5
environment.earth_field_ut: 0.0
environment.earth_direction: (0.0, 0.0, -1.0)
environment.magnets.axis: (0.0, 0.0, 1.0)
environment.magnets.diameter_mm: 10.0
environment.magnets.height_mm: 5.0
environment.magnets.remanence_t: 1.3
environment.magnets.recoil_permeability: 1.05
environment.steel_plates.relative_permeability: 1000.0
contact_grid.count: 'fill'
contact_grid.pitch_mm: 3.0
indenter.kind: 'hemisphere'
indenter.radius_mm: 5.0
indenter.length_mm: 10.0
indenter.size_mm: (10.0, 10.0)
indenter.fillet_mm: 0.0
indenter.yaw_deg: 0.0
indenter.tilt_deg: (0.0, 0.0)
indenter.direction_deg: (0.0, 0.0)
indenter.friction: 'none'
indenter.tip_count: 1
press.depths_mm: (0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0)
mesh.edge_mm: 4.0
mesh.surface_edge_mm: 1.7
mesh.rim_edge_ratio: 0.4
mesh.envelope_mm: 0.06
mesh.magnet_sides: 16
mechanics.element: 'taylor-hood'
mechanics.magnets: 'rigid'
mechanics.interface: 'bonded'
mechanics.slip.shift_mm: (0.0, 0.0, 0.0)
mechanics.slip.rotation_deg: (0.0, 0.0, 0.0)
mechanics.slip.rim: 'free'
mechanics.correction: 'none'
score.force_n: 8.0
score.channels: 'own'
protocol.presses_per_place: 6
protocol.frames_per_press: 40
protocol.rest_frames_per_press: 8
protocol.peak_force_n: (10.0, 20.0)
protocol.lateral_jitter_mm: 0.3
protocol.force_noise_n: 0.12
collection.kind: 'paper'
collection.faces: (1, 2, 3, 4, 5)
collection.frames_per_case: 1000
collection.non_contact_cases: 3
collection.grasp_faces: (3, 5)
collection.grasp_force_n: 17.0
collection.random_grasps: 0
collection.presses: 2000
collection.contacts: 1
collection.tangential_share: 0.0
training.model: 'compact'
training.hidden_units: (256, 256, 256)
training.epochs: 40
training.coverage: 0.9
training.twins: 10
inversion.contacts: 6
inversion.probes: 'free'
inversion.jaws: False
inversion.drift_counts: 0.0
inversion.window_frames: 1
inversion.tangential_share: 0.0
limits.use: 'grasp'
limits.position_bound_mm: 1.5
limits.detectable_force_n: 5.0
limits.saturation_margin: 0.1
tolerances.magnet_seat_mm: 0.1
tolerances.magnet_seat_depth_mm: 0.1
tolerances.magnet_tilt_deg: 2.0
tolerances.remanence_relative: 0.02
tolerances.sensor_seat_mm: 0.1
tolerances.sensor_rotation_deg: 2.0
tolerances.sensor_gain_relative: 0.02
tolerances.sensor_offset_ut: 100.0
tolerances.core_shift_mm: 0.3
tolerances.core_yaw_deg: 1.0
tolerances.modulus_relative: 0.1
tolerances.temperature_k: 5.0
tolerances.earth_field_ut: 50.0
as_built.magnets.flipped: False
as_built.sensors.rotation_deg: (0.0, 0.0, 0.0)
as_built.sensors.dead: ()
search.objectives: ('worst_position_bound_mm',)
search.forces_n: (1.0, 3.5, 12.0)
search.baseline: 'fresh'
search.polish_steps: 300
search.trials: 60
search.seconds: 2700.0
search.leaders: 6
search.finalists: 2
search.vary.layouts: 'per size'
search.vary.magnet_north: False
search.limits.places_worse: 0.02
search.limits.times_start: {}
mould.wall_mm: 1.5
mould.flange_mm: 8.0
mould.draft_deg: 0.0
mould.pour_mm: 6.0
mould.magnet_templates: 'flat'
printer.name: 'fdm-0.4'
printer.process: 'fdm'
printer.bed_mm: (220.0, 220.0, 240.0)
printer.wall_mm: 0.8
printer.feature_mm: 0.8
printer.hole_mm: 1.0
printer.clearance_mm: 0.1
"""
"""Of all keys that are not left open."""
WORDS = {"min_length": "least", "max_length": "most"}


def limits(annotation, metadata=()):
    """Of a field and of all that its type holds, but for other parts."""
    found = set()
    for one in metadata:
        found |= limits(None, getattr(one, "metadata", ()))
        for name in ("gt", "ge", "lt", "le", "min_length", "max_length"):
            value = getattr(one, name, None)
            if value is not None:
                found.add(f"{WORDS.get(name, name)} {value:g}")
    if typing.get_origin(annotation) is typing.Annotated:
        found |= limits(annotation.__origin__, annotation.__metadata__)
    for inner in typing.get_args(annotation):
        found |= limits(inner)
    return found


def parts(annotation):
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        yield annotation
    for inner in typing.get_args(annotation):
        yield from parts(inner)


def keys(model, before=""):
    for name, field in model.model_fields.items():
        inner = list(parts(field.annotation))
        if not inner:
            yield f"{before}{name}", limits(field.annotation, field.metadata)
        for part in inner:
            yield from keys(part, f"{before}{name}.")


def test_every_key_has_its_limits():
    found = {key: ", ".join(sorted(of)) for key, of in keys(ObjectSpec)}
    assert [f"{key}: {text}" for key, text in found.items() if text] == WANTED.split("\n")[1:-1]


def test_every_number_has_bounds_on_both_sides():
    """A value of another unit or a slip of the keyboard lies beyond one of them."""
    open_ended = []
    for key, one in typed_numbers(ObjectSpec):
        for value in (-9e12, 9e12, 10**13):
            try:
                one(value=value)
            except SpecError:
                continue
            open_ended.append((key, value))
    assert not open_ended


def defaults(model, before=""):
    for name, field in model.model_fields.items():
        inner = list(parts(field.annotation))
        if not inner and not field.is_required():
            yield f"{before}{name}", field.get_default(call_default_factory=True)
        for part in inner:
            yield from defaults(part, f"{before}{name}.")


def test_every_key_has_its_default():
    found = dict(defaults(ObjectSpec))
    dual, triple = found.pop("collection.dual_poses"), found.pop("collection.triple_poses")
    told = [f"{key}: {value!r}" for key, value in found.items() if value is not None]
    assert told == DEFAULTS.split("\n")[1:-1]
    level = {*product((-6, -3, 0, 3, 6), (-10.5, 10.5), (0,)), *product((-6, 0, 6), (-1.5,), (0,))}
    assert len(dual) == 26
    assert set(dual) == level | {(y, x, 90) for x, y, _ in level}
    upward = {*product((-3, 0, 3), (-6, 0), (0,)), (0, -3, 0)}
    assert len(triple) == 14
    assert set(triple) == upward | {(-x, -y, 180) for x, y, _ in upward}


def numbers(annotation, metadata=()) -> Iterator[typing.Any]:
    """Types of the numbers that a field holds, with their own limits."""
    if annotation in (float, int):
        yield typing.Annotated[annotation, *metadata] if metadata else annotation
    elif typing.get_origin(annotation) is typing.Annotated:
        yield from numbers(annotation.__origin__, annotation.__metadata__)
    else:
        for inner in typing.get_args(annotation):
            yield from numbers(inner, metadata)


def typed_numbers(model, before=""):
    """Every key that holds numbers, with their types as its part of the specification takes them."""
    for name, field in model.model_fields.items():
        for part in parts(field.annotation):
            yield from typed_numbers(part, f"{before}{name}.")
        bounds = tuple(one for one in field.metadata if not isinstance(one, type))
        for kind in numbers(field.annotation, bounds):
            yield f"{before}{name}", create_model("One", __base__=model.__base__, value=(kind, ...))


def test_no_key_takes_a_number_that_is_none():
    found = dict(typed_numbers(ObjectSpec))
    assert len(found) > 150
    for key, one in found.items():
        for value in (float("nan"), float("inf"), -float("inf")):
            with pytest.raises(SpecError, match="value"):
                pytest.fail(f"{key} takes {one(value=value)}")


@pytest.mark.parametrize(
    ("kind", "taken", "refused"),
    [
        (Length, [1e-9, 1e3], [0, -1e-9, 1.0001e3, float("inf")]),
        (Offset, [0, 1e3], [-1e-9, 1.0001e3, float("inf")]),
        (Force, [0.001, 500], [0.0009, 501]),
        (Remanence, [0.01, 2.0], [0.009, 2.01]),
        (RecoilPermeability, [1, 2], [0.999, 2.001]),
        (Count, [1, 10**5], [0, -1, 1.5, 10**5 + 1]),
    ],
)
def test_numbers_of_a_kind_end_at_its_limits(kind, taken, refused):
    adapter = TypeAdapter(kind)
    for value in taken:
        assert adapter.validate_python(value) == value
    for value in refused:
        with pytest.raises(ValidationError):
            adapter.validate_python(value)
