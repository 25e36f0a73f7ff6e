"""Hall sensors as their datasheets give them; all figures are typical."""

from __future__ import annotations

from dataclasses import dataclass

from design.catalogue.tables import read_table
from design.errors import InputError

Triple = tuple[float, float, float]


@dataclass(frozen=True)
class SensorRange:
    """A selectable range of a sensor and its counts per mT there."""

    range_mt: float
    counts_per_mt: float


@dataclass(frozen=True)
class NoiseFigure:
    """White rms noise of X, Y, Z, in counts at that gain and that many conversions averaged."""

    counts: Triple
    counts_per_mt: float
    averaging: int
    source: str

    def scaled(self, counts_per_mt: float, averaging: int) -> Triple:
        """Noise (counts) at another gain and averaging: ∝ gain, ∝ 1/√n while it is white."""
        scale = counts_per_mt / self.counts_per_mt * (self.averaging / averaging) ** 0.5
        x, y, z = self.counts
        return (x * scale, y * scale, z * scale)


@dataclass(frozen=True)
class HallPart:
    """A three-axis Hall sensor: its ranges, narrowest first, and its noise where it is known.

    `datasheet_noise_ut` is the rms noise of X, Y, Z of one conversion, µT; `measured_noise` goes
    before it where there is one.
    """

    name: str
    ranges: tuple[SensorRange, ...] = ()
    datasheet_noise_ut: Triple | None = None
    measured_noise: NoiseFigure | None = None

    def range_covering(self, range_mt: float) -> SensorRange:
        """The narrowest of the part's ranges that holds ±`range_mt`.

        Raises
        ------
        InputError
            Beyond the part's widest range.
        """
        for selectable in self.ranges:
            if selectable.range_mt >= range_mt:
                return selectable
        listed = ", ".join(f"±{r.range_mt:g}" for r in self.ranges)
        raise InputError(
            f"sensors.range_mt = {range_mt:g} is beyond the ranges of {self.name} ({listed} mT). "
            "Choose one of them or another sensors.part, or give sensors.counts_per_mt too"
        )

    @property
    def noise(self) -> NoiseFigure | None:
        if self.measured_noise is not None or self.datasheet_noise_ut is None:
            return self.measured_noise
        return NoiseFigure(self.datasheet_noise_ut, 1e3, 1, "datasheet, one conversion")


GENERIC_PART = "generic"
HALL_PARTS = read_table(
    "hall_sensors",
    HallPart,
    "sensors.part",
    f"; {GENERIC_PART!r} takes sensors.range_mt, counts_per_mt and noise_counts as you give them",
)
_COARSE_COUNTS_PER_MT = 100.0
"""Parts with fewer are too coarse for small presses to be proposed for a wider range."""


def wider_range(
    part_name: str, range_mt: float, needed_mt: float
) -> tuple[HallPart, SensorRange] | None:
    """The narrowest listed range that holds `needed_mt` and exceeds `range_mt`, and its part.

    Ranges of the same part come before those of others.
    """
    fine = (p for p in HALL_PARTS.values() if p.name == part_name or is_fine(p))
    listed = [(part, r) for part in fine for r in part.ranges]
    enough = [pair for pair in listed if pair[1].range_mt > max(range_mt, needed_mt)]
    return min(enough, key=lambda pair: (pair[0].name != part_name, pair[1].range_mt), default=None)


def is_fine(part: HallPart) -> bool:
    return all(r.counts_per_mt >= _COARSE_COUNTS_PER_MT for r in part.ranges)
