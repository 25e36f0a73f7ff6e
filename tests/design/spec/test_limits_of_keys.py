"""Limits of every key that has its own, entered twice; what all numbers share, on both sides."""

import typing

import pytest
from pydantic import BaseModel, TypeAdapter, ValidationError

from design.spec.base import LARGEST, Count, Finite, NonNegative, Positive, RecoilPermeability
from design.spec.object import ObjectSpec

SHARED = {"gt 0", "ge 0", f"le {LARGEST:g}", f"ge {-LARGEST:g}"}
"""Of `Positive`, `NonNegative` and `Finite`."""
WANTED = """
name: most 80
body.open_faces: ge 1, le 6
body.sensed_faces: ge 1, le 6
silicone.poisson_ratio: ge -0.3, le 0.5
silicone.layers.modulus_ratio: ge 0.001, le 1000
silicone.prony.fraction: lt 1
silicone.peel_share: le 1
magnets.recoil_permeability: ge 1, le 2
magnets.temperature_c: ge -40, le 150
magnets.turns: ge 1
magnets.positions_mm: least 1
magnets.tilt_deg: ge -30, le 30
core.wires_per_sensor: ge 1
sensors.axes: least 1
sensors.count_per_face: ge 1, le 12
sensors.first_azimuth_deg: least 1
sensors.positions_mm: least 1, most 12
sensors.rotations_deg: least 1, most 12
sensors.gain_tolerance: lt 0.5
sensors.cross_axis_tolerance: lt 0.5
load_cell.output_mv_per_v: ge -10, le 10
load_cell.newtons_per_v: ge -500, le 500
load_cell.zero_v: le 5
environment.earth_field_ut: le 100
environment.magnets.recoil_permeability: ge 1, le 2
environment.steel_plates.relative_permeability: ge 1
contact_grid.count: ge 2, le 100
indenter.vertices_mm: least 4
indenter.tilt_deg: ge -45, le 45
indenter.direction_deg: ge -60, le 60
press.depths_mm: least 2
mesh.rim_edge_ratio: ge 0.1, le 1
mesh.magnet_sides: ge 6, le 64
mechanics.slip.shift_mm: ge -3, le 3
mechanics.slip.rotation_deg: ge -10, le 10
score.hull_frames: ge 12
protocol.presses_per_place: ge 3
protocol.frames_per_press: ge 4
protocol.rest_frames_per_press: ge 2
protocol.peak_force_spread: lt 0.9
collection.faces: ge 1, le 6, least 1
collection.frames_per_case: ge 4
collection.non_contact_cases: ge 1
collection.dual_poses: ge -360, ge -500, le 360, le 500
collection.triple_poses: ge -360, ge -500, le 360, le 500
collection.grasp_faces: ge 1, le 6
collection.presses: ge 1
collection.contacts: ge 1, le 5
collection.tangential_share: le 2
collection.hysteresis: lt 0.5
training.history_frames: le 100
training.hidden_units: ge 1, least 1
training.epochs: ge 1
training.batch_size: ge 1
training.patience_epochs: ge 1
training.ensemble: ge 1, le 20
training.trees: le 500
training.coverage: lt 1
training.twins: ge 2, le 1000
inversion.contacts: ge 1, le 8
inversion.least_force_n: le 100
inversion.model_error: lt 1
inversion.window_frames: ge 1
inversion.tangential_share: le 2
limits.saturation_margin: lt 1
tolerances.core_shift_mm: le 0.6
tolerances.core_yaw_deg: le 2
as_built.magnets.face: ge 1, le 6
as_built.magnets.magnet: ge 1
as_built.sensors.face: ge 1, le 6
as_built.sensors.sensor: ge 1
search.objectives: least 1, most 4
search.forces_n: most 8
search.polish_steps: le 1000
search.trials: ge 1
search.batch: ge 1, le 1024
search.leaders: ge 1
search.finalists: ge 1
search.vary.magnet_count: ge 1, least 1, most 20
search.vary.magnet_part: least 1, most 20
search.vary.magnet_tilt_deg: le 30
search.vary.sensor_count: ge 1, le 12, least 1, most 20
search.vary.sensor_chip: least 1, most 20
search.vary.sensor_turn_deg: least 1, most 20
search.vary.sensor_range_mt: least 1, most 20
search.vary.shell_thickness_mm: least 1, most 20
search.vary.silicone: least 1, most 20
search.vary.core_size_mm: least 1, most 20
search.limits.resting_share: le 1
search.limits.parts_per_face: ge 1
search.limits.places_worse: le 1
mould.wall_mm: le 100
mould.play_mm: le 2
mould.flange_mm: le 100
mould.dowel_draft_deg: le 30
mould.draft_deg: le 10
mould.pour_mm: le 100
mould.vent_mm: le 100
mould.silicone_waste: le 2
printer.wall_mm: le 100
printer.feature_mm: le 100
printer.hole_mm: le 100
printer.clearance_mm: le 2
printer.draft_deg: lt 45
export.mesh_tolerance_mm: ge 0.001, le 5
export.mesh_angle_rad: le 1
"""
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
    found = {key: ", ".join(sorted(of - SHARED)) for key, of in keys(ObjectSpec)}
    assert [f"{key}: {text}" for key, text in found.items() if text] == WANTED.split("\n")[1:-1]


@pytest.mark.parametrize(
    ("kind", "taken", "refused"),
    [
        (Positive, [1e-9, 1e8], [0, -1e-9, 1.0001e8, float("nan"), float("inf")]),
        (NonNegative, [0, 1e8], [-1e-9, 1.0001e8, float("nan"), float("inf")]),
        (Finite, [-1e8, 0, 1e8], [-1.0001e8, 1.0001e8, float("nan"), -float("inf")]),
        (RecoilPermeability, [1, 2], [0.999, 2.001]),
        (Count, [1, 10**9], [0, -1, 1.5]),
    ],
)
def test_numbers_of_a_kind_end_at_its_limits(kind, taken, refused):
    adapter = TypeAdapter(kind)
    for value in taken:
        assert adapter.validate_python(value) == value
    for value in refused:
        with pytest.raises(ValidationError):
            adapter.validate_python(value)
