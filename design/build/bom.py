"""Bill of materials: magnets, sensors, silicone with waste, prints, screws."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, fields
from pathlib import Path

from design.build.manifest import BuildManifest
from design.layout.boards import WIRE_DIAMETER_MM, has_lid
from design.layout.places.positions import sensor_layout, shell_body_layout
from design.layout.volumes import sealed_volume_mm3
from design.spec.object import ObjectSpec
from design.tables import write_table
from design.wiring.bus_plan import BusPlan

SILICONE_WASTE = 0.15
"""Share that is mixed beyond what the parts hold: what stays in the cup and on the mould, an estimate."""
SCREWS = 4
"""Through the flanges of a mould's halves."""


@dataclass(frozen=True)
class Item:
    """One line: how many, how much of it (volume and mass together), and what to know."""

    item: str
    count: int
    volume_cm3: float | None = None
    mass_g: float | None = None
    note: str = ""


@dataclass(frozen=True)
class SiliconeAmount:
    """Silicone in the object (shell, pockets filled, seal layer), and what is mixed for it."""

    volume_cm3: float
    mass_g: float
    mixed_g: float
    parts_g: tuple[float, float] | None

    @property
    def mixing(self) -> str:
        """Masses of both components, in words."""
        if self.parts_g is None:
            return "parts A and B as the maker says"
        return "{:.1f} g A + {:.1f} g B".format(*self.parts_g)


def silicone_amount(spec: ObjectSpec) -> SiliconeAmount:
    """Volume and mass of all silicone of one object, and both components with the waste."""
    bodies = shell_body_layout(spec)
    volume = (sealed_volume_mm3(spec) - float(bodies.volume_mm3.sum())) / 1e3
    mass = volume * spec.silicone.density_g_per_cm3
    mixed, casting = mass * (1 + SILICONE_WASTE), spec.silicone.casting
    if casting is None:
        return SiliconeAmount(volume, mass, mixed, None)
    a, b = casting.mix_ratio
    return SiliconeAmount(volume, mass, mixed, (mixed * a / (a + b), mixed * b / (a + b)))


def bill_of_materials(
    spec: ObjectSpec, manifest: BuildManifest, plan: BusPlan | None
) -> list[Item]:
    """Everything to buy, mix and print for one object; prints are counted as solid."""
    return [
        *_magnets(spec),
        *_electronics(spec, plan),
        _silicone(spec),
        *printed_items(spec, manifest),
        *_screws(spec, manifest),
    ]


def write_bom(items: list[Item], target: Path) -> None:
    """Write as CSV, one line an item; what does not apply is left empty.

    Raises
    ------
    InputError
        The folder cannot be written.
    """

    def line(item: Item) -> list[str]:
        amounts = (
            "" if amount is None else f"{amount:.3f}" for amount in (item.volume_cm3, item.mass_g)
        )
        return [item.item, str(item.count), *amounts, item.note]

    write_table(target, [field.name for field in fields(Item)], map(line, items))


def magnet_name(spec: ObjectSpec, first: int = 0) -> str:
    """A magnet as one would order it: a face's first, or that of another kind."""
    magnets = spec.magnets
    kind = f"{magnets.shape} magnet"
    grade = f" {magnets.grades[first]}" if magnets.grades else ""
    part = f"{magnets.parts[first]}, " if magnets.parts else ""
    return f"{part}{kind}{grade} {magnets.sizes[first].told}"


def _magnets(spec: ObjectSpec) -> list[Item]:
    magnets, faces = spec.magnets, len(spec.body.sensed)
    kinds, items = magnets.numbers_by_kind, []
    for which in kinds.values():
        remanences = [magnets.remanences_t[k] for k in which]
        remanence = " to ".join(
            f"{remanence_t:g}" for remanence_t in sorted({min(remanences), max(remanences)})
        )
        outward = faces * sum(magnets.polarities[k] > 0 for k in which)
        count = faces * len(which)
        note = (
            f"remanence {remanence} T; {outward} with north outward, {count - outward} inward"
            f"{'' if len(kinds) == 1 else f'; {numbered(which)} of every face'}"
        )
        items.append(Item(magnet_name(spec, which[0]), count, note=note))
    return items


def numbered(which: tuple[int, ...]) -> str:
    """Magnets of a face, counted from 1, in words."""
    return f"magnet{'s' * (len(which) > 1)} {', '.join(str(k + 1) for k in which)}"


def count_sensors(spec: ObjectSpec, plan: BusPlan | None) -> dict[str, int]:
    """Return how many of each sensor part to buy.

    A plan of the buses may take other orderable variants, which differ in their address; without one
    all are the specification's part.
    """
    if plan is None:
        return {spec.sensors.part: len(sensor_layout(spec).face)}
    return dict(sorted(Counter(chip.part for chip in plan.chips).items()))


def _electronics(spec: ObjectSpec, plan: BusPlan | None) -> list[Item]:
    parts, core = count_sensors(spec, plan), spec.core
    sensors = sum(parts.values())
    board = " × ".join(f"{edge:g}" for edge in spec.sensors.package_mm)
    return [
        *(
            Item(f"Hall sensor {part}", count, note=f"chip {spec.sensors.chip}")
            for part, count in parts.items()
        ),
        Item("sensor board", sensors, note=f"{board} mm"),
        Item(
            f"wire Ø{WIRE_DIAMETER_MM:g} mm",
            sensors * core.wires_per_sensor,
            note="from each board through its face's hole; shared supply and bus may save most",
        ),
    ]


def _silicone(spec: ObjectSpec) -> Item:
    amount = silicone_amount(spec)
    mixed = (
        "not cast"
        if spec.silicone.cure == "none"
        else f"mix {amount.mixed_g:.1f} g with {SILICONE_WASTE:.0%} of waste: {amount.mixing}"
    )
    return Item(spec.silicone.name, 1, amount.volume_cm3, amount.mass_g, mixed)


def printed_items(spec: ObjectSpec, manifest: BuildManifest) -> list[Item]:
    density = spec.printer.preset.density_g_per_cm3
    whole_core = {"core"} if has_lid(spec) else set()
    return [
        Item(
            f"print {part.name}",
            part.count,
            part.count * part.volume_mm3 / 1e3,
            part.count * part.volume_mm3 / 1e3 * density,
            f"{part.name}.3mf; " + " × ".join(f"{edge:.1f}" for edge in part.size_mm) + " mm each",
        )
        for part in manifest.parts
        if part.material == "printed" and part.name not in whole_core
    ]


def _screws(spec: ObjectSpec, manifest: BuildManifest) -> list[Item]:
    if "mould_half_a" not in {part.name for part in manifest.parts}:
        return []
    return [
        Item("M3 × 16 screw with nut", SCREWS, note="through the flanges of the mould's halves")
    ]
