"""Fit of a whole specification: of everything that must find room together."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from design.fit.boards import check_boards
from design.fit.box import check_box, check_box_core, check_box_presses
from design.fit.curved import check_body, check_body_core, check_curved_presses
from design.fit.environment import check_environment
from design.fit.mould import check_mould
from design.fit.parts import check_mesh, check_parts
from design.fit.roughness import check_roughness
from design.layout.body import body_of
from design.spec.cached_geometry import cached_geometry

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec


def problems_of(spec: ObjectSpec, table: bool = True) -> list[str]:
    """All that does not fit, each with what was given and how to fix it; empty where everything fits.

    Without room for a core nothing else can be judged. Without `table`, whether the indenter can be
    pressed at every contact location is left open.
    """
    return [*_all_problems(spec)] if table else list(dict.fromkeys(_problems(spec, table)))


@cached_geometry
def _all_problems(spec: ObjectSpec) -> tuple[str, ...]:
    """Keep problems of a specification that several checks ask for."""
    return tuple(dict.fromkeys(_problems(spec, table=True)))


def fits(spec: ObjectSpec, table: bool = True, mould: bool = True) -> bool:
    """Return whether `problems_of` would find nothing; quicker where it would, as the first one decides.

    Without `mould`, which takes longest, that is left to `can_be_moulded`.
    """
    return next(_problems(spec, table, ways=False, mould=mould), None) is None


def can_be_moulded(spec: ObjectSpec) -> bool:
    """Return whether the mould of what fits otherwise has no problem either."""
    return next(check_mould(spec, ways=False), None) is None


def _problems(
    spec: ObjectSpec, table: bool, ways: bool = True, mould: bool = True
) -> Iterator[str]:
    try:
        core = [*(check_box_core if body_of(spec).cuboid else check_body_core)(spec)]
        yield from core or _but_mould(spec, table, ways)
        if mould and not core:
            yield from check_mould(spec, ways)
    except ValueError as error:  # no core lies that deep within the file's surface
        yield str(error)


def _but_mould(spec: ObjectSpec, table: bool, ways: bool) -> Iterator[str]:
    cuboid = body_of(spec).cuboid
    yield from check_box(spec) if cuboid else check_body(spec, ways)
    if table:
        yield from check_box_presses(spec) if cuboid else check_curved_presses(spec)
    yield from check_roughness(spec)
    yield from check_environment(spec)
    yield from check_parts(spec)
    yield from check_mesh(spec)
    yield from check_boards(spec)


def require_fit(spec: ObjectSpec, table: bool = True) -> None:
    """Raise ValueError with all that `problems_of` finds, a line each."""
    problems = problems_of(spec, table)
    if problems:
        raise ValueError("\n".join(problems))
