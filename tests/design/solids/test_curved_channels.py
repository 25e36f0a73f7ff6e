"""Wire channels of curved cores: open below the surface from the wire hole to every recess."""

import cadquery as cq
import numpy as np
import pytest

from design.body.triangles import block_surface
from design.fit.parts import check_parts
from design.layout.boards import wire_channels
from design.layout.body import core_frames
from design.layout.places.positions import board_places
from design.solids.core import make_core
from design.spec.object import ObjectSpec


def ball(**core):
    content = {"kind": "sphere", "size_mm": [60.0] * 3, "sensed_faces": [2]}
    channels = {"wall_mm": 6.0, "wire_channel_mm": [2.0, 1.0], **core}
    sensors = {"radius_mm": 9.0, "positions_mm": [[9.0, 0.0], [0.0, 9.0]], "count_per_face": 2}
    return ObjectSpec.model_validate(
        {"name": "t", "body": content, "core": channels, "sensors": sensors}
    )


def below_surface(spec, depth_mm):
    """Points along the way from the wire hole to each sensor, so deep below the core's surface."""
    (frame,), ((_, places),) = core_frames(spec), board_places(spec)
    shares = np.linspace(0.25, 0.6, 6)[:, None]
    ways = np.concatenate([shares * np.array(place[:2]) for place, _ in places])
    return frame.to_object(np.column_stack([ways, np.full(len(ways), -depth_mm)]))


@pytest.mark.parametrize(("width", "open_below"), [(2.0, True), (0.0, False)])
def test_a_channel_reaches_its_depth_all_the_way(width, open_below):
    spec = ball(
        wire_channel_mm=(width, 1.0), recess_inner_radius_mm=6.0, recess_outer_radius_mm=12.0
    )
    core = make_core(spec)
    inside = [core.isInside(cq.Vector(*point)) for point in below_surface(spec, 0.9)]
    assert not any(inside) if open_below else all(inside)


def test_bodies_of_triangles_have_the_same_channel():
    spec = ball()
    (frame,) = core_frames(spec)
    places = [(9.0, 0.0, 0.0), (0.0, 9.0, 0.0), (0.0, 0.0, 0.0)]
    channels = wire_channels(spec, frame, places, 0.5)
    assert len(channels) == 2, "a recess over the wire hole needs none"
    solids = [block_surface(block) for block in channels]
    inside = np.any([solid.contains(below_surface(spec, 0.9)) for solid in solids], axis=0)
    assert inside.all()
    assert not np.any([solid.contains(below_surface(spec, 4.0)) for solid in solids])


def test_channels_through_the_wall_are_refused():
    assert not [problem for problem in check_parts(ball()) if "wire_channel" in problem]
    (told,) = [p for p in check_parts(ball(wall_mm=2.5)) if "wire_channel" in p]
    assert "curved core's fall" in told
