"""Words of `instobj bench rig` that hold several figures: the plan of presses, and a load cell's port."""

from __future__ import annotations

from collections.abc import Sequence
from math import isfinite
from typing import Any, NamedTuple

from design.errors import InputError


class PlanKey(NamedTuple):
    """Choice of `RigOptions` or field of `PressSettings` that a key of `--plan` sets, whole or not."""

    least: float
    whole: bool
    of_settings: bool
    meaning: str


PLAN_KEYS = {
    "depths_mm": PlanKey(0.0, False, True, "stops below the first touch, as 1,2"),
    # the slowest press still ends: 8 mm of shell take 160 s at 0.05 mm/s
    "speed_mm_s": PlanKey(0.05, False, True, "of presses"),
    "dwell_s": PlanKey(0.0, False, True, "at every stop"),
    "strokes": PlanKey(1, True, True, "load cycles per press"),
    "full_n": PlanKey(0.0, False, True, "force that ends a press"),
    "repeats": PlanKey(1, True, False, "presses per contact location"),
    "presses": PlanKey(1, True, False, "the first ones alone"),
    "reference_every": PlanKey(0, True, False, "presses between returns to the middle, 0: none"),
}
"""Key of `--plan` → its least value and what it sets; `PressSettings` and the specification bound it too."""


def plan_choices(words: Sequence[str]) -> dict[str, Any]:
    """Choices of `RigOptions` from `KEY=VALUE` words; keys that are left out keep their defaults.

    Raises
    ------
    InputError
        No such key, or no number within its bounds.
    """
    settings: dict[str, Any] = {}
    choices: dict[str, Any] = {}
    for word in words:
        name, _, text = word.partition("=")
        if name not in PLAN_KEYS:
            raise InputError(
                f"--plan {word}: {name!r} is no part of a plan. Give KEY=VALUE of {', '.join(PLAN_KEYS)}"
            )
        key = PLAN_KEYS[name]
        numbers = [_number(word, key, part) for part in text.split(",")]
        if name == "depths_mm":
            settings[name] = tuple(numbers)
        elif len(numbers) == 1:
            (settings if key.of_settings else choices)[name] = numbers[0]
        else:
            raise InputError(f"--plan {word}: {name} takes one number. Give it alone")
    return choices | {"settings": tuple(settings.items())}


def _number(word: str, key: PlanKey, text: str) -> float:
    kind = "whole number" if key.whole else "number"
    try:
        value = int(text) if key.whole else float(text)
    except ValueError:
        value = float("nan")
    if not (isfinite(value) and value >= key.least):
        raise InputError(f"--plan {word}: {text!r} is no {kind} of {key.least:g} or more. Give one")
    return value


def port_and_scale(port: str | None) -> tuple[str | None, float | None]:
    """Serial port and its newtons per unit, of `PORT[=SCALE]`; None: the port sends lines `L`.

    Raises
    ------
    InputError
        What follows the last = is no number, or 0.
    """
    name, equals, scale = (port or "").rpartition("=")
    if not equals:
        return port, None
    try:
        value = float(scale)
    except ValueError:
        value = 0.0
    if not (isfinite(value) and value):
        raise InputError(
            f"--load-port {port}: {scale!r} is no number of newtons per unit other than 0. Give "
            "PORT=SCALE, negative where pressing makes the number smaller"
        )
    return name, value
