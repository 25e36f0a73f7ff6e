"""Solids of objects off their symmetries: a page that a person can judge."""

from design.layout.core_hold import locators
from design.layout.mould.frame import mould_frame
from design.layout.mould.pins import loose_pins
from design.mould.one_piece import make_mould_box, make_seal_mould
from design.mould.pins import fixed_bosses, make_pin, pin_holes
from design.mould.plug import make_mould_holder, make_mould_plug, rod_hole
from design.mould.plug_flange import flange_solids, tabs
from design.solids.body import cast_outer_solid, cavity_solid, core_hollow, core_solid, outer_solid
from design.solids.curved_template import make_curved_template
from design.solids.jig import make_jig
from design.solids.magnet_template import make_magnet_template
from design.solids.probes import make_probe
from design.solids.shell import locator_hole
from design.spec.mechanics import IndenterSpec
from tests.support.objects.worked_objects import WORKED_TIPS, worked
from tests.support.physics_pages import assert_page

BODIES = ("box", "box open at a side", "pad", "cylinder", "sleeve", "capsule", "sphere", "dome")


def sizes(solids):
    """Volume and area of some solids together, number of their faces."""
    return [
        sum(solid.Volume() for solid in solids),
        sum(solid.Area() for solid in solids),
        sum(len(solid.Faces()) for solid in solids),
    ]


def of_bodies():
    for name in BODIES:
        spec = worked(name)
        cavity = [solid for solid in [cavity_solid(spec, 0.6)] if solid is not None]
        parts = ([outer_solid(spec)], cavity, [core_solid(spec)], core_hollow(spec))
        volumes = [sizes(part)[0] for part in (*parts, [cast_outer_solid(spec)])]
        yield (
            f"{name}: outside, cavity, core, hollow, cast (mm³); its jig",
            [
                *volumes,
                *sizes([make_jig(spec)]),
            ],
        )


def of_tools():
    for name, tip in WORKED_TIPS.items():
        spec = worked("box").changed(indenter=IndenterSpec.model_validate(tip))
        yield f"probe, {name} (mm³, mm², faces)", sizes([make_probe(spec, spec.indenter.tip_count)])
    yield "template of a box", sizes([make_magnet_template(worked("box"), 5)])
    template = make_curved_template(worked("dome"), worked("dome").body.sensed[-1])
    yield "template of a dome", [template.volume, template.area]


def of_moulds():
    pad = worked("pad").changed(shell=worked("pad").shell.changed(seal_layer_mm=0.4))
    yield "pad: mould and seal mould", sizes([make_mould_box(pad), make_seal_mould(pad)])
    yield "dome: plug", sizes([make_mould_plug(worked("dome"))])
    for name in ("box", "box open at a side"):
        yield f"{name}: flange of the plug", sizes(flange_solids(worked(name)))
        yield f"{name}: tabs", sizes(tabs(worked(name)))
    for name in ("closed box", "capsule", "closed capsule"):
        spec = worked(name)
        pins = [pin for pin in loose_pins(spec) if pin.locator is not None] or loose_pins(spec)[1:2]
        holes = [locator_hole(locator) for locator in locators(spec)]
        yield (
            f"{name}: pin, its holes",
            [*sizes([make_pin(spec, pins[0])]), *sizes(pin_holes(spec, pins[0]))],
        )
        yield f"{name}: bosses, holes of pins", [*sizes(fixed_bosses(spec, 1)), *sizes(holes)]
        if mould_frame(spec).opening == "bore":
            rod = [*sizes([rod_hole(spec)]), *sizes([make_mould_holder(spec)])]
            yield f"{name}: rod's hole, holder", rod


def test_the_page_of_solids():
    assert_page("design/solids", [*of_bodies(), *of_tools(), *of_moulds()])
