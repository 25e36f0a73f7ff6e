"""Findings about chips, from the held magnet and from Earth's field."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from jaxtyping import Float, Int

from design.layout.places.positions import sensor_layout
from design.spec.object import ObjectSpec
from estimator.tolerances.selftest import sensor_names
from instobj.bench.bringup.diagnosis.earth import EARTH_UT, EarthFound
from instobj.bench.bringup.diagnosis.findings import HALF_95, ChipFound, Finding, channel_name

TURNED, GAIN, OFFSET = 6.0, 4.2, 5.0
"""Standard deviations beyond tolerance and measurement at which a finding is made."""
GAIN_TO_TELL, _SURELY = 0.1, 2.0
"""Gain of a whole chip that is found with this many standard deviations beyond those of the alarm."""
_EARTH_MISFIT = 3.0
"""Mean squared misfit, 1 expected, above which the room's field was not uniform or still."""


def chip_findings(
    spec: ObjectSpec, chips: Sequence[ChipFound], earth: EarthFound | None
) -> Iterator[Finding]:
    """Order, orientation, handedness, dead axes and gains."""
    names = sensor_names(sensor_layout(spec).face)
    yield from _order(chips, names)
    for chip, name in zip(chips, names, strict=True):
        if chip.mirrored:
            yield Finding("mirrored chip", name, f"it reads {axes_text(chip)}")
        elif is_turned(spec, chip):
            measured = f"by {chip.angle_deg:.0f}° from the drawing; it reads {axes_text(chip)}"
            yield Finding("turned chip", name, measured)
        if all(chip.dead):
            yield Finding("silent chip", name, "no answer of any axis to a magnet")
            continue
        for axis in np.flatnonzero(chip.dead):
            yield Finding("dead axis", channel_name(name, int(axis)), "no answer to a magnet")
    yield from _gains(spec, chips, earth, names)


def is_turned(spec: ObjectSpec, chip: ChipFound) -> bool:
    """Return whether a chip is turned beyond tolerance."""
    return chip.angle_deg > TURNED * max(spec.tolerances.sensor_rotation_deg, 1.0)


def _order(chips: Sequence[ChipFound], names: list[str]) -> Iterator[Finding]:
    """Every closed chain of exchanged chips once."""
    open_chips = {c for c, chip in enumerate(chips) if chip.site != c}
    while open_chips:
        chain = [min(open_chips)]
        while (after := chips[chain[-1]].site) != chain[0]:
            chain.append(after)
        open_chips -= set(chain)
        where = " and ".join(names[c] for c in chain)
        sits = ", ".join(f"{names[c]} sits at {names[chips[c].site]}" for c in chain)
        yield Finding("swapped chips", where, sits)


def axes_text(chip: ChipFound) -> str:
    """Return which designed axes its X, Y, Z lie along, as nearly as they do."""
    parts = []
    for row in chip.turn:
        k = int(np.argmax(abs(row)))
        parts.append(("−" if row[k] < 0 else "") + "XYZ"[k])
    return f"({', '.join(parts)}) for X, Y, Z"


def _gains(
    spec: ObjectSpec, chips: Sequence[ChipFound], earth: EarthFound | None, names: list[str]
) -> Iterator[Finding]:
    tolerance = _tolerance(spec)
    gain, sd = combined_gains(chips, earth)
    of_chip, chip_sd = findings_of_chips(chips, earth)
    for c, name in enumerate(names):
        axes = np.isfinite(gain[c]).sum()
        spread = np.hypot(tolerance / np.sqrt(max(axes, 1)), chip_sd[c])
        if abs(of_chip[c] - 1) > GAIN * spread:
            measured = f"{of_chip[c]:.3f} ± {HALF_95 * chip_sd[c]:.3f} of the others', all axes"
            yield Finding("gain", name, measured)
            continue
        for axis in np.flatnonzero(abs(gain[c] - 1) > GAIN * np.hypot(tolerance, sd[c])):
            measured = f"{gain[c, axis]:.3f} ± {HALF_95 * sd[c, axis]:.3f} of the others'"
            yield Finding("gain", channel_name(name, int(axis)), measured)


def _tolerance(spec: ObjectSpec) -> float:
    return float(np.hypot(spec.tolerances.sensor_gain_relative, spec.sensors.chip_spread[0]))


def widest_gain_sd(spec: ObjectSpec, axes: Int[np.ndarray, "chip"]) -> Float[np.ndarray, "chip"]:
    """Standard deviation of a chip's gain with which 1.1 is surely found, by its number of living axes.

    0 where tolerance alone hides it.
    """
    together = GAIN_TO_TELL / (GAIN + _SURELY)
    return np.sqrt(np.maximum(together**2 - _tolerance(spec) ** 2 / np.maximum(axes, 1), 0.0))


def wide_gains(spec: ObjectSpec, chips: Sequence[ChipFound], earth: EarthFound | None) -> list[str]:
    """Chips whose gain, holds and Earth's field together, is too uncertain to tell 1.1 surely."""
    sd, axes = (
        findings_of_chips(chips, earth)[1],
        np.sum([np.invert(c.dead) for c in chips], axis=1),
    )
    names = sensor_names(sensor_layout(spec).face)
    wide = sd > widest_gain_sd(spec, axes)
    return [name for name, is_wide in zip(names, wide, strict=True) if is_wide]


def combined_gains(
    chips: Sequence[ChipFound], earth: EarthFound | None
) -> tuple[Float[np.ndarray, "chip 3"], Float[np.ndarray, "chip 3"]]:
    """Gains of holds and of Earth's field by their precision, and standard deviations."""
    gain = np.stack([chip.gain for chip in chips])
    sd = np.stack([chip.gain_interval for chip in chips]) / HALF_95
    if earth is None:
        return gain, sd
    return _weighted(gain, sd, _relative(earth), earth.gain_interval / HALF_95)


def findings_of_chips(
    chips: Sequence[ChipFound], earth: EarthFound | None
) -> tuple[Float[np.ndarray, "chip"], Float[np.ndarray, "chip"]]:
    gain = np.array([chip.mean_gain for chip in chips])
    sd = np.array([chip.mean_gain_interval for chip in chips]) / HALF_95
    if earth is None:
        return gain, sd
    alive = np.isfinite(earth.gain)
    axes = np.maximum(alive.sum(axis=1), 1)
    mean = np.where(alive, _relative(earth), 0).sum(axis=1) / axes
    variance = np.where(alive, earth.gain_interval / HALF_95, 0) ** 2
    mean_sd = np.where(alive.any(axis=1), np.sqrt(variance.sum(axis=1)) / axes, np.nan)
    return _weighted(gain, sd, mean, mean_sd)


def _relative(earth: EarthFound) -> Float[np.ndarray, "chip 3"]:
    return earth.gain / np.nanmedian(earth.gain)


def _weighted(
    a: Float[np.ndarray, "*any"],
    a_sd: Float[np.ndarray, "*any"],
    b: Float[np.ndarray, "*any"],
    b_sd: Float[np.ndarray, "*any"],
) -> tuple[Float[np.ndarray, "*any"], Float[np.ndarray, "*any"]]:
    weight_a, weight_b = 1 / a_sd**2, 1 / b_sd**2
    total = weight_a + weight_b
    return (weight_a * a + weight_b * b) / total, 1 / np.sqrt(total)


def earth_findings(spec: ObjectSpec, earth: EarthFound) -> Iterator[Finding]:
    """Offsets beyond tolerance, and a field that is not Earth's."""
    names, scale = sensor_names(sensor_layout(spec).face), spec.sensors.counts_per_mt
    allowed = np.hypot(1e-3 * scale * spec.tolerances.sensor_offset_ut, spec.sensors.drift_counts)
    for c, a in np.argwhere(abs(earth.offset) > OFFSET * allowed):
        measured = f"{earth.offset[c, a]:+.0f} ± {earth.offset_interval[c, a]:.0f} counts"
        yield Finding("offset", channel_name(names[c], int(a)), measured)
    low, high = EARTH_UT
    slack = 1.5 * earth.field_interval_ut
    if not low - slack < earth.field_ut < high + slack or earth.misfit > _EARTH_MISFIT:
        measured = (
            f"{earth.field_ut:.0f} ± {earth.field_interval_ut:.0f} µT, Earth's is {low:g} to {high:g}; "
            f"misfit {earth.misfit:.1f}"
        )
        yield Finding("surroundings", "Earth's field", measured)
