"""The load cell of the bench in a specification: what the sensors' board reads besides the sensors."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from design.spec.base import SpecPart

LoadCellKind = Literal["none", "hx711", "analog"]
PINS_OF_KIND = {"none": 0, "hx711": 2, "analog": 1}
"""Pins of the board that a load cell of each kind takes."""


class LoadCellSpec(SpecPart):
    """A load cell that the firmware of `instobj bench firmware` reads, for presses by hand or by a machine.

    `kind` "hx711": a strain-gauge bridge on an HX711, gain 128, at `rate_sps` readings per second (its
    pin RATE); `capacity_n` and `output_mv_per_v` (at capacity) are the bridge's. "analog": a force
    sensor with a voltage from 0 to 5 V, `newtons_per_v` about `zero_v`; by default the Vernier
    Dual-Range Force Sensor in its ±50 N range. `output_mv_per_v` and `newtons_per_v` are negative
    where pressing makes the reading smaller. `pins` of the board: data and clock, or the analogue
    input; left out, the board's usual ones.
    """

    kind: LoadCellKind = "none"
    pins: tuple[str, ...] | None = None
    rate_sps: Literal[10, 80] = 80
    capacity_n: Annotated[float, Field(ge=0.1, le=1e4)] = 49.03
    output_mv_per_v: Annotated[float, Field(ge=-10, le=10)] = 1.0
    newtons_per_v: Annotated[float, Field(ge=-500, le=500)] = 24.5
    zero_v: Annotated[float, Field(ge=0, le=5)] = 2.5

    @model_validator(mode="after")
    def _can_be_read(self) -> LoadCellSpec:
        for key in ("output_mv_per_v", "newtons_per_v"):
            if getattr(self, key) == 0:
                raise ValueError(f"load_cell.{key} must not be 0. Give the data sheet's figure")
        wanted = PINS_OF_KIND[self.kind]
        if self.pins is not None and len(self.pins) != wanted:
            raise ValueError(
                f"load_cell.pins names {len(self.pins)} pins; kind = {self.kind!r} takes {wanted} "
                "(hx711: data and clock; analog: the input). Fix the list, or leave it out"
            )
        return self
