"""Parts of an object: how each is made, of what, how often."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Literal

from design.layout.boards import has_lid
from design.layout.body import body_of, face_frames
from design.layout.core_hold import has_mould
from design.layout.mould.frame import mould_frame, mould_style, opening_of
from design.layout.mould.pins import loose_pins, pin_kinds
from design.mould.halves import make_mould_half, make_seal_half
from design.mould.one_piece import make_mould_box, make_seal_mould
from design.mould.pins import make_pin
from design.mould.plug import make_mould_holder, make_mould_plug
from design.solids.booleans import TRIANGLES, exact_or_triangles
from design.solids.core import make_core, make_core_base, make_core_lid
from design.solids.curved_template import curved_template_faces, make_curved_template
from design.solids.jig import make_jig
from design.solids.kernel import cq
from design.solids.magnet_template import make_magnet_template, template_faces
from design.solids.probes import TIP_COUNTS, make_probe
from design.solids.sampled import sampled_core_part, sampled_shell
from design.solids.shell import make_shell
from design.spec.object import ObjectSpec

if TYPE_CHECKING:
    import trimesh

Material = Literal["printed", "silicone"]


@dataclass(frozen=True)
class Part:
    """A part by its name; `make` builds it, in the object's frame unless it is a tool.

    A body that is known by its triangles gives triangles wherever its surface is; all else is exact, but
    for what the exact kernel fails on, or whose triangles (`TRIANGLES`) it folds.
    """

    name: str
    builder: Callable[[], cq.Solid | trimesh.Trimesh]
    material: Material = "printed"
    count: int = 1

    def make(self) -> cq.Solid | trimesh.Trimesh:
        """The part's solid, or its triangles.

        Raises
        ------
        NotOneSolid
            An InputError: the dimensions do not give one closed body.
        """
        return exact_or_triangles(self.builder, TRIANGLES)


def parts_of(spec: ObjectSpec) -> tuple[Part, ...]:
    """Core, shell, mould, probes, jig and magnet templates, in the order of the manifest."""
    probes = [Part(f"probe_{tips}", partial(make_probe, spec, tips)) for tips in TIP_COUNTS]
    core, shell = (
        (sampled_core_part, sampled_shell) if body_of(spec).sampled else (make_core, make_shell)
    )
    return (
        Part("core", partial(core, spec)),
        *_halves_of_core(spec),
        Part("shell", partial(shell, spec), "silicone"),
        *_mould(spec),
        *probes,
        *_jig(spec),
        *_templates(spec),
    )


def _halves_of_core(spec: ObjectSpec) -> list[Part]:
    """Base and lid, printed in place of the core where a board and a battery are closed in."""
    if not has_lid(spec):
        return []
    return [
        Part("core_base", partial(make_core_base, spec)),
        Part("core_lid", partial(make_core_lid, spec)),
    ]


def _jig(spec: ObjectSpec) -> list[Part]:
    """None for a closed box, as the jig's post reaches into the core's cavity."""
    body = body_of(spec)
    if body.cuboid and 6 not in body.opened:
        return []
    return [Part("jig", partial(make_jig, spec))]


def _mould(spec: ObjectSpec) -> list[Part]:
    if not has_mould(spec):
        return []
    frame = mould_frame(spec)
    if mould_style(spec) == "one-piece":
        parts = [Part("mould_box", partial(make_mould_box, spec))]
    else:
        parts = [
            Part("mould_half_a", partial(make_mould_half, spec, 1)),
            Part("mould_half_b", partial(make_mould_half, spec, -1)),
            *_pins(spec),
        ]
    if frame.opening == "bore":
        parts.append(Part("mould_holder", partial(make_mould_holder, spec)))
    elif frame.plugged:
        parts.append(Part("mould_plug", partial(make_mould_plug, spec)))
    return parts + _seal_mould(spec)


def _seal_mould(spec: ObjectSpec) -> list[Part]:
    """Mould of the second pour: a box, or halves round a core that is cast in."""
    if not spec.shell.seal_layer_mm:
        return []
    if opening_of(spec) == "open":
        return [Part("mould_seal_box", partial(make_seal_mould, spec))]
    return [
        Part("mould_seal_half_a", partial(make_seal_half, spec, 1)),
        Part("mould_seal_half_b", partial(make_seal_half, spec, -1)),
    ]


def _pins(spec: ObjectSpec) -> list[Part]:
    """One part for every kind of pin, where it stands first."""
    pins = loose_pins(spec)
    return [
        Part(name, partial(make_pin, spec, pins[first]), count=count)
        for name, first, count in pin_kinds(pins)
    ]


def _templates(spec: ObjectSpec) -> list[Part]:
    """Templates to set magnets: plates for flat faces, sheets that hug curved ones."""
    flat = all(frame.flat for frame in face_frames(spec))
    groups, make = (
        (template_faces(spec), make_magnet_template)
        if flat
        else (curved_template_faces(spec), make_curved_template)
    )
    return [
        Part(
            "magnet_template" if len(groups) == 1 else f"magnet_template_face_{first}",
            partial(make, spec, first),
        )
        for first in groups
    ]
