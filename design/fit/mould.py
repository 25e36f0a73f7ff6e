"""Whether a mould of the wanted style can be made for the body."""

from __future__ import annotations

from typing import TYPE_CHECKING

from design.layout.mould_frame import opening_of

if TYPE_CHECKING:
    from design.spec.object import ObjectSpec


def check_mould(spec: ObjectSpec) -> None:
    """Raise ValueError with what cannot be moulded, what was given and how to mend it."""
    opening = opening_of(spec)
    if spec.mould.style == "one-piece" and opening != "open":
        raise ValueError(
            f'mould.style = "one-piece" needs a whole side of the body open; this {spec.body.kind} has '
            f'body.open_faces = {list(spec.body.opened)}. Use "split", or leave the style out'
        )
    if spec.shell.seal_layer_mm and opening == "closed":
        raise ValueError(
            f"shell.seal_layer_mm = {spec.shell.seal_layer_mm:g} is poured round the shell on its plug, "
            "and a closed body has none. Leave it out and fill the pockets, or open a face"
        )
