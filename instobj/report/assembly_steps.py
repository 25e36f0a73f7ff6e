"""Steps at the workbench: what to do with the parts of an object, in order, with its own figures."""

from __future__ import annotations

from collections.abc import Collection

from design.build.amounts import SILICONE_WASTE, silicone_amount
from design.layout.boards import has_lid
from design.layout.body import body_of
from design.layout.core_hold import why_no_mould
from design.layout.mould.frame import mould_frame, mould_style, opening_of
from design.spec.object import ObjectSpec


def steps(spec: ObjectSpec, parts: Collection[str]) -> list[str]:
    """Return what to do, in order, with the figures of this object and the parts that were built."""
    first = ["Print all parts; remove strings and slivers, and see that the sliding parts move."]
    if spec.printer.preset.process == "resin" and spec.silicone.cure == "platinum":
        first.append(
            "Printed resin inhibits platinum silicone: wash, cure under UV, bake at 60 °C for hours "
            "and coat the mould; try a spoonful on a scrap first."
        )
    return [*first, *_casting_steps(spec), *_joining_steps(spec, parts)]


def _casting_steps(spec: ObjectSpec) -> list[str]:
    silicone, amount = spec.silicone, silicone_amount(spec)
    if silicone.cure == "none":
        return [f"Print the shell in {silicone.name}."]
    if why_no_mould(spec) is not None:
        return [f"No mould was built, so nothing can be cast: {why_no_mould(spec)}."]
    casting = silicone.casting
    pot = _duration_text(casting and casting.pot_life_min, "min")
    cure = _duration_text(casting and casting.cure_h, "h")
    return [
        *_core_first(spec),
        "Spray release agent thinly, on all that the silicone touches but the core"
        f"{_primed(spec)}. {_closed(spec)}",
        f"Weigh {amount.mixing} of {silicone.name} "
        f"({amount.mixed_g:.1f} g, with {SILICONE_WASTE:.0%} more than the object holds); "
        f"keep a part of it unmixed, for sealing. Mix the rest; pot life {pot}. "
        "Take the air out under vacuum.",
        _poured(spec),
        f"Let it cure: {cure} at room temperature, longer when cold. Then {_opened(spec)}",
    ]


def _duration_text(duration: float | None, unit: str) -> str:
    return "see the maker's sheet" if duration is None else f"{duration:g} {unit}"


def _primed(spec: ObjectSpec) -> str:
    """A core that is cast in must not come loose."""
    if opening_of(spec) == "open":
        return ""
    return ", which gets a thin coat of primer before it is closed in"


def _core_first(spec: ObjectSpec) -> list[str]:
    """A core that is cast in gets its electronics before."""
    if opening_of(spec) == "open":
        return []
    hold = {
        "bore": "Lead the wires out through its outlet and the rod's side, seat it on the rod's nose, flat "
        "on flat, and secure it there with a drop of hot glue.",
        "closed": "Coil the wires' ends in the middle of the core, deeper than the locating pins reach.",
    }[opening_of(spec)]
    if has_lid(spec):
        return [
            f"{_glued(spec)} Core means core_base and core_lid here: core.3mf is not printed.",
            "Lay the board and the charged battery into core_base, and lead the bay's wires out through the "
            "hole of a locating pin. Test every sensor again, then glue core_lid on, its rim in the bay.",
            "Fill the recesses flush with silicone, and all wire holes but the two of the locating pins; let "
            "it cure. Keep wires clear of these pins.",
        ]
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
        "core's holes"
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
        return "pull the plug straight out. Then fold the silicone walls inwards, off the mould's pegs."
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
    keys = (
        "The keys must snap into their recesses."
        if spec.core.keys.positions_mm
        else "The film of glue keeps it from slipping: where it sits decides the calibration."
    )
    held = opening_of(spec) != "open"
    put = (
        "Lay the shell on it, rim on rim, and weigh it down until the adhesive has set."
        if body_of(spec).on_base
        else f"Push it in, face 1 first, until it meets the cavity's end. {keys}"
    )
    core = f"Prime the core, let it dry, and spread a film of silicone adhesive on it. {put}"
    wires = (
        "Draw the wires out through the holes of the locating pins and fill these with silicone."
    )
    return [
        *([] if held else [_glued(spec)]),
        f"Set the {in_shell} on the floors of the shell's pockets, by {by} above.{_kinds(spec)}"
        f"{_bedded(spec)}",
        *_sealed(spec),
        *([] if held else [core]),
        *([wires] if opening_of(spec) == "closed" else []),
        "Read all sensors at rest and run `instobj bench selftest`: it finds flipped magnets and swapped "
        "channels.",
        "Put the object on its jig, align the jig's grooves with the machine, and calibrate."
        if "jig" in parts
        else "Hold the object in the machine so that its axes are known (it has no printed jig), and "
        "calibrate.",
    ]


def _bedded(spec: ObjectSpec) -> str:
    """Return how magnets are kept in open pockets (`estimator.field.seating` counts on it)."""
    if spec.arrangement == "sensors-in-shell":
        return ""
    poles = set(spec.magnets.polarities)
    one_pole = ", first those with north outward, then the others" if len(poles) > 1 else ""
    return (
        " Magnets push and pull each other out: bed each on a film of silicone and hold it down with a "
        f"wooden plug in its pocket until the film has cured, face by face{one_pole}."
    )


def _kinds(spec: ObjectSpec) -> str:
    """Return which of several kinds of magnets goes where."""
    kinds = spec.magnets.numbers_by_kind
    if len(kinds) == 1:
        return ""
    kinds_text = "; ".join(f"{_numbered(which)} {kind}" for kind, which in kinds.items())
    return f" Magnets of several kinds look alike: keep them apart. On every face: {kinds_text}."


def _numbered(which: tuple[int, ...]) -> str:
    """Magnets of a face, counted from 1, in words."""
    return f"magnet{'s' * (len(which) > 1)} {', '.join(str(k + 1) for k in which)}"


def _sealed(spec: ObjectSpec) -> list[str]:
    """Pockets filled one by one, or covered by a second pour that gives the body its size."""
    layer, frame = spec.shell.seal_layer_mm, mould_frame(spec)
    if not layer or spec.silicone.cure == "none":
        return ["Fill the pockets flush with silicone, face by face, and let each cure."]
    over = f"the layer of {layer:g} mm over all faces"
    first = "Brush silicone into the pockets until no air is left over the magnets."
    if frame.opening == "open" and frame.plugged:
        out = (
            " When it has cured pull the plug out. Then fold the walls inwards, off the fins of the slits."
            if spec.shell.slits.depth_mm
            else ""
        )
        return [f"{first} Put the shell on its plug into the seal box and pour {over}.{out}"]
    if frame.opening == "open":
        return [
            f"{first} Pour silicone {layer:g} mm deep into the seal box and press the shell in, pockets "
            f"down, until it is flush with the rim: this casts {over}."
        ]
    held = (
        "Seat it on the rod again, flat on flat, and clip the rod into the seal halves"
        if frame.opening == "bore"
        else "Close the seal halves round it and push the locating pins alone through them into the core"
    )
    drawn = "the rod" if frame.opening == "bore" else "the pins"
    return [
        f"{first} {held}; bolt them and pour {over}, as before.",
        f"When it has cured draw {drawn}, part the seal halves and cut the sprues flush.",
    ]


def has_template(parts: Collection[str]) -> bool:
    """Return whether a magnet template is among the names of the parts."""
    return any(name.startswith("magnet_template") for name in parts)
