"""Assembly sheet for the workbench, one page to print: what goes where, which way round, in what order."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from math import ceil, degrees
from pathlib import Path
from typing import TYPE_CHECKING, Any

from design.body.surface_chart import FaceFrame
from design.build.bom import bill_of_materials, silicone_amount
from design.build.manifest import BuildManifest
from design.catalogue.bus_parts import MEGA2560
from design.errors import InputError
from design.layout.boards import wire_bundle_mm
from design.layout.body import core_frames, face_frames
from design.layout.mould_frame import mould_frame, mould_style, opening_of
from design.layout.pockets import magnet_places, sensor_places
from design.spec.object import ObjectSpec
from design.wiring.bus_plan import choose_plan
from design.wiring.dealing import ChipOnBus
from design.wiring.lengths import wire_lengths_mm
from instobj.report.pages import render

if TYPE_CHECKING:
    from design.mould.pins import PinKind

_NORTH, _SOUTH = "#c1121f", "#1d4e9e"
_FACE_MM = 55.0
_BORDER_MM = 4.0


def assembly_sheet(
    spec: ObjectSpec, manifest: BuildManifest, exploded_png: Path, pins: Sequence[PinKind] = ()
) -> str:
    """The page as HTML without any file beside it; print it to get a PDF.

    `pins` are the loose pins of a split mould (`design.mould.pins.pins_by_kind`).
    """
    parts = [part.name for part in manifest.parts]
    frames = face_frames(spec) if spec.arrangement == "sensors-in-core" else core_frames(spec)
    return render(
        "assembly.html.j2",
        spec=spec,
        hash=manifest.spec_hash[:16],
        exploded=exploded_png,
        faces=[_face(spec, frame, pins) for frame in frames],
        template=has_template(parts),
        sensors=_sensors(spec),
        bundle_mm=wire_bundle_mm(spec),
        pins=_pin_rows(pins),
        steps=steps(spec, parts),
        materials=_materials(spec, manifest),
    )


def has_template(parts: Collection[str]) -> bool:
    """Whether a magnet template is among the names of the parts."""
    return any(name.startswith("magnet_template") for name in parts)


def _face(spec: ObjectSpec, frame: FaceFrame, pins: Sequence[PinKind]) -> dict[str, Any]:
    """One face seen from outside, x to the right and y up, each magnet with its outward pole."""
    half_x, half_y = frame.half_extents_mm
    block = spec.magnets.shape == "block"
    radius = max(spec.magnets.size_mm) / 2 if block else spec.magnets.diameter_mm / 2
    magnets, places = [], magnet_places(spec)[spec.body.sensed.index(frame.number)]
    for (x, y), way in zip(places, spec.magnets.polarities, strict=True):
        pole, colour = ("N", _NORTH) if way > 0 else ("S", _SOUTH)
        pin = _pin_at(pins, frame.number, x, y)
        magnets.append(
            {"x": x, "y": y, "radius": radius, "pole": pole, "colour": colour, "pin": pin}
        )
    low_x, low_y = half_x + _BORDER_MM, half_y + _BORDER_MM
    return {
        "number": frame.number,
        "round": frame.round,
        "half_x": half_x,
        "half_y": half_y,
        "width_mm": _FACE_MM,
        "view": f"{-low_x:g} {-low_y:g} {2 * low_x:g} {2 * low_y:g}",
        "arrows": f"M {1 - half_x:g} {half_y - 1:g} h 6 m 0 0 l -1.5 -0.9 m 1.5 0.9 l -1.5 0.9 "
        f"M {1 - half_x:g} {half_y - 1:g} v -6 m 0 0 l -0.9 1.5 m 0.9 -1.5 l 0.9 1.5",
        "magnets": magnets,
        "axis": _axis_name(frame.normal),
        "x_axis": _axis_name(frame.x),
        "y_axis": _axis_name(frame.y),
    }


def _pin_at(pins: Sequence[PinKind], face: int, x_mm: float, y_mm: float) -> str:
    """The number of the pin that forms this pocket; nothing where its boss is fixed."""
    for number, kind in enumerate(pins, start=1):
        if any(
            place[0] == face and abs(place[1] - x_mm) < 1e-6 and abs(place[2] - y_mm) < 1e-6
            for place in kind.places
        ):
            return f"P{number}"
    return ""


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


def _sensors(spec: ObjectSpec) -> list[list[str]]:
    wires = spec.core.wires_per_sensor
    rows = []
    number = 0
    lengths, routes = wire_lengths_mm(spec), _routes(spec)
    for frame, places in zip(core_frames(spec), sensor_places(spec), strict=True):
        for index, (x, y, azimuth) in enumerate(places, start=1):
            ends = f"{number * wires + 1} to {(number + 1) * wires}"
            turn = f"{degrees(azimuth) % 360:.0f}°"
            length = f"{5 * ceil(lengths[number] / 5)}"
            number += 1
            at = f"{round(x, 2) + 0.0:.2f}, {round(y, 2) + 0.0:.2f}"
            route = routes.get((frame.number, index), "")
            rows.append([f"{number}", f"{frame.number}", f"{index}", at, turn, ends, length, route])
    return rows


def _routes(spec: ObjectSpec) -> dict[tuple[int, int], str]:
    """Supply and bus of every sensor (face, number there) on the paper's board; none without a plan."""
    try:
        plan, _ = choose_plan(spec, MEGA2560)
    except InputError:
        return {}
    return {(chip.face, chip.number): _route(chip) for chip in plan.chips}


def _route(chip: ChipOnBus) -> str:
    supply = f"{chip.supply} buffered" if chip.supply else "3V3"
    if chip.multiplexer is None:
        return f"{chip.part}, {supply}, read at 0x{chip.address:02X}"
    return f"{chip.part}, 0x{chip.multiplexer:02X} channel {chip.channel}"


def steps(spec: ObjectSpec, parts: Collection[str]) -> list[str]:
    """What to do, in order, with the figures of this object and the parts that were built."""
    first = ["Print all parts; remove strings and slivers, and see that the sliding parts move."]
    if spec.printer.process == "resin" and spec.silicone.cure == "platinum":
        first.append(
            "Printed resin inhibits platinum silicone: wash, cure under UV, bake at 60 °C for hours "
            "and coat the mould; try a spoonful on a scrap first."
        )
    return [*first, *_casting_steps(spec), *_joining_steps(spec, parts)]


def _casting_steps(spec: ObjectSpec) -> list[str]:
    silicone, amount = spec.silicone, silicone_amount(spec)
    if silicone.cure == "none":
        return [f"Print the shell in {silicone.name}."]
    a, b = amount.parts_g
    pot = (
        "see the maker's sheet"
        if silicone.pot_life_min is None
        else f"{silicone.pot_life_min:g} min"
    )
    cure = "see the maker's sheet" if silicone.cure_h is None else f"{silicone.cure_h:g} h"
    return [
        *_core_first(spec),
        f"{_closed(spec)} Spray release agent thinly, on all that the silicone touches but the core.",
        f"Weigh {a:.1f} g of part A and {b:.1f} g of part B of {silicone.name} "
        f"({amount.mixed_g:.1f} g, with {spec.mould.silicone_waste:.0%} more than the object holds); "
        f"keep a part of it for sealing. Mix; pot life {pot}. Take the air out under vacuum.",
        _poured(spec),
        f"Let it cure: {cure} at room temperature, longer when cold. Then {_opened(spec)}",
    ]


def _core_first(spec: ObjectSpec) -> list[str]:
    """A core that is cast in gets its electronics before."""
    if opening_of(spec) == "open":
        return []
    hold = {
        "bore": "Lead the wires out through its outlet and the rod's side, seat it on the rod's nose, flat "
        "on flat, and secure it there with a drop of hot glue.",
        "closed": "Coil the wires' ends in the middle of the core, deeper than the locating pins reach.",
    }[opening_of(spec)]
    return [f"{_glued(spec)} Fill its recesses flush with silicone and let it cure. {hold}"]


def _glued(spec: ObjectSpec) -> str:
    in_core = "sensor boards" if spec.arrangement == "sensors-in-core" else "magnets"
    return f"Glue the {in_core} into the core, wires through their holes; test every sensor now."


def _closed(spec: ObjectSpec) -> str:
    if mould_style(spec) == "one-piece":
        return "Set the mould box with its open side up."
    core = {
        "open": "",
        "bore": " round the core on its rod, clip the rod's flange on",
        "closed": " round the core",
    }[opening_of(spec)]
    pins = (
        "push all pins in to their heads, each where the table of pins says, the locating pins into the "
        "core's wire holes"
        if opening_of(spec) == "closed"
        else "push all pins in to their heads, each where the table of pins says"
    )
    return f"Join the mould's halves on their dowels{core}, bolt the flanges, {pins}."


def _poured(spec: ObjectSpec) -> str:
    frame = mould_frame(spec)
    if frame.opening == "bore":
        return (
            "Pour slowly into one of the two holes beside the rod until silicone stands in the other and "
            "in all vents."
        )
    if frame.opening == "closed":
        return (
            "Stand the mould on the corner opposite to its pouring hole; pour slowly until silicone stands "
            "in the hole and in all vents."
        )
    if not frame.plugged:
        return "Fill the mould to its rim and draw the surface flat with a blade."
    return (
        "Fill the mould, tilt the plug in so that no air stays under its flat end, and clip it on."
    )


def _opened(spec: ObjectSpec) -> str:
    frame = mould_frame(spec)
    if mould_style(spec) == "one-piece":
        if not frame.plugged:
            return "peel the silicone out of the mould, from its edge inwards."
        return "draw the plug straight out first, then fold the walls inwards off the bosses."
    if frame.opening == "open":
        last = ", then peel the shell off the plug" if frame.plugged else ""
        return f"draw all pins outwards, part the halves{last}."
    rod = " and the rod" if frame.opening == "bore" else ""
    return (
        f"draw all pins{rod} outwards, part the halves and cut the sprues flush; the core stays in."
    )


def _joining_steps(spec: ObjectSpec, parts: Collection[str]) -> list[str]:
    in_shell = "magnets" if spec.arrangement == "sensors-in-core" else "sensor boards"
    by = "the template and the maps" if has_template(parts) else "the maps"
    layer = spec.shell.seal_layer_mm
    seal = (
        f"Put the shell on its plug into the seal box and pour the layer of {layer:g} mm over all faces."
        if layer
        else "Fill the pockets flush with silicone, face by face, and let each cure."
    )
    keys = (
        "The keys must snap into their recesses."
        if spec.core.keys.positions_mm
        else "A film of silicone glue between both keeps the core from slipping: where it sits decides "
        "the calibration."
    )
    held = opening_of(spec) != "open"
    core = f"Push the core in, face 1 first, until it meets the cavity's end. {keys}"
    wires = (
        "Draw the wires out through the holes of the locating pins and fill these with silicone."
    )
    return [
        *([] if held else [_glued(spec)]),
        f"Set the {in_shell} on the floors of the shell's pockets, by {by} above.",
        seal,
        *([] if held else [core]),
        *([wires] if opening_of(spec) == "closed" else []),
        "Read all sensors at rest and run `instobj selftest`: it finds flipped magnets and swapped "
        "channels.",
        "Put the object on its jig, align the jig's grooves with the machine, and calibrate."
        if "jig" in parts
        else "Hold the object in the machine so that its axes are known (it has no printed jig), and "
        "calibrate.",
    ]


def _materials(spec: ObjectSpec, manifest: BuildManifest) -> list[list[str]]:
    return [
        [
            item.item,
            str(item.count),
            "" if item.volume_cm3 is None else f"{item.volume_cm3:.2f}",
            "" if item.mass_g is None else f"{item.mass_g:.1f}",
            item.note,
        ]
        for item in bill_of_materials(spec, manifest)
    ]
