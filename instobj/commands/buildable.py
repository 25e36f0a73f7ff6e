"""Buildability of a specification: checks of fabrication, solids and mould included."""

from __future__ import annotations

from design.errors import InputError
from design.fabrication.finding import Finding
from design.spec.object import ObjectSpec
from estimator.field.seating import why_unseated
from instobj.stages.run import Run
from instobj.store.readers import FINDINGS


def failed_checks(spec: ObjectSpec) -> dict[tuple[str, str], Finding]:
    """Return by part and check all that `instobj check --fabrication` fails; from the store, or made."""
    findings = [Finding.from_dict(row) for row in Run(spec).read(FINDINGS)["findings"]]
    return {
        (finding.part, finding.check): finding for finding in findings if finding.status == "fail"
    }


def require_makeable(spec: ObjectSpec) -> None:
    """Refuse an object that `check --fabrication` fails on, before any part of it is written.

    Raises
    ------
    InputError
        Which checks of fabrication failed, at what limits, and how to fix them.
    """
    failed = failed_checks(spec).values()
    if failed:
        listed = "".join(f"\n  - {finding.told}. {finding.what}" for finding in failed)
        raise InputError(f"{spec.name} is not built, as check --fabrication fails on it:{listed}")


def why_unbuildable(layout: ObjectSpec, start: ObjectSpec) -> str:
    """Return what fails in a layout and not in the start, which is what a search can answer for; or ""."""
    unseated = why_unseated(layout)
    if unseated and not why_unseated(start):
        return unseated
    new = failed_checks(layout)
    failed_before = failed_checks(start) if new else {}
    return "; ".join(finding.told for key, finding in new.items() if key not in failed_before)
