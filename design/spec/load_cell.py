"""The load cell of the bench in a specification: what the sensors' board reads besides the sensors."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from design.spec.base import SpecPart

LoadCellKind = Literal["none", "hx711", "analog"]
PINS_OF_KIND = {"none": 0, "hx711": 2, "analog": 1}
"""Pins of the board that a load cell of each kind takes."""
_USUAL_SCALE_N = {"none": 1.0, "hx711": 49.03, "analog": 24.5}
"""Newtons per mV/V of a bridge of 5 kg at 1 mV/V, and per volt of the Vernier in its ±50 N range."""

SUPPLY_V = 5.0
"""Supply of an analog load cell, the largest voltage that it gives; without load it gives half of it."""


class LoadCellSpec(SpecPart):
    """A load cell that the firmware of `instobj bench firmware` reads, for presses by hand or by a machine.

    `kind` "hx711": a strain-gauge bridge on an HX711, gain 128, at 80 readings per second (its pin RATE);
    `scale_n` is the bridge's capacity over its output, N per mV/V (49.03 if left out). "analog": a
    force sensor with a voltage from 0 to 5 V, about half of it without load; `scale_n` is newtons per volt
    (24.5 if left out, the Vernier Dual-Range Force Sensor in its ±50 N range).
    `scale_n` is negative where pressing makes the reading smaller. `pins` of the board: data and clock,
    or the analogue input; left out, the board's usual ones.
    """

    kind: LoadCellKind = "none"
    pins: tuple[str, ...] | None = None
    scale_n: Annotated[float, Field(ge=-1e4, le=1e4)] | None = None

    @property
    def newtons_per_unit(self) -> float:
        """Return newtons per mV/V of a bridge, or per volt of an analog sensor."""
        return _USUAL_SCALE_N[self.kind] if self.scale_n is None else self.scale_n

    @model_validator(mode="after")
    def _can_be_read(self) -> LoadCellSpec:
        if self.scale_n == 0:
            raise ValueError("load_cell.scale_n must not be 0. Give the data sheet's figure")
        wanted = PINS_OF_KIND[self.kind]
        if self.pins is not None and len(self.pins) != wanted:
            raise ValueError(
                f"load_cell.pins names {len(self.pins)} pins; kind = {self.kind!r} takes {wanted} "
                "(hx711: data and clock; analog: the input). Fix the list, or leave it out"
            )
        return self
