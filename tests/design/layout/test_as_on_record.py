"""Numbers of objects off their symmetries: all that `design.layout` works out, on record.

How the record was checked stands in it; where this fails after a deliberate change see
`tests/support/recorded_facts.py`.
"""

from itertools import combinations

import numpy as np
import pytest

from design.layout.blocks import core_keys, keys_volume_mm3, relief_slits, slits_volume_mm3
from design.layout.boards import (
    bay_block,
    board_blocks,
    cuts_of_core,
    gap_mm,
    mounted_sensors,
    passage_radius_mm,
    sensor_recesses,
    smallest_recess_wall_mm,
    wire_bundle_mm,
    wire_channels,
    wire_hole_diameter_mm,
)
from design.layout.body import body_of, core_frames, face_frames
from design.layout.core_hold import core_outlet, locators
from design.layout.core_sockets import roomiest_sockets, socket_beside
from design.layout.mould.frame import mould_frame, mould_style, parting, thin_at_seam, up
from design.layout.places.positions import (
    board_places,
    cover_mm,
    magnet_layout,
    sensor_layout,
    shell_body_layout,
)
from design.layout.pockets import (
    core_pockets,
    neighbours,
    shell_bodies,
    shell_pockets,
)
from design.layout.surface import sealed_body_surface, support_rings
from tests.support.objects.pocket_gaps import gap_across_edge_mm
from tests.support.objects.worked_objects import OBJECTS, worked
from tests.support.recorded_facts import assert_on_record, told

ALIKE = ("sleeve", "closed cylinder", "sphere", "ellipsoid", "dome of silicone")
"""What they differ in from the others is in their bodies (`tests/design/body/test_as_on_record.py`)."""


def corners(blocks):
    return np.concatenate([block.corners_mm for block in blocks]) if blocks else np.zeros((0, 3))


def tips(centres_mm, axes):
    """Points 1 mm beside centres, along axes given as columns."""
    return (centres_mm[:, None] + axes.transpose(0, 2, 1)).reshape(-1, 3)


def of_pockets(spec):
    frames = face_frames(spec)
    for name, faces in (("pockets", shell_pockets(spec)), ("core's pockets", core_pockets(spec))):
        every = [pocket for face in faces for pocket in face]
        if every:
            yield f"{name}: {every[-1].body.label}"
            yield told("their axes", np.concatenate([pocket.axis_ends_mm for pocket in every]))
            sizes = [[*p.reach_mm, p.lowest_mm, p.mouth_mm, p.volume_mm3] for p in every]
            yield told("reach, lowest, mouth, volume", sizes)
    pockets = dict(zip((frame.number for frame in frames), shell_pockets(spec), strict=True))
    gaps = [
        gap_across_edge_mm(a, one, b, other)
        for a, b in neighbours(frames)
        for one in pockets[a.number]
        for other in pockets[b.number]
    ]
    yield told("gaps across edges", gaps)
    yield told("cover", [cover_mm(frames[0], body) for body in shell_bodies(spec)[0]])


def of_layouts(spec):
    magnets, sensors, bodies = magnet_layout(spec), sensor_layout(spec), shell_body_layout(spec)
    yield told("magnets", tips(magnets.centre_mm, magnets.frames))
    yield told("sensors", tips(sensors.position_mm, sensors.axes.transpose(0, 2, 1)))
    yield told("bodies", tips(bodies.centre_mm, bodies.frame))
    for name, layout in (("magnets", magnets), ("sensors", sensors), ("bodies", bodies)):
        yield told(f"{name} by face", np.bincount(layout.face, minlength=7))
    first = bodies.bodies[0]
    yield told("a body's height, volume", [first.height_mm, first.volume_mm3])
    yield told("sinks of boards", [[sink for _, sink in face] for _, face in board_places(spec)])


def of_core(spec):
    recesses, bay, channels = sensor_recesses(spec), bay_block(spec), []
    for frame, places in board_places(spec):
        channels += wire_channels(spec, frame, [place for place, _ in places], 0.5)
    chips = [mounted.chip for mounted in mounted_sensors(spec)]
    blocks = {
        "keys": core_keys(spec),
        "slits": relief_slits(spec),
        "boards": board_blocks(spec),
        "chips": chips,
        "recesses": recesses,
        "cuts": cuts_of_core(spec),
        "channels": channels,
        "bay": [] if bay is None else [bay],
    }
    for name, some in blocks.items():
        if some:
            yield told(name, corners(some))
    yield told(
        "volumes of keys, slits, slits below 0.4 mm",
        [keys_volume_mm3(spec), slits_volume_mm3(spec), slits_volume_mm3(spec, 0.4)],
    )
    yield told("gaps", [gap_mm(a, b) for a, b in combinations(recesses, 2)])
    yield told("walls", [smallest_recess_wall_mm(spec), smallest_recess_wall_mm(spec, sunk=False)])
    yield told("bundle and passage", [wire_bundle_mm(spec), passage_radius_mm(spec)])
    yield told("wire holes", [wire_hole_diameter_mm(spec, face) for face in spec.body.sensed])


def of_mould(spec):
    frame, plane = mould_frame(spec), parting(spec)
    yield f"opening and style: {frame.opening}, {mould_style(spec)}, plugged {frame.plugged}"
    yield told("mould's axes", frame.axes.T)
    yield told(
        "mould's block", [*frame.low_mm, *frame.high_mm, frame.rim_mm, spec.printer.clearance_mm]
    )
    yield told("what passes through", frame.plug_mm)
    yield told("corners", frame.corners(frame.low_mm, frame.high_mm))
    yield told("up", up(spec))
    yield told("parting", [*plane.normal, plane.offset_mm])
    aside = np.array([0.5, 0.9, 1.0, 1.03, 1.3, 1.5, 1.9])
    starts = (plane.offset_mm + aside)[:, None] * plane.normal
    axes = np.stack([starts, starts + frame.out], axis=1)
    yield told("thin at the seam", [thin_at_seam(spec, ends, 1.0) for ends in axes])
    if frame.opening == "bore":
        outlet = core_outlet(spec)
        yield told("outlet", [outlet.radius_mm, outlet.floor_mm, outlet.wall_mm, outlet.flat_mm])
        yield told("outlet's key and nose", [*outlet.key_mm[0], *outlet.key_mm[1], outlet.nose_mm])


def of_hold(spec):
    for locator in locators(spec):
        yield told(f"pin at face {locator.place[0]}", locator.place[1:])
        sizes = [locator.radius_mm, locator.depth_mm, locator.hole_mm, locator.rise_mm]
        yield told("its sizes, volume, pockets", [*sizes, locator.volume_mm3, len(locator.pockets)])
        yield told("its way", [*locator.frame.centre_mm, *locator.frame.normal])
    beside = socket_beside(spec, np.array([0.6, 0.0, 0.8]))
    for name, sockets in (("socket", roomiest_sockets(spec)), ("socket beside", beside)):
        for socket in sockets:
            yield told(f"{name} in face {socket.frame.number} at", socket.xy_mm)
            sizes = [socket.radius_mm, socket.depth_mm, socket.length_mm, socket.lean]
            yield told("its sizes and end", [*sizes, *socket.end_mm])
            yield told("its axes", socket.frame.axes.T)


def of_faces(spec):
    shares = np.array([[0.0, 0.0], [0.4, -0.3], [-0.6, 0.5], [0.0, 0.7]])
    body, points, back, axes, lengths = body_of(spec), [], [], [], []
    frames = (*face_frames(spec), *core_frames(spec))
    for frame in frames:
        xy = shares * frame.half_extents_mm
        points.append(frame.to_object(np.column_stack([xy, [-1.0, -2.0, 0.5, 0.0]])))
        back.append(frame.from_object(points[-1]))
        axes.append(frame.axes_at(xy))
        lengths.append([*frame.half_extents_mm, *frame.half_lengths_mm])
    yield told("faces", [frame.number for frame in frames])
    yield told("their middles", np.array([frame.centre_mm for frame in frames]))
    yield told("half extents and lengths", lengths)
    yield told("points", np.concatenate(points))
    yield told("in the faces' coordinates", np.concatenate(back))
    yield told("axes", tips(np.zeros((4 * len(frames), 3)), np.concatenate(axes)))
    yield told("distances to the core", body.core_distance_mm(np.concatenate(points)))


@pytest.mark.parametrize("name", [name for name in OBJECTS if name not in ALIKE])
def test_an_object_off_its_symmetries_is_worked_out_as_on_record(name):
    spec = worked(name)
    parts = (of_faces, of_pockets, of_layouts, of_core, of_mould, of_hold)
    assert_on_record("layouts", name, [line for part in parts for line in part(spec)])


@pytest.mark.parametrize("name", ["box", "box open at a side", "cylinder", "hollow dome"])
def test_the_silicone_that_is_meshed_is_as_on_record(name):
    spec = worked(name)
    meshes = [sealed_body_surface(spec), *support_rings(spec)]
    lines = [told("volume, area, box", [m.volume, m.area, *m.bounds.ravel()]) for m in meshes]
    assert_on_record("surfaces", name, lines)
