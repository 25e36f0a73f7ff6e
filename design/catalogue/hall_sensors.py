"""Hall sensors as their datasheets give them; all figures are typical."""

from __future__ import annotations

from dataclasses import dataclass

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
_TMAG5273_MEASURED = NoiseFigure(
    (22.0, 22.0, 11.0), 820.0, 16, "measured on the public recordings, ±40 mT, 16× averaging"
)


def _tmag5273(letter: str, version: int) -> HallPart:
    """Version 1 is the sensitive one; the letter names the I²C address. Only the A1 was measured."""
    if version == 1:
        measured = _TMAG5273_MEASURED if letter == "A" else None
        ranges = (SensorRange(40.0, 820.0), SensorRange(80.0, 410.0))
        noise_ut = (125.0, 125.0, 68.0)
    else:
        measured = None
        ranges = (SensorRange(133.0, 250.0), SensorRange(266.0, 125.0))
        noise_ut = (147.0, 147.0, 89.0)
    name = f"TMAG5273{letter}{version}"
    return HallPart(name, ranges, noise_ut, measured)


_MLX90393_RANGES = (
    SensorRange(4.9, 1e3 / 0.150),
    SensorRange(9.8, 1e3 / 0.300),
    SensorRange(24.6, 1e3 / 0.751),
    SensorRange(49.2, 1e3 / 1.502),
)
HALL_PARTS = {
    part.name: part
    for part in (
        _tmag5273("A", 1),
        _tmag5273("A", 2),
        HallPart("MLX90393", _MLX90393_RANGES),
        HallPart("MLX90393-0x18", _MLX90393_RANGES),
        *(_tmag5273(letter, version) for letter in "BCD" for version in (1, 2)),
        *(
            HallPart(f"TLE493DW2B6A{k}", (SensorRange(80.0, 15.4), SensorRange(160.0, 7.7)))
            for k in range(4)
        ),
        HallPart(GENERIC_PART),
    )
}
"""TMAG5273: Texas Instruments SLYS045, sections 5.7 and 5.8 (sensitivity; noise at 25 °C, one
conversion, low-power mode; that of 32 conversions, 22 and 11 µT, follows 1/√n). Its noise is the
Hall elements', so in µT it is taken as the same in both ranges of a part. Update rates of three axes
(the family's table of update rates: 10, 5.7, 3.1, 1.6, 0.8, 0.4 kHz at 1 to 32 conversions) are
those of 25 µs and three axes of 25 µs each a conversion.
MLX90393: Melexis 3901090393, sensitivity of X and Y at HALLCONF 0xC, resolution setting 0 with
gains 7, 4 and 0 (and setting 1 with gain 0); its Z steps are 1.6 times as wide and are taken as
rescaled to the counts of X and Y. Its noise and conversion time depend on filter and oversampling,
which `averaging` does not name, and are not listed.
TLE493D-W2B6: 12 bits, 7.7 counts/mT, twice that in its short range (Infineon's own driver); ±160 mT,
and taken as half in the short range. Its noise is not listed: give what you measured.
"""
_COARSE_COUNTS_PER_MT = 100.0
"""Parts with fewer are too coarse for small presses to be proposed for a wider range."""


def hall_part(name: str) -> HallPart:
    """The sensor of that part number.

    Raises
    ------
    InputError
        No such part.
    """
    if name not in HALL_PARTS:
        raise InputError(
            f"sensors.part = {name!r} is not a known part. Choose one of {', '.join(HALL_PARTS)}; "
            f"{GENERIC_PART!r} takes sensors.range_mt, counts_per_mt and noise_counts as you give them"
        )
    return HALL_PARTS[name]


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
