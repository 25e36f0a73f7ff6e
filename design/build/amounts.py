"""Amounts of a build: silicone with waste, and prints, by volume and mass."""

from __future__ import annotations

from dataclasses import dataclass

from design.build.manifest import BuildManifest
from design.layout.boards import has_lid
from design.layout.places.positions import shell_body_layout
from design.layout.volumes import sealed_volume_mm3
from design.spec.object import ObjectSpec

SILICONE_WASTE = 0.15
"""Share that is mixed beyond what the parts hold: what stays in the cup and on the mould, an estimate."""


@dataclass(frozen=True)
class Item:
    """Silicone or a print: how many, how much all of them hold and weigh, and what to know."""

    item: str
    count: int
    volume_cm3: float
    mass_g: float
    note: str


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


def silicone_item(spec: ObjectSpec) -> Item:
    """The silicone of one object, and what is mixed for it."""
    amount = silicone_amount(spec)
    mixed = (
        "not cast"
        if spec.silicone.cure == "none"
        else f"mix {amount.mixed_g:.1f} g with {SILICONE_WASTE:.0%} of waste: {amount.mixing}"
    )
    return Item(spec.silicone.name, 1, amount.volume_cm3, amount.mass_g, mixed)


def printed_items(spec: ObjectSpec, manifest: BuildManifest) -> list[Item]:
    """Every part that is printed, counted as solid; a core with a lid is printed in its two parts."""
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
