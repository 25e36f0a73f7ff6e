"""What the kinds of body answer, of objects off their symmetries, on record."""

import numpy as np
import pytest

from design.body.surface_chart import steepest_reach_mm
from design.layout.body import body_of
from design.layout.mould.frame import mould_frame
from tests.support.objects.worked_objects import OBJECTS, worked
from tests.support.recorded_facts import assert_on_record, told


def of_surface(name, mesh):
    if mesh is None:
        return f"{name}: none"
    triangles = 0 if name == "core" else len(mesh.faces)
    sizes = [mesh.volume, mesh.area, triangles, *mesh.bounds.ravel()]
    return told(f"{name}: volume, area, triangles, box", sizes)


@pytest.mark.parametrize("name", OBJECTS)
def test_a_body_answers_as_on_record(name):
    spec = worked(name)
    body, sensed = body_of(spec), spec.body.sensed
    room, what = body.room_for_recesses
    axes = mould_frame(spec).axes
    azimuth = body.parting_azimuth(abs(axes.T) @ np.asarray(spec.body.size_mm))
    less = body.less(0.7)
    points = np.random.default_rng(1).uniform(-1.1, 1.1, (60, 3)) * body.half_mm
    lines = [
        f"{body.name}: opens {body.opening}, {what}",
        told("room, silicone, floor", [room, body.silicone_mm, body.core_floor_mm]),
        told("thickness below", min(body.thickness_below_mm, 1e6)),
        told("corners", body.corners_mm),
        told("cast corners", body.cast_corners_mm(0.6, sensed[:2])),
        told("passage", body.passage_mm(axes)),
        told("parting", azimuth if azimuth is not None else -1.0),
        told("span of the core", body.core_span_mm(0.7)),
        told("less a layer", [*less.size_mm, less.thickness_mm]),
        told("volume", body.volume_mm3()),
        told("ends", [[*normal, level] for normal, level in body.support_ends] or [0.0]),
        told("distances to the core", body.core_distance_mm(points[: 30 if body.sampled else 60])),
        of_surface("outer", body.outer_surface()),
        *(of_surface("slab", slab) for slab in body.end_slabs(1.3)),
    ]
    if not body.sampled:
        lines += [
            of_surface("core surface", body.core_surface()),
            of_surface("cavity", body.cavity_surface()),
            of_surface("cast", body.cast_surface(0.6, sensed[:2])),
            told("cast volume", body.cast_volume_mm3(0.6, sensed[:2])),
            told("cast volume, top alone", body.cast_volume_mm3(0.6, (1,))),
        ]
    else:
        lines += [line for number in sensed[:2] for line in of_frame(body.core_frame(number))]
    lines += [line for number in sensed[:2] for line in of_frame(body.frame(number))]
    assert_on_record("bodies", name, lines)


def of_frame(frame):
    """Border, areas, lengths and where lines meet the surface, in ten places; NaN as −99."""
    turn = np.linspace(0.2, 6.0, 5)
    xy = 0.6 * np.column_stack([np.cos(turn), np.sin(turn)]) * frame.half_extents_mm
    lengths = frame.from_plane(xy)
    back, stretch = frame.to_plane(lengths), frame.area_stretch(lengths)
    above = frame.to_object(np.column_stack([xy, np.full(5, 2.0)]))
    onto = frame.onto(above, frame.normal + 0.2 * frame.x)
    border = frame.border_mm(7)
    rows = np.vstack([lengths, back, onto[:, :2], np.column_stack([stretch, onto[:, 2]]), border])
    sizes = [*frame.centre_mm, *frame.half_extents_mm, *frame.lengths_mm.ravel()]
    yield told(f"face {frame.number}", sizes)
    yield told("its places", np.nan_to_num(rows, nan=-99.0))


@pytest.mark.parametrize("name", ["box", "sphere"])
def test_what_faces_share_cannot_be_written_to(name):
    body = body_of(worked(name))
    for frame in (body.frame(2), body.core_frame(3)):
        for shared in (frame.axes, frame.lengths_mm):
            with pytest.raises(ValueError, match="read-only"):
                shared[0, 0] = 1.0


def test_a_patch_reaches_to_60_degrees_and_nowhere_without_a_cap():
    """On a ball R sin 60°; on an ellipse x² / a² + z² / c² = 1 where its slope is √3."""
    assert steepest_reach_mm(10.0, 10.0) == pytest.approx(10.0 * np.sin(np.pi / 3))
    reach = steepest_reach_mm(12.0, 5.0)
    slope = 5.0 / 12.0 * (reach / 12.0) / np.sqrt(1 - (reach / 12.0) ** 2)
    assert slope == pytest.approx(np.sqrt(3.0))
    assert steepest_reach_mm(0.0, 5.0) == steepest_reach_mm(-1.0, 5.0) == 0.0
