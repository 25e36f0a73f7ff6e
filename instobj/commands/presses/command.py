"""`instobj press`: one press or several with small strain, one with large strain, or a grasp."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from design.errors import InputError
from instobj.commands.presses.grasp import grasp_specification
from instobj.commands.presses.loads import press_loads
from instobj.commands.presses.places import places_given
from instobj.commands.presses.press import press_specification


@dataclass(frozen=True)
class PressOptions:
    """Options of `instobj press`.

    Attributes
    ----------
    at, jaws : contact locations `FACE:X,Y[,DEPTH]`; tips of two jaws, `FACE:X,Y[;X,Y]`
    force_n : of every press, or of each jaw
    material : "linear" for small strain, or a hyperelastic one, `NAME[:CONSTANTS]`
    """

    spec: Path
    at: tuple[str, ...]
    jaws: tuple[str, ...]
    force_n: float | None
    material: str
    out: Path
    overrides: tuple[str, ...]


def press_object(options: PressOptions) -> dict[str, Any]:
    """Press an object as the options say; results go below `runs/<name>/`.

    Raises
    ------
    InputError
        Options that exclude each other, a bad specification, or a place that cannot be pressed.
    """
    spec, out, overrides = options.spec, options.out, list(options.overrides)
    linear = options.material == "linear"
    if options.jaws:
        if options.at or not linear or options.force_n is None:
            raise InputError(
                "a grasp has two --jaw and --force, with small strain. Leave --at and --material out"
            )
        return grasp_specification(spec, list(options.jaws), options.force_n, out, overrides)
    places = places_given(options.at)
    if linear:
        return press_loads(spec, places, options.force_n, out, overrides)
    if len(places) > 1 or options.force_n is not None:
        raise InputError(
            "large strain presses one place to its depth. Give one --at, and leave --force out, or "
            "take --material linear"
        )
    return press_specification(spec, places[0], options.material, out, overrides)
