"""Makers of the stages of fabrication: checks, order list, assembly sheet."""

from __future__ import annotations

from dataclasses import asdict
from pathlib import Path

from instobj.store.readers import (
    ASSEMBLY_SHEET,
    DEMOULDING,
    EXPLODED_VIEW,
    FINDINGS,
    FINDINGS_PICTURE,
    ORDERS,
)
from instobj.store.stage import StageContext, write_json


def make_fabrication(context: StageContext, folder: Path) -> None:
    """All findings, and a picture of the places where something did not pass."""
    from design.fabrication.check import check_fabrication
    from design.fabrication.finding import worst
    from instobj.render.findings import draw_findings

    checked = check_fabrication(context.spec, context.step)
    context.step("drawing the findings")
    draw_findings(
        checked.findings, checked.meshes, context.spec.name, FINDINGS_PICTURE.path(folder)
    )
    content = {
        "name": context.spec.name,
        "printer": context.spec.printer.name,
        "silicone": context.spec.silicone.name,
        "status": worst(checked.findings),
        "findings": [asdict(finding) for finding in checked.findings],
    }
    write_json(content, FINDINGS.path(folder))


def make_sheet(context: StageContext, folder: Path) -> None:
    """Parts to order and assembly sheet of a build."""
    from design.build.manifest import BuildManifest
    from design.build.order_list import order_list, write_orders
    from design.build.slicing import has_slicer, print_job
    from design.files import atomic_path
    from design.layout.core_hold import has_mould
    from design.layout.mould.frame import mould_style
    from design.layout.mould.pins import loose_pins, pins_by_kind
    from design.wiring.bus_plan import first_plan
    from instobj.render.demoulding import draw_demoulding
    from instobj.render.exploded_view import draw_exploded
    from instobj.report.assembly_sheet import assembly_sheet

    spec, parts = context.spec, context.inputs["build"]
    manifest = BuildManifest.read(parts)
    plan = first_plan(spec)
    orders = order_list(spec, plan)
    write_orders(orders, ORDERS.path(folder))
    split = has_mould(spec) and mould_style(spec) == "split"
    pins = pins_by_kind(spec) if split else []
    context.step("drawing the exploded view")
    picture = draw_exploded(spec, parts, EXPLODED_VIEW.path(folder))
    opening = None
    if has_mould(spec) and spec.silicone.cure != "none":
        context.step("drawing the order of demoulding")
        loose = loose_pins(spec) if split else ()
        opening = draw_demoulding(spec, parts, loose, DEMOULDING.path(folder))
    jobs = None
    if has_slicer():
        context.step("slicing the printed parts")
        sliced = {
            part.name: print_job(parts / f"{part.name}.3mf", spec.printer)
            for part in manifest.parts
            if part.printing is not None
        }
        jobs = {name: job for name, job in sliced.items() if job is not None}
    with atomic_path(ASSEMBLY_SHEET.path(folder)) as path:
        page = assembly_sheet(spec, manifest, picture, pins, plan, orders, opening, jobs)
        path.write_text(page, encoding="utf-8")
