"""Everything in a specification that must fit together."""

from __future__ import annotations

from typing import TYPE_CHECKING

from design.fit.box import check_box, check_box_presses, check_tips
from design.fit.curved import check_body, check_curved_presses
from design.fit.environment import check_environment
from design.fit.parts import check_mould, check_parts
from design.layout.body import body_of

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec


def require_fit(spec: ObjectSpec, table: bool = True) -> None:
    """Raise ValueError with what does not fit, what was given and how to fix it.

    Without `table`, whether the indenter can be pressed at every contact location is left open.
    """
    cuboid = body_of(spec).cuboid
    if cuboid:
        check_box(spec)
    else:
        check_body(spec)
    check_tips(spec)
    if table and cuboid:
        check_box_presses(spec)
    elif table:
        check_curved_presses(spec)
    check_environment(spec)
    check_parts(spec)
    check_mould(spec)
