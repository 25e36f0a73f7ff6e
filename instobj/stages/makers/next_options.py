"""Options to try next that the stored mechanics cannot score: forecast without a mesh."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from design.errors import InputError
from design.spec.object import ObjectSpec
from design.spec_io import check
from estimator.signals.presses import checked_rest_counts

if TYPE_CHECKING:
    from estimator.layouts.without_mesh import FirstScore

_HIGHER, _THINNER = 1.5, 0.75
"""Height of magnets and thickness of a shell over those of the design, as the next to try."""


def next_options(spec: ObjectSpec) -> list[str]:
    """Return options (`--set key=value`) that `instobj check` takes and forecasts no worse bounds for; none
    where nothing can be forecast."""
    if (now := _forecast(spec)) is None:
        return []
    return [*filter(None, (_higher_magnets(spec, now), _thinner_shell(spec, now)))]


def _higher_magnets(spec: ObjectSpec, now: FirstScore) -> str:
    """Return options for magnets half as high again; nothing where `instobj check` refuses them or forecasts
    worse bounds, or `magnets.part` says the height: options can leave out no key."""
    height_mm = spec.magnets.height_mm
    if isinstance(height_mm, tuple) or spec.magnets.part:
        return ""
    height_mm = round(_HIGHER * height_mm, 2)
    changed = _checked(spec, {"magnets": {"height_mm": height_mm}})
    if changed is None or not _no_worse(now, changed):
        return ""
    return f"--set magnets.height_mm={height_mm:g}"


def _thinner_shell(spec: ObjectSpec, now: FirstScore) -> str:
    """Return options for a shell a quarter thinner, pressed as deep as it allows; nothing where it cannot be
    pressed deep enough, or `instobj check` refuses it or forecasts worse bounds."""
    thickness_mm, depths_mm = round(_THINNER * spec.shell.thickness_mm, 2), spec.press.depths_mm
    option = f"--set shell.thickness_mm={thickness_mm:g}"
    # the deepest presses are left out one by one until the rest is taken; two depths are the fewest
    for count in range(len(depths_mm), 1, -1):
        kept = depths_mm[:count]
        tables = {"shell": {"thickness_mm": thickness_mm}, "press": {"depths_mm": kept}}
        changed = _checked(spec, tables)
        if changed is None:
            continue
        if not _no_worse(now, changed):
            return ""
        if count == len(depths_mm):
            return option
        return f"{option} --set press.depths_mm=[{','.join(f'{depth:g}' for depth in kept)}]"
    return ""


def _checked(spec: ObjectSpec, tables: dict[str, dict[str, Any]]) -> ObjectSpec | None:
    """Return a specification with some keys changed; None where `instobj check` refuses it."""
    try:
        changes = {name: getattr(spec, name).changed(**keys) for name, keys in tables.items()}
        changed = check(spec.changed(**changes))
        checked_rest_counts(changed)
    except ValueError:
        return None
    return changed


def _forecast(spec: ObjectSpec) -> FirstScore | None:
    """Return the forecast of `instobj check`; None where nothing can be forecast."""
    from estimator.layouts.without_mesh import first_score  # loads torch

    try:
        return first_score(spec)
    except InputError:
        return None


def _no_worse(now: FirstScore, changed: ObjectSpec) -> bool:
    """Return whether a changed specification has neither a larger median bound nor a larger 95th percentile
    than `now`, by its forecast; not where there is none."""
    after = _forecast(changed)
    if after is None:
        return False
    return after.median_mm <= now.median_mm and after.percentile_95_mm <= now.percentile_95_mm
