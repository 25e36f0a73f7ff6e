"""What is worked out of objects off their symmetries as numbers: a page that a person can judge."""

from itertools import combinations

import numpy as np

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
)
from design.layout.body import face_frames
from design.layout.core_hold import core_outlet, locators
from design.layout.core_sockets import roomiest_sockets, socket_beside
from design.layout.mould.frame import mould_frame, parting, thin_at_seam
from design.layout.places.positions import (
    board_places,
    magnet_layout,
    sensor_layout,
    shell_body_layout,
)
from design.layout.pockets import core_pockets, neighbours, shell_pockets
from design.layout.surface import sealed_body_surface, support_rings
from tests.support.objects.pocket_gaps import gap_across_edge_mm
from tests.support.objects.worked_objects import worked
from tests.support.physics_pages import assert_page

SHOWN = ("box", "box open at a side", "reverse box", "cylinder", "capsule", "closed sphere")


def blocks_of(spec):
    bay, channels = bay_block(spec), []
    for frame, places in board_places(spec):
        channels += wire_channels(spec, frame, [place for place, _ in places], 0.5)
    chips = [mounted.chip for mounted in mounted_sensors(spec)]
    blocks = [*core_keys(spec), *relief_slits(spec), *board_blocks(spec), *chips]
    blocks += [*sensor_recesses(spec), *cuts_of_core(spec), *channels]
    return blocks if bay is None else [*blocks, bay]


def of_parts(name, spec):
    frames = face_frames(spec)
    pockets = [pocket for face in (*shell_pockets(spec), *core_pockets(spec)) for pocket in face]
    by_face = dict(zip((frame.number for frame in frames), shell_pockets(spec), strict=True))
    gaps = [
        gap_across_edge_mm(a, one, b, other)
        for a, b in neighbours(frames)
        for one in by_face[a.number]
        for other in by_face[b.number]
    ]
    sizes = [sum(pocket.volume_mm3 for pocket in pockets), keys_volume_mm3(spec)]
    sizes += [slits_volume_mm3(spec, 0.4), min(gaps, default=0.0), smallest_recess_wall_mm(spec)]
    sizes += [wire_bundle_mm(spec), passage_radius_mm(spec)]
    recesses = sensor_recesses(spec)
    sizes.append(min((gap_mm(a, b) for a, b in combinations(recesses, 2)), default=0.0))
    yield f"{name}: pockets, keys, slits (mm³), gap, wall, wires, passage, recesses (mm)", sizes
    yield f"{name}: blocks (mm)", np.concatenate([block.corners_mm for block in blocks_of(spec)])
    layouts = [magnet_layout(spec).centre_mm, sensor_layout(spec).position_mm]
    layouts += [shell_body_layout(spec).centre_mm, *(pocket.axis_ends_mm for pocket in pockets)]
    yield f"{name}: magnets, sensors, bodies, pockets (mm)", np.concatenate(layouts)


def of_mould(name, spec):
    frame, plane = mould_frame(spec), parting(spec)
    yield f"{name}: mould (mm)", [*frame.low_mm, *frame.high_mm, frame.rim_mm, plane.offset_mm]
    starts = (plane.offset_mm + np.linspace(0.5, 1.9, 29))[:, None] * plane.normal
    ends = np.stack([starts, starts + frame.out], axis=1)
    thin = [thin_at_seam(spec, one, 1.0) for one in ends]
    sockets = [*roomiest_sockets(spec), *socket_beside(spec, np.array([0.6, 0.0, 0.8]))]
    held = [[*one.xy_mm, one.radius_mm, one.depth_mm, one.length_mm, one.lean] for one in sockets]
    held += [[*pin.place, pin.radius_mm, pin.depth_mm, pin.rise_mm] for pin in locators(spec)]
    yield f"{name}: thin at the seam, sockets and pins", [float(sum(thin)), *np.ravel(held)]


def of_meshed_silicone():
    spec = worked("hollow dome")
    meshes = [sealed_body_surface(spec), *support_rings(spec)]
    yield "hollow dome: silicone (mm³, mm²)", [one for m in meshes for one in (m.volume, m.area)]
    outlet = core_outlet(worked("sphere"))
    yield (
        "sphere: outlet of the core (mm)",
        [
            outlet.radius_mm,
            outlet.floor_mm,
            outlet.wall_mm,
            outlet.flat_mm,
        ],
    )


def test_the_page_of_layouts():
    lines = [line for name in SHOWN for line in of_parts(name, worked(name))]
    moulds = [line for name in SHOWN[:5] for line in of_mould(name, worked(name))]
    assert_page("design/layout", [*lines, *moulds, *of_meshed_silicone()])
