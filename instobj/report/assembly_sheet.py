"""A sheet for the workbench, as one page to print: what goes where, which way round, in what order."""

from __future__ import annotations

import html
from math import degrees
from pathlib import Path
from typing import Any

from design.build.bom import bill_of_materials, silicone_amount
from design.build.manifest import BuildManifest
from design.layout.boards import wire_bundle_mm
from design.layout.body import core_frames, face_frames
from design.layout.mould_frame import mould_frame, mould_style, opening_of
from design.layout.pockets import sensor_places
from design.spec.object import ObjectSpec
from instobj.report import elements

_STYLE = """
body { font: 11pt/1.4 system-ui, sans-serif; color: #111; max-width: 190mm; margin: 8mm auto; }
h1 { font-size: 18pt; margin: 0 0 2mm; } h2 { font-size: 13pt; margin: 7mm 0 2mm; }
table { border-collapse: collapse; font-size: 9.5pt; } img { max-width: 100%; max-height: 150mm; }
td, th { border-bottom: 0.2mm solid #bbb; padding: 0.8mm 2.5mm; text-align: left; }
.faces { display: flex; flex-wrap: wrap; gap: 4mm; } figure { margin: 0; }
figcaption { font-size: 9.5pt; text-align: center; } li { margin: 1mm 0; }
.note { color: #444; font-size: 9.5pt; }
h2, figure, tr, li { break-inside: avoid; } h2 { break-after: avoid; }
@page { size: A4; margin: 12mm; }
"""
_NORTH, _SOUTH = "#c1121f", "#1d4e9e"
_FACE_MM = 55.0


def assembly_sheet(spec: ObjectSpec, manifest: BuildManifest, exploded_png: Path) -> str:
    """The page as HTML without any file beside it; print it to get a PDF."""
    body = "".join(
        (
            f"<h1>{html.escape(spec.name)}: assembly</h1>",
            f'<p class="note">Specification {manifest.spec_hash[:16]}. Lengths in mm. z points away '
            "from the open face, face 1 outwards.</p>",
            elements.image(exploded_png, "Exploded view"),
            "<h2>Magnets: poles seen from outside</h2>",
            _polarity_section(spec),
            "<h2>Sensors and wires</h2>",
            _wire_section(spec),
            "<h2>Steps</h2>",
            f"<ol>{''.join(f'<li>{html.escape(step)}</li>' for step in steps(spec))}</ol>",
            "<h2>Materials</h2>",
            _bom_table(spec, manifest),
        )
    )
    return (
        '<!DOCTYPE html><html lang="en"><head><meta charset="utf-8">'
        f"<title>{html.escape(spec.name)}: assembly</title><style>{_STYLE}</style></head>"
        f"<body>{body}</body></html>\n"
    )


def _polarity_section(spec: ObjectSpec) -> str:
    frames = face_frames(spec) if spec.arrangement == "sensors-in-core" else core_frames(spec)
    figures = "".join(_polarity_figure(spec, frame) for frame in frames)
    text = (
        "Lay the magnet template on the face, its lips over the edges at −x and −y. Check every pole "
        "with a marked magnet before sealing."
    )
    return f'<div class="faces">{figures}</div><p class="note">{text}</p>'


def _polarity_figure(spec: ObjectSpec, frame: Any) -> str:
    """One face seen from outside, x to the right and y up, each magnet with its outward pole."""
    half_x, half_y = frame.half_extents_mm
    radius = (
        max(spec.magnets.size_mm) / 2
        if spec.magnets.shape == "block"
        else spec.magnets.diameter_mm / 2
    )
    marks = []
    for index, ((x, y), way) in enumerate(
        zip(spec.magnets.positions_mm, spec.magnets.polarities, strict=True), start=1
    ):
        pole, colour = ("N", _NORTH) if way > 0 else ("S", _SOUTH)
        marks.append(
            f'<circle cx="{x:g}" cy="{-y:g}" r="{radius:g}" fill="{colour}"/>'
            f'<text x="{x:g}" y="{-y + 1.2:g}" font-size="3.6" fill="#fff" text-anchor="middle">'
            f"{pole}</text>"
            f'<text x="{x + radius + 0.6:g}" y="{-y - radius + 1:g}" font-size="3">{index}</text>'
        )
    border = 4.0
    view = f"{-half_x - border:g} {-half_y - border:g} {2 * (half_x + border):g} {2 * (half_y + border):g}"
    axes = (
        f'<path d="M {-half_x + 1:g} {half_y - 1:g} h 6 m 0 0 l -1.5 -0.9 m 1.5 0.9 l -1.5 0.9 '
        f'M {-half_x + 1:g} {half_y - 1:g} v -6 m 0 0 l -0.9 1.5 m 0.9 -1.5 l 0.9 1.5" '
        'stroke="#111" stroke-width="0.35" fill="none"/>'
        f'<text x="{-half_x + 8:g}" y="{half_y - 0.3:g}" font-size="3">x</text>'
        f'<text x="{-half_x + 0.2:g}" y="{half_y - 8:g}" font-size="3">y</text>'
    )
    axis = _axis_name(frame.normal)
    return (
        f'<figure><svg width="{_FACE_MM}mm" viewBox="{view}">'
        f'<rect x="{-half_x:g}" y="{-half_y:g}" width="{2 * half_x:g}" height="{2 * half_y:g}" '
        f'fill="#f7f0e0" stroke="#111" stroke-width="0.4"/>{axes}{"".join(marks)}</svg>'
        f"<figcaption>face {frame.number} ({axis}); x = {_axis_name(frame.x)}, "
        f"y = {_axis_name(frame.y)}</figcaption></figure>"
    )


def _axis_name(direction: Any) -> str:
    """+x, −y … of the object, of a unit vector along an axis."""
    strongest = int(abs(direction).argmax())
    return ("+" if direction[strongest] > 0 else "−") + "xyz"[strongest]


def _wire_section(spec: ObjectSpec) -> str:
    wires = spec.core.wires_per_sensor
    rows = []
    number = 0
    for frame, places in zip(core_frames(spec), sensor_places(spec), strict=True):
        for index, (x, y, azimuth) in enumerate(places, start=1):
            ends = f"{number * wires + 1} to {(number + 1) * wires}"
            turn = f"{degrees(azimuth) % 360:.0f}°"
            number += 1
            at = f"{round(x, 2) + 0.0:.2f}, {round(y, 2) + 0.0:.2f}"
            cells = (f"{number}", f"{frame.number}", f"{index}", at, turn, ends)
            rows.append("".join(f"<td>{cell}</td>" for cell in cells))
    head = "".join(
        f"<th>{name}</th>"
        for name in ("sensor", "face", "on it", "x, y", "azimuth from x", "wires no.")
    )
    table = "".join(f"<tr>{row}</tr>" for row in rows)
    text = (
        f"Chips face {spec.sensors.chip}. {wires} wires a sensor (supply, ground, data, clock where "
        f"there are four) leave through the hole at the face's middle as a bundle of about "
        f"{wire_bundle_mm(spec):.1f} mm and through the open face. Sensors of one type share few bus "
        "addresses: give each its own channel of a multiplexer, in the order of this list."
    )
    return f"<table><tr>{head}</tr>{table}</table><p class='note'>{html.escape(text)}</p>"


def steps(spec: ObjectSpec) -> list[str]:
    """What to do, in order, with the figures of this object."""
    first = ["Print all parts; remove strings and slivers, and see that the sliding parts move."]
    if spec.printer.process == "resin" and spec.silicone.cure == "platinum":
        first.append(
            "Printed resin inhibits platinum silicone: wash, cure under UV, bake at 60 °C for hours "
            "and coat the mould; try a spoonful on a scrap first."
        )
    return [*first, *_casting_steps(spec), *_joining_steps(spec)]


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
        "push all pins in to their heads, the locating pins into the core's wire holes"
        if opening_of(spec) == "closed"
        else "push all pins in to their heads"
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


def _joining_steps(spec: ObjectSpec) -> list[str]:
    in_shell = "magnets" if spec.arrangement == "sensors-in-core" else "sensor boards"
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
        f"Set the {in_shell} on the floors of the shell's pockets, by the template and the maps above.",
        seal,
        *([] if held else [core]),
        *([wires] if opening_of(spec) == "closed" else []),
        "Read all sensors at rest and run `instobj selftest`: it finds flipped magnets and swapped "
        "channels.",
        "Put the object on its jig, align the jig's grooves with the machine, and calibrate.",
    ]


def _bom_table(spec: ObjectSpec, manifest: BuildManifest) -> str:
    head = "".join(f"<th>{name}</th>" for name in ("item", "count", "cm³", "g", "note"))
    rows = "".join(
        "<tr>"
        + "".join(
            f"<td>{html.escape(text)}</td>"
            for text in (
                item.item,
                str(item.count),
                "" if item.volume_cm3 is None else f"{item.volume_cm3:.2f}",
                "" if item.mass_g is None else f"{item.mass_g:.1f}",
                item.note,
            )
        )
        + "</tr>"
        for item in bill_of_materials(spec, manifest)
    )
    text = "Prints are counted as solid: with infill they take less."
    return f"<table><tr>{head}</tr>{rows}</table><p class='note'>{text}</p>"
