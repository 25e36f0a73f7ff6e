"""Assembly sheet for the workbench, one page to print: what goes where, which way round, in what order."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import ceil, degrees
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.body.surface_chart import FaceFrame
from design.body.triangles import Block
from design.build.amounts import printed_items, silicone_item
from design.build.manifest import BuildManifest, PartManifest
from design.build.masses import mass_text
from design.build.order_list import OrderLine, price_text
from design.layout.boards import board_blocks, wire_bundle_mm
from design.layout.body import body_of, core_frames, face_frames
from design.layout.mould.frame import opening_of
from design.layout.places.positions import sensor_layout
from design.layout.pockets import magnet_places, sensor_places
from design.spec.object import ObjectSpec
from design.wiring.bus_plan import BusPlan
from design.wiring.dealing import ChipOnBus
from design.wiring.lengths import wire_lengths_mm
from instobj.report.assembly_steps import has_template, steps
from instobj.report.pages import render

if TYPE_CHECKING:
    from design.build.slicing import PrintJob
    from design.layout.mould.pins import PinKind

_NORTH, _SOUTH = "#c1121f", "#1d4e9e"
_FACE_MM = 55.0
"""Width of the widest face; the others have its scale."""
_BORDER_MM = 4.0
"""Border round a drawn face."""
_AXIS_MM = 4.5
"""Length of a drawn chip axis that lies in the face, mm."""
_SAME_MM = 2e-2
"""Distance below which two magnets have the same place."""


def assembly_sheet(
    spec: ObjectSpec,
    manifest: BuildManifest,
    exploded_png: Path,
    pins: Sequence[PinKind] = (),
    plan: BusPlan | None = None,
    orders: Sequence[OrderLine] = (),
    demoulding_png: Path | None = None,
    jobs: Mapping[str, PrintJob] | None = None,
) -> str:
    """The page as HTML in a single file; print it to get a PDF.

    `pins` are the loose pins of a split mould (`design.mould.pins.pins_by_kind`), `plan` is how the
    paper's board reads the sensors, `orders` are the parts to buy for both.
    Where nothing is cast there is no picture of demoulding. `jobs` are what a slicer says of printed parts.
    """
    parts = [part.name for part in manifest.parts]
    frames = face_frames(spec) if spec.arrangement == "sensors-in-core" else core_frames(spec)
    drawn = [*frames, *_frames_of_sockets(spec, pins)]
    widest = max(frame.half_extents_mm[0] for frame in drawn) + _BORDER_MM
    scale = _FACE_MM / (2 * widest)
    return render(
        "assembly.html.j2",
        spec=spec,
        hash=manifest.spec_hash[:16],
        exploded=exploded_png,
        demoulding=demoulding_png,
        faces=[_face(spec, frame, pins, scale) for frame in drawn],
        template=_template(frames, parts),
        board_faces=_board_faces(spec, scale),
        sensors=_sensors(spec, plan),
        board=None if plan is None else plan.board,
        bundle_mm=wire_bundle_mm(spec),
        leave="the holes of the locating pins" if opening_of(spec) == "closed" else "the open face",
        pins=_pin_rows(pins),
        prints=[_print(part, jobs) for part in manifest.parts if part.printing is not None],
        jobs=_jobs_text(manifest, jobs),
        steps=steps(spec, parts),
        materials=_materials(spec, manifest),
        mass=mass_text(spec),
        orders=[_order(line) for line in orders],
        cost=price_text(orders) if orders else "",
    )


def _template(frames: Sequence[FaceFrame], parts: Sequence[str]) -> str:
    """Return what kind of magnet template was built: flat, curved or none."""
    if not has_template(parts):
        return "none"
    return "flat" if all(frame.flat for frame in frames) else "curved"


def _face(
    spec: ObjectSpec, frame: FaceFrame, pins: Sequence[PinKind], scale: float
) -> dict[str, Any]:
    """One face seen from outside, x to the right and y up, each magnet with its outward pole."""
    magnets = list[dict[str, Any]]()
    places = dict(zip(spec.body.sensed, magnet_places(spec), strict=True)).get(frame.number, ())
    kinds = (
        spec.magnets.kinds if len(spec.magnets.numbers_by_kind) > 1 else ("",) * spec.magnets.count
    )
    each = zip(spec.magnets.polarities, kinds, spec.magnets.sizes, strict=True)
    for (x, y), (way, kind, size) in zip(places, each, strict=bool(places)):
        pole, colour = ("N", _NORTH) if way > 0 else ("S", _SOUTH)
        pin = _pin_at(pins, frame.number, x, y)
        magnets.append(
            {
                "x": x,
                "y": y,
                "radius": max(size.half_mm),
                "pole": pole,
                "colour": colour,
                "pin": pin,
                "kind": kind,
            }
        )
    return {
        **_drawn_frame(frame, scale),
        "magnets": magnets,
        "sockets": _sockets(pins, frame.number, places),
    }


def _drawn_frame(frame: FaceFrame, scale: float) -> dict[str, Any]:
    """Outline and axes of a face seen from outside."""
    half_x, half_y = frame.half_extents_mm
    low_x, low_y = half_x + _BORDER_MM, half_y + _BORDER_MM
    return {
        "number": frame.number,
        "round": frame.round,
        "half_x": half_x,
        "half_y": half_y,
        "width_mm": round(scale * 2 * low_x, 2),
        "view": f"{-low_x:g} {-low_y:g} {2 * low_x:g} {2 * low_y:g}",
        "arrows": f"M {1 - half_x:g} {half_y - 1:g} h 6 m 0 0 l -1.5 -0.9 m 1.5 0.9 l -1.5 0.9 "
        f"M {1 - half_x:g} {half_y - 1:g} v -6 m 0 0 l -0.9 1.5 m 0.9 -1.5 l 0.9 1.5",
        "axis": _axis_name(frame.normal),
        "x_axis": _axis_name(frame.x),
        "y_axis": _axis_name(frame.y),
    }


def _board_faces(spec: ObjectSpec, scale: float) -> list[dict[str, Any]]:
    """Every face with its boards and the directions of their chips' X and Y, as drawn from outside."""
    layout, boards = sensor_layout(spec), board_blocks(spec)
    return [
        {
            **_drawn_frame(frame, scale),
            "boards": [
                _board(frame, number, boards[index], layout.axes[index])
                for number, index in enumerate(np.flatnonzero(layout.face == frame.number), start=1)
            ],
        }
        for frame in face_frames(spec)
    ]


def _board(frame: FaceFrame, number: int, board: Block, chip: np.ndarray) -> dict[str, Any]:
    """Lines of one board: its upper side's corners, and its chip's X and Y, in the picture's x and −y."""
    # columns x and y of the face, y turned down as pictures count
    on_picture = frame.axes[:, :2] * [1, -1]
    x, y = (board.centre_mm - frame.centre_mm) @ on_picture
    corners = (board.corners_mm[[4, 6, 7, 5]] - frame.centre_mm) @ on_picture
    ends = {letter: (chip[k] @ on_picture) * _AXIS_MM for k, letter in enumerate("XY")}
    shown = {letter: end for letter, end in ends.items() if np.hypot(*end) > _AXIS_MM / 3}
    # the number stands beside the corner that both axes point away from
    beside = -0.85 * sum(shown.values(), np.zeros(2))
    return {
        "number": number,
        "x": f"{x + beside[0]:.2f}",
        "y": f"{y + beside[1] + 1:.2f}",
        "corners": " ".join(f"{a:.2f},{b:.2f}" for a, b in corners),
        "axes": " ".join(f"M {x:.2f} {y:.2f} l {a:.2f} {b:.2f}" for a, b in shown.values()),
        "letters": [
            (letter, f"{x + 1.3 * a:.2f}", f"{y + 1.3 * b + 0.8:.2f}")
            for letter, (a, b) in shown.items()
        ],
    }


def _frames_of_sockets(spec: ObjectSpec, pins: Sequence[PinKind]) -> list[FaceFrame]:
    """Faces without magnets on which pins hold the core."""
    faces = {face for kind in pins for face, _, _ in kind.places} - {*spec.body.sensed}
    return [body_of(spec).frame(face) for face in sorted(faces)]


def _pin_at(pins: Sequence[PinKind], face: int, x_mm: float, y_mm: float) -> str:
    """The number of the pin that forms this pocket; nothing where its boss is fixed."""
    for number, kind in enumerate(pins, start=1):
        if any(
            place[0] == face and abs(place[1] - x_mm) < 1e-6 and abs(place[2] - y_mm) < 1e-6
            for place in kind.places
        ):
            return f"P{number}"
    return ""


def _sockets(
    pins: Sequence[PinKind], face: int, magnets: Sequence[tuple[float, float]]
) -> list[dict[str, Any]]:
    """Places of a face where a pin stands in a hole of the core and forms no pocket."""
    return [
        {"x": x, "y": y, "pin": f"P{number}"}
        for number, kind in enumerate(pins, start=1)
        for number_of_face, x, y in kind.places
        if number_of_face == face and all(abs(x - a) + abs(y - b) > _SAME_MM for a, b in magnets)
    ]


def _pin_rows(pins: Sequence[PinKind]) -> list[list[str]]:
    rows = []
    for number, kind in enumerate(pins, start=1):
        places = ", ".join(f"{face} ({x:g}, {y:g})" for face, x, y in kind.places)
        held = "; also holds the core" if kind.holds_core else ""
        rows.append([f"P{number}", kind.name, str(kind.count), places + held])
    return rows


def _axis_name(direction: Any) -> str:
    """+x, −y … of the object, of a unit vector along an axis."""
    strongest = int(abs(direction).argmax())
    return ("+" if direction[strongest] > 0 else "−") + "xyz"[strongest]


def _sensors(spec: ObjectSpec, plan: BusPlan | None) -> list[list[str]]:
    wires = spec.core.wires_per_sensor
    rows = []
    number = 0
    lengths, routes = wire_lengths_mm(spec), _routes(plan)
    for frame, places in zip(core_frames(spec), sensor_places(spec), strict=True):
        for index, (x, y, azimuth) in enumerate(places, start=1):
            ends = f"{number * wires + 1} to {(number + 1) * wires}"
            turn = f"{degrees(azimuth) % 360:.0f}°"
            length = f"{5 * ceil(lengths[number] / 5)}"
            number += 1
            place = f"{round(x, 2) + 0.0:.2f}, {round(y, 2) + 0.0:.2f}"
            route = routes.get((frame.number, index), "")
            row = [f"{number}", f"{frame.number}", f"{index}", place, turn, ends, length]
            rows.append(row if plan is None else [*row, route])
    return rows


def _routes(plan: BusPlan | None) -> dict[tuple[int, int], str]:
    """Supply and bus of every sensor (face, number there) on the board of the plan; none without one."""
    chips = () if plan is None else plan.chips
    return {(chip.face, chip.number): _route(chip) for chip in chips}


def _route(chip: ChipOnBus) -> str:
    supply = f"{chip.supply} buffered" if chip.supply else "3V3"
    if chip.multiplexer is None:
        return f"{chip.part}, {supply}, read at 0x{chip.address:02X}"
    return f"{chip.part}, 0x{chip.multiplexer:02X} channel {chip.channel}"


def _materials(spec: ObjectSpec, manifest: BuildManifest) -> list[list[str]]:
    return [
        [
            item.item,
            str(item.count),
            f"{item.volume_cm3:.2f}",
            f"{item.mass_g:.1f}",
            item.note,
        ]
        for item in (silicone_item(spec), *printed_items(spec, manifest))
    ]


def _print(part: PartManifest, jobs: Mapping[str, PrintJob] | None) -> list[str]:
    settings = part.printing
    assert settings is not None
    job = None if jobs is None else jobs.get(part.name)
    sliced = ["–", "–"] if job is None else [_duration(job.minutes), f"{job.filament_g:.0f}"]
    return [
        part.name,
        str(part.count),
        f"{settings.layer_mm:g}",
        str(settings.walls),
        f"{settings.infill_percent} %",
        "from the bed" if settings.supports else "none",
        f"{settings.brim_mm:g} mm" if settings.brim_mm else "none",
        *(sliced if jobs is not None else ()),
    ]


def _jobs_text(manifest: BuildManifest, jobs: Mapping[str, PrintJob] | None) -> str:
    """Say what all pieces take together, or how to have that said."""
    if jobs is None:
        return "With PrusaSlicer installed (prusa-slicer), build also says time and filament."
    printed = {part.name: part.count for part in manifest.parts if part.printing is not None}
    minutes = sum(printed[name] * job.minutes for name, job in jobs.items())
    filament_g = sum(printed[name] * job.filament_g for name, job in jobs.items())
    refused = [name for name in printed if name not in jobs]
    without = f" but for {', '.join(refused)}, which PrusaSlicer refuses" if refused else ""
    all_pieces = f"All pieces{without}: {_duration(minutes)} and {filament_g:.0f} g"
    return f"{all_pieces}, by PrusaSlicer's default speeds."


def _duration(minutes: float) -> str:
    """Hours and minutes."""
    hours, rest = divmod(round(minutes), 60)
    return f"{hours} h {rest:02d} min" if hours else f"{rest} min"


def _order(line: OrderLine) -> list[str]:
    price = f"{line.low_eur:.2f} to {line.high_eur:.2f}"
    return [line.part, line.maker, line.number, str(line.pieces), str(line.packs), price]
